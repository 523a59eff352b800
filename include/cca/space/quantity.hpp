// Quantities: what is measured along an axis, in which unit, as a closed range from lower to upper.
//
//   struct hip : cca::dimension<"hip"> { static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9},
//   cca::torque{-3, 3}}; };
//
// Units are SI units, angles in radians; a number is held in the unit that its quantity states. A quantity of
// one's own is another such struct. Other spellings of the units, for files, are in units.hpp.
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

namespace cca {

// About a joint.
struct angle {
  double lower, upper;
  static constexpr std::string_view unit = "rad";
};
struct velocity {
  double lower, upper;
  static constexpr std::string_view unit = "rad/s";
};
struct acceleration {
  double lower, upper;
  static constexpr std::string_view unit = "rad/s^2";
};
struct torque {
  double lower, upper;
  static constexpr std::string_view unit = "N m";
};
struct torque_rate {
  double lower, upper;
  static constexpr std::string_view unit = "N m/s";
};
struct stiffness {
  double lower, upper;
  static constexpr std::string_view unit = "N m/rad";
};
struct damping {
  double lower, upper;
  static constexpr std::string_view unit = "N m s/rad";
};

// Along a line.
struct length {
  double lower, upper;
  static constexpr std::string_view unit = "m";
};
struct speed {
  double lower, upper;
  static constexpr std::string_view unit = "m/s";
};
struct force {
  double lower, upper;
  static constexpr std::string_view unit = "N";
};
struct linear_stiffness {
  double lower, upper;
  static constexpr std::string_view unit = "N/m";
};
struct linear_damping {
  double lower, upper;
  static constexpr std::string_view unit = "N s/m";
};

// Neither. `frequency` is in scalar.hpp: it is a domain type as well.
struct mass {
  double lower, upper;
  static constexpr std::string_view unit = "kg";
};
struct duration {
  double lower, upper;
  static constexpr std::string_view unit = "s";
};
struct power {
  double lower, upper;
  static constexpr std::string_view unit = "W";
};
struct voltage {
  double lower, upper;
  static constexpr std::string_view unit = "V";
};
struct current {
  double lower, upper;
  static constexpr std::string_view unit = "A";
};
struct value {
  double lower, upper;
  static constexpr std::string_view unit = "";
};  // a number without a unit

template <class Type> concept Quantity = requires(const Type range) {
  { Type::unit } -> std::convertible_to<std::string_view>;
  { range.lower } -> std::convertible_to<double>;
  { range.upper } -> std::convertible_to<double>;
};

// The limits of a dimension, one range a quantity.
template <class... Quantities>
struct limits : Quantities... {
  template <class Quantity>
  static constexpr bool has = (std::is_same_v<Quantity, Quantities> || ...);

  template <class Quantity>
  constexpr const Quantity& of() const {
    return *this;
  }
};

template <class... Quantities>
limits(Quantities...) -> limits<Quantities...>;

}  // namespace cca
