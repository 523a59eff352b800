// The splitter: divides one sample of many axes into a sample per axis (the source document, section 4.4.3).
//
//   cca::splitter<"angles", leg_angles>
//   in  "angles"        Space
//   out "hip", "knee"   one port per axis, with the axis's name: a sub-space of Space
//
// Each output keeps within the limits of its axis. A collector puts the outputs together again, the same to
// the bit. Needs a domain type with one number per axis. Errors: skeleton.arity. Cost: none after inlining.
// Example: tests/runtime/skeleton/splitter_collector.cpp; docs/skeletons.md.
#pragma once

#include <tuple>
#include <type_traits>

#include <cca/component/port.hpp>
#include <cca/skeleton/arity.hpp>
#include <cca/base/type_name.hpp>

namespace cca {

namespace detail {

// The port of an axis has the axis's name.
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
struct not_splittable {
  static constexpr text message() {
    text t;
    t << "is to take " << type_name<Space>() << " apart, which has " << Space::size << " numbers over "
      << Space::axes::count
      << " axes, so none of them belongs to one axis: use a space with one number per axis, for example the "
         "roll, pitch and yaw of an orientation";
    return t;
  }
};

}  // namespace detail

template <fixed_string Input, class Space>
struct splitter : std::conditional_t<Space::size == Space::axes::count,
                                     detail::splitter_of<Input, Space, typename Space::axes>,
                                     detail::bad_skeleton<detail::not_splittable<Space>>> {};

}  // namespace cca
