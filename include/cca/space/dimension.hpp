// A dimension is a named axis: a type that all quantities along it share, with one limit per quantity.
//
//   struct hip : cca::dimension<"hip"> {
//     static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
//   };
//
// A continuous axis turns without end. Its dimension says so, and states no limits of angle:
//
//   struct wheel : cca::dimension<"wheel"> {
//     static constexpr bool continuous = true;
//     static constexpr auto limits = cca::limits{cca::velocity{-20, 20}, cca::torque{-5, 5}};
//   };
//
// Angles of such an axis that differ by whole turns mean the same, and the difference of two of them is the
// shortest way around the circle (difference_of in methods/circle.hpp). Errors: space.bad_limits.
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/quantity.hpp>

namespace cca {

template <fixed_string Name>
struct dimension {
  static constexpr std::string_view name = Name.view();
  static constexpr auto label = Name;  // the name as a template argument
};

template <class Type> concept Dimension = requires {
  { Type::name } -> std::convertible_to<std::string_view>;
};

template <class Axis>
constexpr bool is_continuous = false;
template <class Axis>
  requires requires { Axis::continuous; }
constexpr bool is_continuous<Axis> = Axis::continuous;

namespace detail {

template <class Axis>
struct no_limits_of_axis {
  static constexpr void tell(text& m) {
    m << "space.bad_limits: `limits` of the axis " << type_name<Axis>() << " is `"
      << type_name<std::remove_cvref_t<decltype(Axis::limits)>>()
      << "`, and no cca::limits: list the ranges in one, as in `static constexpr auto limits = "
         "cca::limits{cca::angle{-0.5, 0.5}};`";
  }
};
// Asked where an axis is listed, of one that may be incomplete there; so nothing else asks it.
template <class Axis>
inline constexpr bool lists_limits = true;
template <class Axis>
  requires requires { Axis::limits; }
inline constexpr bool lists_limits<Axis> =
    requires { std::remove_cvref_t<decltype(Axis::limits)>::template has<angle>; };

// It states something that is refused, and has its message.
template <class Axis>
inline constexpr bool has_refused_limits = false;
template <class Axis>
  requires requires { Axis::limits; }
inline constexpr bool has_refused_limits<Axis> = !requires {
  std::remove_cvref_t<decltype(Axis::limits)>::template has<angle>;
} || requires { std::remove_cvref_t<decltype(Axis::limits)>::is_refused; };

template <class Axis, class Quantity>
constexpr bool axis_has_limits = false;

template <class Axis, class Quantity>
  requires requires { std::remove_cvref_t<decltype(Axis::limits)>::template has<Quantity>; }
constexpr bool axis_has_limits<Axis, Quantity> =
    std::remove_cvref_t<decltype(Axis::limits)>::template has<Quantity>;

}  // namespace detail

// The Cartesian axes.
struct x : dimension<"x"> {};
struct y : dimension<"y"> {};
struct z : dimension<"z"> {};

}  // namespace cca
