// Where two shapes of a robot touch each other, in the middle of a step of a compiled world.
//
// A sphere or a capsule touches another one with their nearest points, two capsules also with both ends of
// what they have in common, so that they rest side by side; a box as what stands around the robot
// (box_form.hpp, box_on_box.hpp).
#pragma once

#include <cstddef>
#include <utility>

#include <cca/sim/compiled/around/box_on_box.hpp>
#include <cca/sim/compiled/around/nearest_of_lines.hpp>
#include <cca/sim/compiled/contacts/shapes_in_step.hpp>
#include <cca/sim/compiled/probes.hpp>

namespace cca::sim::detail {

template <class R, class Real>
struct own_touches {
  using probes = probes_of<R>;
  using shapes = shapes_in_step<R, Real>;

  static constexpr double side_by_side = 1e-3;  // of both radii, CHOSEN: as deep at the ends as between

  // `touches(first, second, feature, depth, at, normal)`: shapes of the pair; the normal points into the
  // second one. If only one of them is a box, that is the first one.
  template <class F>
  static void find(const tree_step<R, Real>& step, std::size_t pair, F touches) {
    using kind = robots::shape_kind;
    std::size_t first = probes::own_pairs[pair][0], second = probes::own_pairs[pair][1];
    if (probes::shapes[first].form.kind != kind::box && probes::shapes[second].form.kind == kind::box)
      std::swap(first, second);
    const placed_shape &a = probes::shapes[first], &b = probes::shapes[second];
    const triple<Real> from = shapes::middle(step, a), to = shapes::middle(step, b), off = to - from;
    const Real far(probes::reach(a) + probes::reach(b)), radius(b.form.size[0]);
    if (dot(off, off) > far * far) return;
    const auto found = [&](int feature, const Real& depth, const triple<Real>& at,
                           const triple<Real>& normal) {
      touches(first, second, feature, depth, at, normal);
    };
    if (a.form.kind == kind::box) {
      const box_form<Real> box = shapes::box(step, a, from);
      if (b.form.kind == kind::box) return box_on_box<Real>(box, shapes::box(step, b, to)).touch(found);
      if (b.form.kind == kind::sphere) return box.touch_sphere(to, radius, found);
      const triple<Real> half = shapes::half(step, b);
      return box.touch_capsule(to - half, to + half, radius, found);
    }
    const triple<Real> half = shapes::half(step, a), other_half = shapes::half(step, b);
    const Real zero(0.0), both = radius + Real(a.form.size[0]);
    const auto depth_of = [&](const nearest_points<Real>& p) {
      const triple<Real> way = p.there - p.here;
      return both - root(dot(way, way));
    };
    const auto touch = [&](int feature, const nearest_points<Real>& p, const Real& depth) {
      if (!(depth > zero)) return;
      const Real apart = both - depth;
      const triple<Real> normal =
          apart > zero ? (Real(1.0) / apart) * (p.there - p.here) : across_lines(half, other_half);
      found(feature, depth, p.there - radius * normal, normal);
    };
    const nearest_points<Real> nearest = nearest_of_lines(from, half, to, other_half);
    const Real deepest = depth_of(nearest);
    if (!(deepest > zero)) return;
    if (a.form.kind == kind::sphere || b.form.kind == kind::sphere) return touch(0, nearest, deepest);
    const nearest_points<Real> last = last_of_lines(from, half, to, other_half),
                               first_one = last_of_lines(from, Real(-1.0) * half, to, other_half);
    const Real at_last = depth_of(last), at_first = depth_of(first_one), most = larger(at_last, at_first);
    touch(1, last, at_last), touch(2, first_one, at_first);
    // Side by side the place between them is anywhere.
    if (!(most > zero) || deepest > most + Real(side_by_side) * both) touch(0, nearest, deepest);
  }
};

}  // namespace cca::sim::detail
