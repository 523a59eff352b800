// Position and motion of the links of a chain or a tree of joints: the functions behind the components.
//
//   const cca::chain_pose<arm> now(angles);      angles: Eigen vector over arm::axes, rad (prismatic: m)
//   now.tip()        position and orientation of the tip in the base of the chain
//   now.jacobian()   6 x coordinates: angular velocity (rad/s), then velocity (m/s) of the origin of the tip,
//                    along the axes of the base
//
// An angle that is NaN or infinite makes each link behind it not finite; nothing is kept.
// Everything has fixed size; nothing allocates. Cost: per joint a sine, a cosine and at most one product of
// two 3 x 3 matrices. Source: Siciliano, Sciavicco, Villani, Oriolo, Robotics: Modelling, Planning and
// Control, 2009, chapters 2 and 3 (geometric Jacobian). Checked against Orocos KDL on random trees, and
// against differences of positions.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/mapping/serial_chain.hpp>

namespace cca {

using matrix3 = Eigen::Matrix<double, 3, 3>;

// A frame in the base: its axes as columns, its origin in m.
struct rigid {
  matrix3 turn = matrix3::Identity();
  Eigen::Matrix<double, 3, 1> at = Eigen::Matrix<double, 3, 1>::Zero();

  // always_inline, here and below: a chain is constant, which is seen only where it is inlined
  // (docs/compilers.md).
  [[gnu::always_inline]] rigid operator*(const placement& p) const {
    return {math::product(turn, rotation::matrix(detail::as_vector(p.rotation))),
            math::product(turn, detail::as_vector(p.translation)) + at};
  }
};

namespace detail {

// Turns a rotation (axes as columns) about one of its own axes. For x, y or z only two columns change; else
// Rodrigues' formula.
inline void turn_about(matrix3& m, const body_link& l, double c, double s) {
  if (l.principal >= 0) {
    const int i = (l.principal + 1) % 3, j = (l.principal + 2) % 3;
    const vector3 a = m.col(i), b = m.col(j);
    m.col(i) = c * a + s * b;
    m.col(j) = c * b - s * a;
    return;
  }
  const double x = l.axis[0], y = l.axis[1], z = l.axis[2], v = 1 - c;
  matrix3 r;
  r << c + v * x * x, v * x * y - s * z, v * x * z + s * y,  //
      v * x * y + s * z, c + v * y * y, v * y * z - s * x,   //
      v * x * z - s * y, v * y * z + s * x, c + v * z * z;
  m = math::product(m, r);
}

inline void turn_about(matrix3& m, const body_link& l, double angle) {
  const auto by = math::sine_and_cosine(angle);
  turn_about(m, l, by.cosine, by.sine);
}

// A link in the base: its frame and the axis of its joint.
struct placed_link {
  rigid frame;
  vector3 axis;
};

// Cosine and sine of the angle of a revolute joint; the way of a prismatic one is in place of the cosine.
struct joint_turn {
  double cosine = 0, sine = 0;
};

// `turn_of(i)`: the joint_turn of joint i.
template <std::size_t Count, class TurnOf>
[[gnu::always_inline]] inline void place_turned_links(const std::array<body_link, Count>& links,
                                                      TurnOf turn_of,
                                                      std::array<placed_link, Count>& placed) {
  const rigid base;
  for (std::size_t i = 0; i < Count; ++i) {
    const body_link& l = links[i];
    const rigid& parent = l.parent < 0 ? base : placed[static_cast<std::size_t>(l.parent)].frame;
    rigid& frame = placed[i].frame;
    const joint_turn by = turn_of(i);
    frame.at = parent.at + math::product(parent.turn, as_vector(l.at));
    if (l.straight) frame.turn = parent.turn;
    else frame.turn = math::product(parent.turn, Eigen::Map<const matrix3>(l.turn.data()));
    if (l.principal >= 0) placed[i].axis = frame.turn.col(l.principal);
    else placed[i].axis = math::product(frame.turn, as_vector(l.axis));
    if (l.kind == joint_kind::revolute) turn_about(frame.turn, l, by.cosine, by.sine);
    else frame.at += by.cosine * placed[i].axis;
  }
}
template <std::size_t Count, class Coordinates>
[[gnu::always_inline]] inline void place_links(const std::array<body_link, Count>& links,
                                               const Coordinates& q,
                                               std::array<placed_link, Count>& placed) {
  place_turned_links(
      links,
      [&](std::size_t i) -> joint_turn {
        const double angle = links[i].ratio * q[links[i].coordinate] + links[i].rest;
        if (links[i].kind == joint_kind::prismatic) return {angle, 0};
        const auto by = math::sine_and_cosine(angle);
        return {by.cosine, by.sine};
      },
      placed);
}

// The geometric Jacobian of a point on the link `last`: a column per coordinate.
template <std::size_t Count, class Jacobian>
inline void fill_jacobian(const std::array<body_link, Count>& links,
                          const std::array<placed_link, Count>& placed,
                          int last,
                          const vector3& point,
                          Jacobian& jacobian) {
  jacobian.setZero();
  for (int i = last; i >= 0; i = links[static_cast<std::size_t>(i)].parent) {
    const body_link& l = links[static_cast<std::size_t>(i)];
    const placed_link& at = placed[static_cast<std::size_t>(i)];
    if (l.kind == joint_kind::revolute) {
      jacobian.col(l.coordinate).template head<3>() += l.ratio * at.axis;
      jacobian.col(l.coordinate).template tail<3>() +=
          l.ratio * rotation::cross<double>(at.axis, point - at.frame.at);
    } else {
      jacobian.col(l.coordinate).template tail<3>() += l.ratio * at.axis;
    }
  }
}

inline vector4 quaternion_of(const matrix3& m) { return rotation::from_matrix<double>(m); }

// Angles in the order of the chain's axes, from and to a space with these axes in any order.
template <class Wanted, class Space>
struct reordered;
template <class... Wanted, class Space>
struct reordered<axes<Wanted...>, Space> {
  static constexpr bool all = (Space::axes::template contains<Wanted> && ...);
  static constexpr std::array<int, sizeof...(Wanted)> index{Space::axes::template index_of<Wanted>...};

  template <class Vector>
  static auto from(const Vector& v) {
    Eigen::Matrix<double, sizeof...(Wanted), 1> q;
    for (int i = 0; i < static_cast<int>(sizeof...(Wanted)); ++i)
      q[i] = v[index[static_cast<std::size_t>(i)]];
    return q;
  }
  template <class Vector>
  static typename Space::vector_type to(const Vector& q) {
    typename Space::vector_type v = Space::vector_type::Zero();
    for (int i = 0; i < static_cast<int>(sizeof...(Wanted)); ++i)
      v[index[static_cast<std::size_t>(i)]] = q[i];
    return v;
  }
};

// The space has the axes of the chain and no others; the space has at least the axes of the chain.
template <class Chain, class Space> concept MovedBy =
    reordered<typename Chain::axes, Space>::all && Chain::axes::count == Space::axes::count;
template <class Chain, class Space> concept MovedWithin = reordered<typename Chain::axes, Space>::all;

}  // namespace detail

template <class Chain>
class chain_pose {
public:
  static constexpr int size = Chain::axes::count;
  static constexpr std::size_t count = Chain::joints.size();
  static_assert(
      detail::holds_or_tells<(detail::undriven_joint<Chain> < 0), detail::chain_without_axis<Chain>>::value);
  using vector_type = Eigen::Matrix<double, size, 1>;
  using jacobian_type = Eigen::Matrix<double, 6, size>;

  [[gnu::always_inline]] explicit chain_pose(const vector_type& q) {
    detail::place_links(detail::chain_links<Chain>, q, links);
  }

  // In the base: a link, and the tip.
  const rigid& link(std::size_t i) const { return links[i].frame; }
  rigid tip() const {
    if constexpr (count == 0) return rigid{} * Chain::tip;
    else return links[count - 1].frame * Chain::tip;
  }

  jacobian_type jacobian() const {
    jacobian_type j;
    detail::fill_jacobian(detail::chain_links<Chain>, links, static_cast<int>(count) - 1, tip().at, j);
    return j;
  }

private:
  std::array<detail::placed_link, count> links;
};
template <class Type>
  requires(!SerialChain<Type>)
class chain_pose<Type> : public chain_pose<detail::mended_chain<Type>> {
  static_assert(detail::holds_or_tells<false, detail::no_chain<Type>>::value);

public:
  using chain_pose<detail::mended_chain<Type>>::chain_pose;
};

}  // namespace cca
