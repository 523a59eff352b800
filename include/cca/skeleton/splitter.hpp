// The splitter: one sample of many axes becomes a sample of each axis (seed, section 4.4.3).
//
//   cca::splitter<"angles", leg_angles>      in "angles"; out "hip", "knee": one port an axis, under its name
//
// The outputs' spaces are sub-spaces of the input's, so each keeps within the limits of its axis. Taken together again by a
// collector they are the same, to the bit. Needs a domain type with one number an axis. Cost: none after inlining.
// Example: tests/runtime/skeleton/splitter_collector.cpp; docs/skeletons.md.
#pragma once

#include <tuple>

#include <cca/component/port.hpp>

namespace cca {

namespace detail {

// The name of an axis, as the name of a port.
template <class Axis>
inline constexpr auto port_name_of = Axis::label;

template <fixed_string Input, class Space, class Axes>
struct splitter_of;

template <fixed_string Input, class Space, class... Axes>
struct splitter_of<Input, Space, axes<Axes...>> {
  static constexpr bool preserves_limits = true;

  auto process(in<Input, Space> whole) -> std::tuple<out<port_name_of<Axes>, sub_space<Space, Axes>>...> {
    return {out<port_name_of<Axes>, sub_space<Space, Axes>>(whole[Axes{}])...};
  }
};

}  // namespace detail

template <fixed_string Input, class Space>
struct splitter : detail::splitter_of<Input, Space, typename Space::axes> {};

}  // namespace cca
