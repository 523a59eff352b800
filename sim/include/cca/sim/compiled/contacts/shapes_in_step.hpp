// Where the shapes of a described robot are in the middle of a step of a compiled world.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/around/box_form.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/probes.hpp>
#include <cca/sim/compiled/tree_step.hpp>

namespace cca::sim::detail {

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
  // Of a box.
  static box_form<Real> box(const step_type& step, const placed_shape& shape, const triple<Real>& middle) {
    const auto& size = shape.form.size;
    box_form<Real> form{{}, {Real(size[0] / 2), Real(size[1] / 2), Real(size[2] / 2)}};
    const auto turned = axes(step, shape);
    for (std::size_t k = 0; k < 3; ++k) form.frame.axes[k] = turned[k];
    form.frame.at = middle;
    return form;
  }
  // Of a capsule: from its middle to the centre of an end. Zero of a sphere.
  static triple<Real> half(const step_type& step, const placed_shape& shape) {
    if (shape.form.kind != robots::shape_kind::capsule) return {};
    return Real(shape.form.size[1] / 2) * axes(step, shape)[2];
  }
};

}  // namespace cca::sim::detail
