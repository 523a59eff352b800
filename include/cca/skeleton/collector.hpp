// The collector: combines samples of single axes into one sample of all axes (the source document,
// section 4.4.3). Use it with `moderate`, so that it publishes once every axis has a new sample.
//
//   cca::node<"angles", cca::collector<"angles", leg_angles>, cca::moderate>
//   in  "hip", "knee"   one port per axis, with the axis's name: a sub-space of Space
//   out "angles"        Space, with the oldest of the inputs' origins
//
// Errors: skeleton.arity. Cost: none after inlining. Example: tests/runtime/skeleton/splitter_collector.cpp;
// docs/skeletons.md.
#pragma once

#include <cca/component/port.hpp>
#include <cca/skeleton/splitter.hpp>

namespace cca {

namespace detail {

template <fixed_string Output, class Space, class Axes>
struct collector_of;

template <fixed_string Output, class Space, class... Axes>
struct collector_of<Output, Space, axes<Axes...>> {
  static constexpr bool preserves_limits = true;

  auto process(in<port_name_of<Axes>, sub_space<Space, Axes>>... parts) -> out<Output, Space> {
    out<Output, Space> whole;
    ((whole[Axes{}] = parts[Axes{}]), ...);
    return whole;
  }
};

template <class Space>
struct not_collectable {
  static constexpr text message() {
    text t;
    t << "is to put " << type_name<Space>() << " together, which has " << Space::size << " numbers over "
      << Space::axes::count
      << " axes, so it is not made of one for each: collect what it is computed from, and compute it in a "
         "component";
    return t;
  }
};

}  // namespace detail

template <fixed_string Output, class Space>
struct collector : std::conditional_t<Space::size == Space::axes::count,
                                      detail::collector_of<Output, Space, typename Space::axes>,
                                      detail::bad_skeleton<detail::not_collectable<Space>>> {};

}  // namespace cca
