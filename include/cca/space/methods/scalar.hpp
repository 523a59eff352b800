// Domain types of plain numbers: amplitude, frequency, number, status.
//
//   domain type   coordinates                  unit   methods
//   amplitude     one number per axis          none   sums, interpolation, limits
//   frequency     one number per axis          Hz     the same, and angular_frequency()
//   number        one number per axis          none   the same as amplitude
//   status        one whole number per axis    none   as<Enum>(), is(...)
#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <string_view>
#include <type_traits>

#include <cca/space/methods/linear.hpp>

namespace cca {

struct amplitude : detail::linear_domain {
  template <class Self>
  struct methods : detail::additive<Self> {};
};

// Both a quantity and a domain type: the axes of a space of frequencies measure frequency.
struct frequency {
  double lower, upper;
  static constexpr std::string_view unit = "Hz";
  static constexpr auto on_nan = nan_policy::hold;

  using quantity = frequency;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }

  template <class Self>
  struct methods : detail::additive<Self> {
    // In rad/s.
    constexpr auto angular_frequency() const {
      using vector = typename Self::space::vector_type;
      return vector(2 * std::numbers::pi * this->self().vector());
    }
  };
};

struct number : detail::linear_domain {
  template <class Self>
  struct methods : detail::additive<Self> {};
};

// The number of an enumerator. States have no order and no distance, so they are not interpolated.
struct status : detail::linear_domain {
  template <class Self>
  struct methods : detail::mixin<Self> {
    // The state along an axis, or the only one. A number that `Enum` can't hold (NaN, too large) gives
    // `Enum{}`.
    template <class Enum, class Axis>
    constexpr Enum as(Axis axis) const {
      return read<Enum>(this->self()[axis]);
    }

    template <class Enum>
    constexpr Enum as() const {
      static_assert(Self::space::size == 1,
                    "cca::status: this space has several axes; name one: as<state>(axis{})");
      return read<Enum>(this->self().vector().coeff(0));
    }

    template <class Enum>
    constexpr bool is(Enum state) const {
      return as<Enum>() == state;
    }

  private:
    template <class Enum>
    static constexpr Enum read(double number) {
      static_assert(std::is_enum_v<Enum>, "cca::status: the type in as<...>() must be an enumeration");
      using whole = std::underlying_type_t<Enum>;
      // A double holds whole numbers exactly up to 2^53.
      constexpr double most = std::min(0x1p53, static_cast<double>(std::numeric_limits<whole>::max()));
      constexpr double least = std::max(-0x1p53, static_cast<double>(std::numeric_limits<whole>::lowest()));
      return number >= least && number <= most ? static_cast<Enum>(static_cast<whole>(number)) : Enum{};
    }
  };
};

// The number to publish for a state: `return cca::status_of(mode::swing);`.
template <class Enum>
  requires std::is_enum_v<Enum>
constexpr double status_of(Enum state) {
  return static_cast<double>(static_cast<std::underlying_type_t<Enum>>(state));
}

}  // namespace cca
