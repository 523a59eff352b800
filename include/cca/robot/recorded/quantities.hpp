// The recordings of a body's dynamics, each with its inputs and results.
//
// All begin with the joint values (placed_joints.hpp): cosines, then sines. Then come velocities,
// accelerations or torques over the coordinates, then the base.
#pragma once

#include <cca/base/recording/straight_line.hpp>
#include <cca/robot/recorded/composite_bodies.hpp>

namespace cca::detail {

// Beyond it loops over the links take over, without a try: recording takes the compiler too long.
inline constexpr int most_recorded_links = 16;

// For each coordinate, a bit for each one of which a NaN spreads to it: those before and behind its links on
// their branch; of `limbs`, all that hang together without the base.
template <std::size_t Count>
struct coordinate_sets {
  std::array<std::uint64_t, 64> branches{}, limbs{};
  std::uint64_t all = 0;

  constexpr explicit coordinate_sets(const reduced_body<Count>& b) {
    const auto bit = [&](std::size_t i) { return std::uint64_t{1} << b.links[i].coordinate; };
    std::array<std::uint64_t, Count> before{};
    for (std::size_t i = 0; i < Count; ++i) {
      const int p = b.links[i].parent;
      before[i] = bit(i) | (p < 0 ? 0 : before[static_cast<std::size_t>(p)]);
      all |= bit(i);
      branches[static_cast<std::size_t>(b.links[i].coordinate)] |= before[i];
      for (int j = p; j >= 0; j = b.links[static_cast<std::size_t>(j)].parent)
        branches[static_cast<std::size_t>(b.links[static_cast<std::size_t>(j)].coordinate)] |= bit(i);
    }
    limbs = branches;
    for (bool grew = true; grew;) {
      grew = false;
      for (std::size_t c = 0; c < 64 && all >> c != 0; ++c)
        for (std::size_t d = 0; d < 64 && all >> d != 0; ++d)
          if ((limbs[c] >> d & 1) != 0 && (limbs[d] & ~limbs[c]) != 0) limbs[c] |= limbs[d], grew = true;
    }
  }
};
template <class Body>
inline constexpr auto coordinate_sets_of = coordinate_sets(reduced_body_of<Body>);

// `Vectors` over the coordinates, then `Threes` of the base.
template <class Body, int Vectors, int Threes>
struct recorded_quantity {
  static constexpr int links = static_cast<int>(body_tree_of<Body>.links.size());
  static constexpr bool is_small = links > 0 && links <= most_recorded_links&& axes_of<Body>::count <= 64;
  static constexpr const auto& body = reduced_body_of<Body>;
  static constexpr int n = axes_of<Body>::count, values = body.value_count;
  static constexpr const auto& sets = coordinate_sets_of<Body>;
  static constexpr auto sizes = [] {
    std::array<int, std::size_t{1 + Vectors + Threes}> all{2 * values};
    for (int i = 0; i < Vectors; ++i) all[static_cast<std::size_t>(1 + i)] = n;
    for (int i = 0; i < Threes; ++i) all[static_cast<std::size_t>(1 + Vectors + i)] = 3;
    return all;
  }();

  static constexpr int group(int input) { return input < 2 * values ? input % values : input - values; }
  static constexpr int owner(int group) {
    if (group < values) return body.values[static_cast<std::size_t>(group)].coordinate;
    return group < values + Vectors * n ? (group - values) % n : -1;
  }
  static constexpr bool may_vanish(int group) {
    return group < values && !body.values[static_cast<std::size_t>(group)].revolute;
  }

  using vector = std::array<recorded, static_cast<std::size_t>(n)>;
  struct reader {
    recorder& r;
    int next = 2 * values;

    constexpr auto joints() const {
      std::array<recorded, static_cast<std::size_t>(2 * values)> v;
      for (int i = 0; i < 2 * values; ++i) v[static_cast<std::size_t>(i)] = r.input(i);
      return placed_joints<recorded>(body, v);
    }
    constexpr vector coordinates() {
      vector v;
      for (recorded& x : v) x = r.input(next++);
      return v;
    }
    constexpr triple<recorded> three() {
      triple<recorded> v;
      for (recorded& x : v.e) x = r.input(next++);
      return v;
    }
    // Of a base that moves: gravity, angular velocity, angular acceleration, acceleration.
    template <bool Moving>
    constexpr link_motion<recorded> base() {
      link_motion<recorded> root = standing();
      if (Moving) {
        const auto gravity = three();
        root.w = three(), root.dw = three(), root.a = three() - gravity;
      }
      return root;
    }
  };
  static constexpr void write(recorder& r, const vector& v, const std::array<std::uint64_t, 64>& owners) {
    for (std::size_t c = 0; c < v.size(); ++c) r.output(v[c], owners[c]);
  }
  static constexpr void write(recorder& r, const triple<recorded>& v) {
    for (const recorded& x : v.e) r.output(x, sets.all);
  }
  static constexpr link_motion<recorded> standing() {
    link_motion<recorded> root;
    root.a[2] = 9.81;
    return root;
  }
};

// Velocities, accelerations; gravity, angular velocity, angular acceleration, acceleration.
// Gives torques, then the wrench on the base.
template <class Body, bool Moving>
struct recorded_inverse_dynamics : recorded_quantity<Body, 2, Moving ? 4 : 0> {
  using q = recorded_quantity<Body, 2, Moving ? 4 : 0>;
  static constexpr std::array results{q::n, 3, 3};
  static constexpr void record(recorder& r) {
    typename q::reader in{r};
    const auto dq = in.coordinates(), ddq = in.coordinates();
    const auto root = in.template base<Moving>();
    typename q::vector torques{};
    const auto load = add_newton_euler(q::body, in.joints(), root, dq, ddq, torques);
    q::write(r, torques, q::sets.branches);
    q::write(r, load.moment);
    q::write(r, load.force);
  }
};

// Gravity, if it is not that of a base that stands; velocities, without gravity.
template <class Body, bool Given>
struct recorded_gravity_torques : recorded_quantity<Body, 0, Given ? 1 : 0> {
  using q = recorded_quantity<Body, 0, Given ? 1 : 0>;
  static constexpr std::array results{q::n};
  static constexpr void record(recorder& r) {
    typename q::reader in{r};
    link_motion<recorded> root = q::standing();
    if (Given) root.a = -1.0 * in.three();
    typename q::vector torques{};
    add_newton_euler(q::body, in.joints(), root, typename q::vector{}, typename q::vector{}, torques);
    q::write(r, torques, q::sets.branches);
  }
};
template <class Body>
struct recorded_coriolis_torques : recorded_quantity<Body, 1, 0> {
  using q = recorded_quantity<Body, 1, 0>;
  static constexpr std::array results{q::n};
  static constexpr void record(recorder& r) {
    typename q::reader in{r};
    const auto dq = in.coordinates();
    typename q::vector torques{};
    add_newton_euler(q::body, in.joints(), link_motion<recorded>{}, dq, typename q::vector{}, torques);
    q::write(r, torques, q::sets.branches);
  }
};

// Gives the matrix by columns.
template <class Body, bool Floating>
struct recorded_mass_matrix : recorded_quantity<Body, 0, 0> {
  using q = recorded_quantity<Body, 0, 0>;
  static constexpr std::array results{(q::n + (Floating ? 6 : 0)) * (q::n + (Floating ? 6 : 0))};
  static constexpr void record(recorder& r) {
    constexpr int first = Floating ? 6 : 0, size = first + q::n;
    square<recorded, size> m;
    add_mass_matrix<Floating>(q::body, typename q::reader{r}.joints(), m);
    for (int column = 0; column < size; ++column)
      for (int row = 0; row < size; ++row)
        r.output(m(row, column),
                 row < column ? owners(row - first, column - first) : owners(column - first, row - first));
  }
  // Row and column count from the first coordinate, and row <= column. The mass of all, and the zeros beside
  // its first moment, are constant.
  static constexpr std::uint64_t owners(int row, int column) {
    if (column < 0) return row < -3 && column - row != 3 ? q::sets.all : 0;
    const auto of_column = q::sets.branches[static_cast<std::size_t>(column)];
    if (row < 0) return of_column;
    return (of_column >> row & 1) != 0 ? of_column & q::sets.branches[static_cast<std::size_t>(row)] : 0;
  }
};

// Velocities, torques; gravity, angular velocity, angular acceleration, acceleration.
template <class Body, bool Moving>
struct recorded_forward_dynamics : recorded_quantity<Body, 2, Moving ? 4 : 0> {
  using q = recorded_quantity<Body, 2, Moving ? 4 : 0>;
  static constexpr std::array results{q::n};
  static constexpr void record(recorder& r) {
    typename q::reader in{r};
    const auto dq = in.coordinates(), torques = in.coordinates();
    const auto root = in.template base<Moving>();
    const auto joints = in.joints();
    typename q::vector x{};
    add_newton_euler(q::body, joints, root, dq, typename q::vector{}, x);
    for (std::size_t c = 0; c < x.size(); ++c) x[c] = torques[c] - x[c];
    square<recorded, q::n> m;
    add_mass_matrix<false>(q::body, joints, m);
    if (!solve(m, x, order_of_solution<false, q::n>(q::body))) r.is_full = true;
    q::write(r, x, q::sets.limbs);
  }
};

// Velocities, torques; angular velocity of the base, torque and force on it. Gives accelerations, then those
// of the base without gravity: angular, of its origin.
template <class Body>
struct recorded_floating_forward_dynamics : recorded_quantity<Body, 2, 3> {
  using q = recorded_quantity<Body, 2, 3>;
  static constexpr std::array results{q::n, 3, 3};
  static constexpr void record(recorder& r) {
    typename q::reader in{r};
    const auto dq = in.coordinates(), torques = in.coordinates();
    link_motion<recorded> root;
    root.w = in.three();
    const auto torque = in.three(), force = in.three();
    const auto joints = in.joints();
    typename q::vector bias{};
    const auto load = add_newton_euler(q::body, joints, root, dq, typename q::vector{}, bias);
    std::array<recorded, 6 + bias.size()> x;
    for (std::size_t k = 0; k < 3; ++k)
      x[k] = torque[k] - load.moment[k], x[3 + k] = force[k] - load.force[k];
    for (std::size_t c = 0; c < bias.size(); ++c) x[6 + c] = torques[c] - bias[c];
    square<recorded, 6 + q::n> m;
    add_mass_matrix<true>(q::body, joints, m);
    if (!solve(m, x, order_of_solution<true, 6 + q::n>(q::body))) r.is_full = true;
    for (std::size_t c = 0; c < bias.size(); ++c) r.output(x[6 + c], q::sets.all);
    for (std::size_t k = 0; k < 6; ++k) r.output(x[k], q::sets.all);
  }
};

}  // namespace cca::detail
