// The end of a part, its Jacobian and the centre of mass of a body as recordings, along the axes of the base.
//
// They begin with the joint values (placed_joints.hpp) and need nothing else. Sources: kinematics.hpp.
#pragma once

#include <cca/robot/recorded/quantities.hpp>

namespace cca::detail {

// A frame in the base: its axes and its origin.
template <class S>
struct placed_frame {
  triple<S> axes[3]{{{1.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}}, {{0.0, 0.0, 1.0}}};
  triple<S> at{};

  constexpr triple<S> direction(const triple<S>& v) const {
    return v[0] * axes[0] + v[1] * axes[1] + v[2] * axes[2];
  }
  constexpr placed_frame turned_by(const constant33& m) const {
    placed_frame f = *this;
    for (std::size_t c = 0; c < 3; ++c) f.axes[c] = direction({m[3 * c], m[3 * c + 1], m[3 * c + 2]});
    return f;
  }
  constexpr placed_frame behind(const placed_joint<S>& j) const {
    placed_frame f = j.link->straight ? *this : turned_by(j.link->turn);
    f.at = at + direction(j.at);
    if (!j.link->revolute) return f;
    const std::size_t x = (j.link->axis + 1) % 3, y = (j.link->axis + 2) % 3;
    const triple<S> a = f.axes[x], b = f.axes[y];
    f.axes[x] = j.cosine * a + j.sine * b;
    f.axes[y] = j.cosine * b - j.sine * a;
    return f;
  }
};

// Frames of all links on the way to `last`; the others stay empty.
template <class S, std::size_t Count>
constexpr std::array<placed_frame<S>, Count> placed_frames(const reduced_body<Count>& b,
                                                           const std::array<placed_joint<S>, Count>& joints,
                                                           const std::array<bool, Count>& wanted) {
  std::array<placed_frame<S>, Count> frames;
  for (std::size_t i = 0; i < Count; ++i)
    if (wanted[i]) {
      const int p = b.links[i].parent;
      frames[i] = (p < 0 ? placed_frame<S>() : frames[static_cast<std::size_t>(p)]).behind(joints[i]);
    }
  return frames;
}

// Part: its index.
template <class Body, std::size_t Part>
struct recorded_end : recorded_quantity<Body, 0, 0> {
  using q = recorded_quantity<Body, 0, 0>;
  static constexpr part_end end = body_tree_of<Body>.ends[Part];
  static constexpr auto on_the_way = [] {
    std::array<bool, static_cast<std::size_t>(q::links)> all{};
    for (int i = end.link; i >= 0; i = q::body.links[static_cast<std::size_t>(i)].parent)
      all[static_cast<std::size_t>(i)] = true;
    return all;
  }();
  static constexpr int length = [] {
    int sum = 0;
    for (const bool is_on : on_the_way) sum += is_on;
    return sum;
  }();
  static constexpr bool is_small = length > 0 && length <= most_recorded_links&& q::n <= 64;
  // The coordinates on the way, before a link or to the end.
  static constexpr std::uint64_t owners(int last) {
    std::uint64_t all = 0;
    for (int i = last; i >= 0; i = q::body.links[static_cast<std::size_t>(i)].parent)
      all |= std::uint64_t{1} << q::body.links[static_cast<std::size_t>(i)].coordinate;
    return all;
  }

  // Of the part in the frame of its last link here.
  static constexpr constant33 turn =
      product(transposed(q::body.own[static_cast<std::size_t>(end.link)]), matrix_of(end.where.rotation));
  static constexpr constant3 offset = [] {
    constant3 v = end.where.translation;
    for (std::size_t k = 0; k < 3; ++k) v[k] -= q::body.shift[static_cast<std::size_t>(end.link)][k];
    return cleaned(product(transposed(q::body.own[static_cast<std::size_t>(end.link)]), v));
  }();
  static constexpr triple<recorded> point(const placed_frame<recorded>& last) {
    return last.at + last.direction({offset[0], offset[1], offset[2]});
  }
};

// Gives the axes, then the origin.
template <class Body, std::size_t Part>
struct recorded_tip : recorded_end<Body, Part> {
  using e = recorded_end<Body, Part>;
  static constexpr std::array results{9, 3};
  static constexpr void record(recorder& r) {
    const auto frames = placed_frames(e::body, typename e::reader{r}.joints(), e::on_the_way);
    const auto& last = frames[static_cast<std::size_t>(e::end.link)];
    for (const auto& axis : last.turned_by(cleaned(e::turn)).axes)
      for (const recorded& x : axis.e) r.output(x, e::owners(e::end.link));
    for (const recorded& x : e::point(last).e) r.output(x, e::owners(e::end.link));
  }
};

// Gives 6 x n by columns.
template <class Body, std::size_t Part>
struct recorded_jacobian : recorded_end<Body, Part> {
  using e = recorded_end<Body, Part>;
  static constexpr std::array results{6 * e::n};
  static constexpr void record(recorder& r) {
    struct entry {
      recorded value;
      std::uint64_t owners = 0;
      constexpr void add(const recorded& x, std::uint64_t of_x) { value = value + x, owners |= of_x; }
    };
    std::array<entry, static_cast<std::size_t>(6 * e::n)> j{};
    const auto frames = placed_frames(e::body, typename e::reader{r}.joints(), e::on_the_way);
    const auto point = e::point(frames[static_cast<std::size_t>(e::end.link)]);
    for (int i = e::end.link; i >= 0;) {
      const reduced_link& l = e::body.links[static_cast<std::size_t>(i)];
      const auto& frame = frames[static_cast<std::size_t>(i)];
      const triple<recorded> axis = recorded(l.ratio) * frame.axes[l.axis];
      const triple<recorded> turned = cross(axis, point - frame.at);
      const auto before = e::owners(l.parent), whole = e::owners(e::end.link);
      for (std::size_t k = 0; k < 3; ++k) {
        entry* column = &j[static_cast<std::size_t>(6 * l.coordinate)];
        if (l.revolute) column[k].add(axis[k], before), column[3 + k].add(turned[k], whole);
        else column[3 + k].add(axis[k], before);
      }
      i = l.parent;
    }
    for (const entry& x : j) r.output(x.value, x.owners);
  }
};

template <class Body>
struct recorded_centre_of_mass : recorded_quantity<Body, 0, 0> {
  using q = recorded_quantity<Body, 0, 0>;
  static constexpr std::array results{3};
  static constexpr double mass = [] {
    double sum = q::body.base.mass;
    for (const auto& l : q::body.links) sum += l.mass.mass;
    return sum;
  }();
  static constexpr void record(recorder& r) {
    std::array<bool, static_cast<std::size_t>(q::links)> all{};
    for (bool& is_wanted : all) is_wanted = true;
    const auto frames = placed_frames(q::body, typename q::reader{r}.joints(), all);
    triple<recorded> moment{q::body.base.first[0], q::body.base.first[1], q::body.base.first[2]};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const mass_moments& m = q::body.links[i].mass;
      moment = moment + recorded(m.mass) * frames[i].at +
               frames[i].direction({m.first[0], m.first[1], m.first[2]});
    }
    for (const recorded& x : moment.e) r.output(recorded(mass > 0 ? 1 / mass : 0) * x, q::sets.all);
  }
};

}  // namespace cca::detail
