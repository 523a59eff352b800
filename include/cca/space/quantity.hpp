// Quantities: what is measured along an axis, with its unit, as a closed range from lower to upper.
#pragma once

#include <string_view>
#include <type_traits>

namespace cca {

struct angle        { double lower, upper; static constexpr std::string_view unit = "rad"; };
struct velocity     { double lower, upper; static constexpr std::string_view unit = "rad/s"; };
struct acceleration { double lower, upper; static constexpr std::string_view unit = "rad/s^2"; };
struct torque       { double lower, upper; static constexpr std::string_view unit = "N m"; };
struct torque_rate  { double lower, upper; static constexpr std::string_view unit = "N m/s"; };
struct stiffness    { double lower, upper; static constexpr std::string_view unit = "N m/rad"; };
struct length       { double lower, upper; static constexpr std::string_view unit = "m"; };
struct value        { double lower, upper; static constexpr std::string_view unit = ""; };

// The limits of a dimension, one range a quantity: `limits{angle{-0.9, 0.9}, torque{-3, 3}}`.
template <class... Quantities>
struct limits : Quantities... {
  template <class Quantity>
  static constexpr bool has = (std::is_same_v<Quantity, Quantities> || ...);

  template <class Quantity>
  constexpr const Quantity& of() const { return *this; }
};

template <class... Quantities>
limits(Quantities...) -> limits<Quantities...>;

}  // namespace cca
