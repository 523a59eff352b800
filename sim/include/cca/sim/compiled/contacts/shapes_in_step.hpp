// Where the shapes of a described robot are in the middle of a step of a compiled world.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/around/box_form.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/probes.hpp>
#include <cca/sim/compiled/tree_step.hpp>

namespace cca::sim::detail {

// One of them, in the world.
template <class Real>
struct shape_in_step {
  const placed_shape* shape = nullptr;
  triple<Real> middle{};
  std::array<triple<Real>, 3> axes{};  // not of a sphere

  robots::shape_kind kind() const { return shape->form.kind; }
  // Of a sphere or a capsule.
  double radius() const { return shape->form.size[0]; }
  // Of a box.
  box_form<Real> box() const {
    const auto& size = shape->form.size;
    box_form<Real> form{{}, {Real(size[0] / 2), Real(size[1] / 2), Real(size[2] / 2)}};
    for (std::size_t k = 0; k < 3; ++k) form.frame.axes[k] = axes[k];
    form.frame.at = middle;
    return form;
  }
  // Of a capsule: from its middle to the centre of an end. Zero of a sphere.
  triple<Real> half() const {
    if (kind() != robots::shape_kind::capsule) return {};
    return Real(shape->form.size[1] / 2) * axes[2];
  }
  // Where it is in one lane.
  shape_in_step<double> lane(int k) const
    requires is_in_lanes<Real>
  {
    return {shape, lane_of(middle, k), {lane_of(axes[0], k), lane_of(axes[1], k), lane_of(axes[2], k)}};
  }
};

template <class R, class Real>
struct shapes_in_step {
  using tree = compiled_tree<R>;
  using step_type = tree_step<R, Real>;

  static triple<Real> middle(const step_type& step, const placed_shape& shape) {
    return step.base.at + step.base.direction(on_links<R, Real>::point(
                              step.now.places(), shape.link, tree::point({shape.link, shape.where})));
  }
  static std::array<triple<Real>, 3> axes(const step_type& step, const placed_shape& shape) {
    const auto in_base = on_links<R, Real>::end_frame(step.now.places(), {shape.link, shape.where});
    std::array<triple<Real>, 3> all;
    for (std::size_t k = 0; k < 3; ++k) all[k] = step.base.direction(in_base.axes[k]);
    return all;
  }
  // `middle`: of the shape.
  static shape_in_step<Real> of(const step_type& step,
                                const placed_shape& shape,
                                const triple<Real>& middle) {
    shape_in_step<Real> s{&shape, middle, {}};
    if (shape.form.kind != robots::shape_kind::sphere) s.axes = axes(step, shape);
    return s;
  }
};

}  // namespace cca::sim::detail
