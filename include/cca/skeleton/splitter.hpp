// The splitter: one sample of many axes becomes a sample of each axis (seed, section 4.4.3).
//
//   cca::splitter<"angles", leg_angles>      in "angles"; out "hip", "knee": one port an axis, under its name
//
// The outputs' spaces are sub-spaces of the input's, so each keeps within the limits of its axis. Taken
// together again by a collector they are the same, to the bit. Needs a domain type with one number an axis.
// Errors: skeleton.arity. Cost: none after inlining.
// Example: tests/runtime/skeleton/splitter_collector.cpp; docs/skeletons.md.
#pragma once

#include <tuple>
#include <type_traits>

#include <cca/component/port.hpp>
#include <cca/skeleton/arity.hpp>
#include <cca/base/type_name.hpp>

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

template <class Space>
struct not_per_axis {
  static constexpr text told() {
    text t;
    t << "is to take " << type_name<Space>() << " apart, which has " << Space::size << " numbers over "
      << Space::axes::count
      << " axes, so none of them belongs to one axis: take a space with a number for each, the roll, pitch "
         "and yaw of an orientation say";
    return t;
  }
};

}  // namespace detail

template <fixed_string Input, class Space>
struct splitter : std::conditional_t<Space::size == Space::axes::count,
                                     detail::splitter_of<Input, Space, typename Space::axes>,
                                     detail::uneven<detail::not_per_axis<Space>>> {};

}  // namespace cca
