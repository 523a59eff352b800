// Quantities: what is measured along an axis, in which unit, as a closed range from lower to upper.
//
//   struct hip : cca::dimension<"hip"> { static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9},
//   cca::torque{-3, 3}}; };
//
// Units are SI units, angles in radians; a number is in the unit that its quantity states. To make a quantity
// of your own, write another such struct. units.hpp has other spellings of the units, for files.
//
// A quantity states in `on_nan` what a limiter publishes when a command is no finite number. There is no
// default: a torque or a current that is held goes on to accelerate, an angle that goes to zero jumps. One
// whose change a limiter is to bound states in `rate` which quantity of the axis limits that: of an angle the
// velocity. Errors: quantity.on_nan, space.bad_limits.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <cca/base/compiler.hpp>
#include <cca/base/messages/holds_or_tells.hpp>

namespace cca {

enum class nan_policy : std::uint8_t {
  hold,  // the last safe command
  zero   // the allowed number nearest to zero
};

// About a joint.
struct velocity;
struct acceleration;
struct jerk;
struct torque_rate;
struct angle {
  double lower, upper;
  using rate = velocity;
  static constexpr std::string_view unit = "rad";
  static constexpr auto on_nan = nan_policy::hold;
};
struct velocity {
  double lower, upper;
  using rate = acceleration;
  static constexpr std::string_view unit = "rad/s";
  static constexpr auto on_nan = nan_policy::zero;
};
struct acceleration {
  double lower, upper;
  using rate = jerk;
  static constexpr std::string_view unit = "rad/s^2";
  static constexpr auto on_nan = nan_policy::zero;
};
struct jerk {
  double lower, upper;
  static constexpr std::string_view unit = "rad/s^3";
  static constexpr auto on_nan = nan_policy::zero;
};
struct torque {
  double lower, upper;
  using rate = torque_rate;
  static constexpr std::string_view unit = "N m";
  static constexpr auto on_nan = nan_policy::zero;
};
struct torque_rate {
  double lower, upper;
  static constexpr std::string_view unit = "N m/s";
  static constexpr auto on_nan = nan_policy::zero;
};
struct stiffness {
  double lower, upper;
  static constexpr std::string_view unit = "N m/rad";
  static constexpr auto on_nan = nan_policy::hold;
};
struct damping {
  double lower, upper;
  static constexpr std::string_view unit = "N m s/rad";
  static constexpr auto on_nan = nan_policy::hold;
};

// Along a line.
struct length {
  double lower, upper;
  static constexpr std::string_view unit = "m";
  static constexpr auto on_nan = nan_policy::hold;
};
struct speed {
  double lower, upper;
  static constexpr std::string_view unit = "m/s";
  static constexpr auto on_nan = nan_policy::zero;
};
struct force {
  double lower, upper;
  static constexpr std::string_view unit = "N";
  static constexpr auto on_nan = nan_policy::zero;
};
struct linear_stiffness {
  double lower, upper;
  static constexpr std::string_view unit = "N/m";
  static constexpr auto on_nan = nan_policy::hold;
};
struct linear_damping {
  double lower, upper;
  static constexpr std::string_view unit = "N s/m";
  static constexpr auto on_nan = nan_policy::hold;
};

// Neither. `frequency` is in scalar.hpp: it is a domain type as well.
struct mass {
  double lower, upper;
  static constexpr std::string_view unit = "kg";
  static constexpr auto on_nan = nan_policy::hold;
};
struct duration {
  double lower, upper;
  static constexpr std::string_view unit = "s";
  static constexpr auto on_nan = nan_policy::hold;
};
struct power {
  double lower, upper;
  static constexpr std::string_view unit = "W";
  static constexpr auto on_nan = nan_policy::zero;
};
struct voltage {
  double lower, upper;
  static constexpr std::string_view unit = "V";
  static constexpr auto on_nan = nan_policy::zero;
};
struct current {
  double lower, upper;
  static constexpr std::string_view unit = "A";
  static constexpr auto on_nan = nan_policy::zero;
};
struct value {
  double lower, upper;
  static constexpr std::string_view unit = "";
  static constexpr auto on_nan = nan_policy::hold;
};  // a number without a unit

template <class Type> concept Quantity = requires(const Type range) {
  { Type::unit } -> std::convertible_to<std::string_view>;
  { range.lower } -> std::convertible_to<double>;
  { range.upper } -> std::convertible_to<double>;
};

namespace detail {

template <class Quantity>
struct no_on_nan {
  static constexpr void tell(text& m) {
    m << "quantity.on_nan: the quantity " << type_name<Quantity>()
      << " does not say what a limiter does with a command that is NaN: add `static constexpr auto on_nan = "
         "cca::nan_policy::hold;` to it (keep the last command), or `cca::nan_policy::zero` (go to zero)";
  }
};
template <class Quantity>
constexpr bool states_on_nan() {
  constexpr bool states = requires {
    { Quantity::on_nan } -> std::convertible_to<nan_policy>;
  };
  static_assert(holds_or_tells<states, no_on_nan<Quantity>>::value);
  return true;
}

// What a dimension can list: types with two ends, each once.
template <class Type> concept Range = requires(const Type range) {
  range.lower;
  range.upper;
};
template <class Type, class... Types>
inline constexpr int times_in = (0 + ... + int{std::is_same_v<Type, Types>});
template <class... Types> concept Ranges = (Range<Types> && ...) && ((times_in<Types, Types...> == 1) && ...);

template <class... Types>
struct no_ranges {
  static constexpr void tell(text& m) { (void)(one<Types>(m) || ...); }

private:
  template <class Type>
  static constexpr bool one(text& m) {
    if (Range<Type> && times_in<Type, Types...> == 1) return false;
    m << "space.bad_limits: a `cca::limits` lists `" << type_name<Type>() << "`";
    if (Range<Type>) m << " twice: state one range for each quantity";
    else
      m << ", which is no quantity: give each range its quantity, as in `cca::limits{cca::angle{-0.5, 0.5}, "
           "cca::torque{-3, 3}}`";
    return true;
  }
};

}  // namespace detail

// The limits of a dimension, one range a quantity. Of what can't be listed it has none, so that there is one
// error.
template <class... Types>
struct limits {
  static_assert(detail::holds_or_tells<false, detail::no_ranges<Types...>>::value);

  static constexpr bool is_refused = true;
  template <class>
  static constexpr bool has = false;

  constexpr limits(const Types&...) {}
};
template <class... Quantities>
  requires detail::Ranges<Quantities...>
struct limits<Quantities...> : Quantities... {
  static_assert((detail::states_on_nan<Quantities>() && ...));

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
