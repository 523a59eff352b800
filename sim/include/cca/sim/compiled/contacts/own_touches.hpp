// Where two shapes of a robot touch each other, in the middle of a step of a compiled world.
//
// A sphere or a capsule touches another one with their nearest points, two capsules also with both ends of
// what they have in common, so that they rest side by side; a box as what stands around the robot
// (box_form.hpp, box_on_box.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <cca/sim/compiled/around/box_on_box.hpp>
#include <cca/sim/compiled/around/nearest_of_lines.hpp>
#include <cca/sim/compiled/contacts/shapes_in_step.hpp>
#include <cca/sim/compiled/probes.hpp>

namespace cca::sim::detail {

// `touches(feature, depth, at, normal)`: the normal points into `b`; features come in ascending order. If
// only one of both is a box, that is `a`.
template <class Real, class F>
void touch_each_other(const shape_in_step<Real>& a, const shape_in_step<Real>& b, F touches) {
  using kind = robots::shape_kind;
  constexpr double side_by_side = 1e-3;  // of both radii, CHOSEN: as deep at the ends as between
  const triple<Real>&from = a.middle, &to = b.middle;
  const Real radius(b.radius());
  if (a.kind() == kind::box) {
    const box_form<Real> box = a.box();
    if (b.kind() == kind::box) return box_on_box<Real>(box, b.box()).touch(touches);
    if (b.kind() == kind::sphere) return box.touch_sphere(to, radius, touches);
    const triple<Real> half = b.half();
    return box.touch_capsule(to - half, to + half, radius, touches);
  }
  const triple<Real> half = a.half(), other_half = b.half();
  const Real zero(0.0), both = radius + Real(a.radius());
  const auto depth_of = [&](const nearest_points<Real>& p) {
    const triple<Real> way = p.there - p.here;
    return both - root(dot(way, way));
  };
  const auto touch = [&](int feature, const nearest_points<Real>& p, const Real& depth) {
    if (!(depth > zero)) return;
    const Real apart = both - depth;
    const triple<Real> normal =
        apart > zero ? (Real(1.0) / apart) * (p.there - p.here) : across_lines(half, other_half);
    touches(feature, depth, p.there - radius * normal, normal);
  };
  const nearest_points<Real> nearest = nearest_of_lines(from, half, to, other_half);
  const Real deepest = depth_of(nearest);
  if (!(deepest > zero)) return;
  if (a.kind() == kind::sphere || b.kind() == kind::sphere) return touch(0, nearest, deepest);
  const nearest_points<Real> last = last_of_lines(from, half, to, other_half),
                             first = last_of_lines(from, Real(-1.0) * half, to, other_half);
  const Real at_last = depth_of(last), at_first = depth_of(first), most = larger(at_last, at_first);
  touch(0, last, at_last), touch(1, first, at_first);
  // Side by side the place between them is anywhere.
  if (!(most > zero) || deepest > most + Real(side_by_side) * both) touch(2, nearest, deepest);
}

template <class R, class Real>
struct own_touches {
  using probes = probes_of<R>;
  using shapes = shapes_in_step<R, Real>;

  static constexpr std::size_t most_of_pair = 8;  // of two boxes
  // Of all pairs.
  static constexpr std::size_t most = [] {
    using kind = robots::shape_kind;
    std::size_t sum = 0;
    for (const auto& [first, second] : probes::own_pairs) {
      const kind a = probes::shapes[first].form.kind, b = probes::shapes[second].form.kind;
      sum += a == kind::sphere || b == kind::sphere ? 1 : a == kind::box && b == kind::box ? most_of_pair : 3;
    }
    return sum;
  }();

  // `touches(first, second, feature, depth, at, normal)`: shapes of the pair; the normal points into the
  // second one. In lanes a touch of some of them has no depth in the others.
  template <class F>
  static void find(const tree_step<R, Real>& step, std::size_t pair, F touches) {
    using kind = robots::shape_kind;
    std::size_t first = probes::own_pairs[pair][0], second = probes::own_pairs[pair][1];
    if (probes::shapes[first].form.kind != kind::box && probes::shapes[second].form.kind == kind::box)
      std::swap(first, second);
    const placed_shape &a = probes::shapes[first], &b = probes::shapes[second];
    const triple<Real> from = shapes::middle(step, a), to = shapes::middle(step, b), off = to - from;
    const Real far(probes::reach(a) + probes::reach(b)), apart = dot(off, off);
    const auto is_far = apart > far * far;
    if (everywhere(is_far)) return;
    const auto found = [&](int feature, const Real& depth, const triple<Real>& at,
                           const triple<Real>& normal) {
      touches(first, second, feature, depth, at, normal);
    };
    const shape_in_step<Real> one = shapes::of(step, a, from), other = shapes::of(step, b, to);
    if constexpr (is_in_lanes<Real>) find_in_lanes(one, other, select(is_far, Real(0.0), Real(1.0)), found);
    else touch_each_other(one, other, found);
  }

private:
  // Shapes touch in other ways in each lane, so each is looked at alone. `is_near`: 1 or 0.
  template <class F>
  static void find_in_lanes(const shape_in_step<Real>& one,
                            const shape_in_step<Real>& other,
                            const Real& is_near,
                            F found) {
    struct touch {
      Real depth;
      triple<Real> at, normal;
    };
    std::array<touch, most_of_pair> all;
    std::array<bool, most_of_pair> exists{};
    for (int k = 0; k < Real::count; ++k) {
      if (is_near[k] == 0) continue;
      touch_each_other(
          one.lane(k), other.lane(k),
          [&](int feature, double depth, const triple<double>& at, const triple<double>& normal) {
            touch& t = all[static_cast<std::size_t>(feature)];
            bool& is = exists[static_cast<std::size_t>(feature)];
            for (std::size_t r = 0; !is && r < 3; ++r) t.at[r] = Real(at[r]), t.normal[r] = Real(normal[r]);
            if (!is) t.depth = Real(-1.0);
            is = true;
            t.depth.set(k, depth);
            for (std::size_t r = 0; r < 3; ++r) t.at[r].set(k, at[r]), t.normal[r].set(k, normal[r]);
          });
    }
    for (std::size_t f = 0; f < all.size(); ++f)
      if (exists[f]) found(static_cast<int>(f), all[f].depth, all[f].at, all[f].normal);
  }
};

}  // namespace cca::sim::detail
