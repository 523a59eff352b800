// Types for the fields of a `parameters` struct that say more than `double`: a range, a unit, a short text.
//
//   (cca::bounded<double, 0.1, 5.0>, frequency)           0.1 to 5
//   (cca::quantity<cca::angle>, offset)                   with a unit: "30 deg" in a file, radians here
//   (cca::quantity<cca::angle, -0.9, 0.9>, hip)           with a unit and a range, in SI units
//   (cca::text<16>, name)                                 up to 16 bytes, without the heap
//
// All convert to the plain type implicitly. They hold any value they are given: the range is checked only
// when parameters are loaded or set, so it costs nothing in a beat. An infinite bound allows that infinity;
// otherwise numbers must be finite. NaN is always refused.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/quantity.hpp>

namespace cca {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

namespace detail {

template <class Type, Type Lower, Type Upper>
struct bounds_swapped {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: the lower bound of a parameter, " << number(Lower)
      << ", is above its upper bound, " << number(Upper) << ", so no value fits: write the lower one first";
  }

private:
  static constexpr auto number(Type bound) {
    if constexpr (std::is_floating_point_v<Type>) return static_cast<double>(bound);
    else return static_cast<std::int64_t>(bound);
  }
};
template <class Type, Type Lower, Type Upper>
struct ranged {
  static_assert(holds_or_tells<(Lower <= Upper), bounds_swapped<Type, Lower, Upper>>::value);
  using value_type = Type;
  static constexpr Type lower = Lower, upper = Upper;

  constexpr ranged() = default;
  constexpr ranged(Type value) : held(value) {}
  constexpr operator Type() const { return held; }
  constexpr Type value() const { return held; }

private:
  Type held = Lower > Type{0} ? Lower : Upper < Type{0} ? Upper : Type{0};
};

inline constexpr double largest_double = std::numeric_limits<double>::max();

}  // namespace detail

// A number from Lower to Upper, both included. The bounds may be of another type: `bounded<double, 0, 5>`.
template <class Type, auto Lower, auto Upper>
struct bounded : detail::ranged<Type, static_cast<Type>(Lower), static_cast<Type>(Upper)> {
  using detail::ranged<Type, static_cast<Type>(Lower), static_cast<Type>(Upper)>::ranged;
};

// A number with the unit of a quantity.
template <Quantity Measures, auto Lower = -detail::largest_double, auto Upper = detail::largest_double>
struct quantity : detail::ranged<double, static_cast<double>(Lower), static_cast<double>(Upper)> {
  using detail::ranged<double, static_cast<double>(Lower), static_cast<double>(Upper)>::ranged;
  using measures = Measures;
};

template <std::size_t Capacity>
struct text {
  static constexpr std::size_t capacity = Capacity;

  constexpr text() = default;
  template <std::size_t Size>
    requires(Size <= Capacity + 1)
  constexpr text(const char (&literal)[Size]) {
    (void)assign({literal, Size - 1});
  }

  // If the text is too long, returns false and changes nothing.
  [[nodiscard]] constexpr bool assign(std::string_view from) {
    if (from.size() > Capacity) return false;
    for (std::size_t i = 0; i < Capacity; ++i) held[i] = i < from.size() ? from[i] : '\0';
    size = from.size();
    return true;
  }
  constexpr std::string_view view() const { return {held, size}; }
  constexpr operator std::string_view() const { return view(); }
  friend constexpr bool operator==(const text& a, const text& b) { return a.view() == b.view(); }

private:
  char held[Capacity + 1]{};
  std::size_t size = 0;
};

}  // namespace cca
