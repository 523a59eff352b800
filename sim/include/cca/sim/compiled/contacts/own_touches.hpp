// Where two shapes of a robot touch each other, in the middle of a step of a compiled world.
//
// A sphere or a capsule touches another one with their nearest points, a box as what stands around the robot
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
    const auto [here, there] = nearest_of_lines(from, shapes::half(step, a), to, shapes::half(step, b));
    const triple<Real> way = there - here;
    const Real apart = root(dot(way, way)), depth = radius + Real(a.form.size[0]) - apart;
    if (!(depth > Real(0.0)) || !(apart > Real(0.0))) return;
    const triple<Real> normal = (Real(1.0) / apart) * way;
    found(0, depth, there - radius * normal, normal);
  }
};

}  // namespace cca::sim::detail
