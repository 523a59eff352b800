// Spaces and their parts in the sentences of messages. Compiled only where a message is written.
#pragma once

#include <string_view>
#include <type_traits>

#include <cca/base/text.hpp>
#include <cca/base/type_name.hpp>

namespace cca {

template <class... Axes>
struct axes;

namespace detail {

template <class Axes>
inline constexpr text text_of_axes{};
template <class... Axes>
inline constexpr text text_of_axes<axes<Axes...>> = [] {
  text one;
  ((one << (one.size > 0 ? ", " : "") << type_name<Axes>()), ...);
  return one;
}();
// "hip, knee"
template <class Axes>
constexpr std::string_view axes_in_words() {
  return text_of_axes<Axes>.view();
}

// The name of one of them.
template <class... Axes>
constexpr std::string_view axis_in_words(axes<Axes...>, int index) {
  constexpr std::string_view names[] = {type_name<Axes>()..., {}};
  return names[index];
}

// The first axis of `Wanted` that a list lacks.
template <class Axes, class... Wanted>
constexpr std::string_view missing_axis_in_words(axes<Wanted...>) {
  std::string_view first;
  (void)((Axes::template contains<Wanted> || (first = type_name<Wanted>(), false)) && ...);
  return first;
}

template <class Space>
inline constexpr text text_of_space = [] {
  text one;
  one << type_name<Space>() << " (" << type_name<typename Space::domain>() << " over "
      << axes_in_words<typename Space::axes>();
  if constexpr (requires { Space::rate::hz; }) one << " at " << Space::rate::hz << " Hz";
  one << ")";
  return one;
}();
// "leg_angles (joint_angles over hip, knee at 1000 Hz)"
template <class Space>
constexpr std::string_view space_in_words() {
  return text_of_space<Space>.view();
}

// Of an index: `q[hip{}]`.
template <class Space, class Axis>
struct unknown_axis {
  static constexpr void tell(text& m) {
    m << "space.unknown_axis: " << space_in_words<Space>() << " has no axis " << type_name<Axis>()
      << ": read or write one that it has, or add the axis to the space";
  }
};

// Of what is asked by axis, or about limits, of a space whose numbers do not belong to its axes.
template <class Space>
struct no_number_per_axis {
  static constexpr void tell(text& m) {
    m << "space.unknown_axis: " << space_in_words<Space>() << " has " << Space::size << " numbers over "
      << Space::axes::count << (Space::axes::count == 1 ? " axis" : " axes")
      << ", so none of them is that of an axis, and none has limits: use `vector()`, or a space of one "
         "number "
         "per axis";
  }
};

// "the domain types differ"
template <class A, class B>
constexpr std::string_view difference_in_words() {
  if (!std::is_same_v<typename A::domain, typename B::domain>) {
    constexpr auto base = [](std::string_view name) { return name.substr(0, name.find('<')); };
    return base(type_name<typename A::domain>()) == base(type_name<typename B::domain>())
               ? "the frames differ"
               : "the domain types differ";
  }
  return std::is_same_v<typename A::axes, typename B::axes> ? "the rates differ" : "the axes differ";
}

}  // namespace detail
}  // namespace cca
