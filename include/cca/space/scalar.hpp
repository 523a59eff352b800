// Domain types of plain numbers: amplitude, frequency, number, status.
//
//   domain type   coordinates                  unit   methods
//   amplitude     one number an axis           none   sums, interpolation, limits
//   frequency     one number an axis           Hz     the same, angular_frequency()
//   number        one number an axis           none   the same as amplitude
//   status        one whole number an axis     none   as<Enum>(), is(...)
#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <string_view>
#include <type_traits>

#include <cca/space/linear.hpp>

namespace cca {

struct amplitude : detail::linear_domain {
  template <class Self>
  struct methods : detail::additive<Self> {};
};

// A quantity and a domain type: what is measured along the axes of a space of frequencies is a frequency.
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
    // rad/s
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

// A state out of a few: the number of an enumerator. States have no order and no distance, so nothing is
// interpolated.
struct status : detail::linear_domain {
  template <class Self>
  struct methods : detail::mixin<Self> {
    // The state along an axis, or the only one. What isn't a number that `Enum` could hold (NaN, too large)
    // is `Enum{}`.
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
      static_assert(std::is_enum_v<Enum>, "cca::status: as<...>() reads an enumeration");
      using whole = std::underlying_type_t<Enum>;
      // 53 bits are whole numbers in a double.
      constexpr double most = std::min(0x1p53, static_cast<double>(std::numeric_limits<whole>::max()));
      constexpr double least = std::max(-0x1p53, static_cast<double>(std::numeric_limits<whole>::lowest()));
      return number >= least && number <= most ? static_cast<Enum>(static_cast<whole>(number)) : Enum{};
    }
  };
};

// The number to publish for a state: `return cca::status_of(mode::swing);`
template <class Enum>
  requires std::is_enum_v<Enum>
constexpr double status_of(Enum state) {
  return static_cast<double>(static_cast<std::underlying_type_t<Enum>>(state));
}

}  // namespace cca
