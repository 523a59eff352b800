// The collector: samples of single axes become one of all axes (seed, section 4.4.3). Use it `moderate`, so that it
// publishes once every axis has a new sample.
//
//   cca::node<"angles", cca::collector<"angles", leg_angles>, cca::moderate>      in "hip", "knee"; out "angles"
//
// The inputs' spaces are sub-spaces of the output's, and its origin is the oldest of theirs. Cost: none after inlining.
// Example: tests/runtime/skeleton/splitter_collector.cpp; docs/skeletons.md.
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

}  // namespace detail

template <fixed_string Output, class Space>
struct collector : detail::collector_of<Output, Space, typename Space::axes> {};

}  // namespace cca
