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

#include <cca/space/messages/space_in_words.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
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

namespace detail {

template <class Space, class Enum>
struct states_of_many_axes {
  static constexpr void tell(text& m) {
    m << "space.unknown_axis: " << space_in_words<Space>()
      << " has a state along each of its axes: name one, "
      << "as in `as<" << type_name<Enum>() << ">(" << axis_in_words(typename Space::axes(), 0) << "{})`";
  }
};
template <class Space, class Type>
struct no_state {
  static constexpr void tell(text& m) {
    m << "cca::status: `as<" << type_name<Type>() << ">()` reads a sample of " << space_in_words<Space>()
      << ", whose numbers are states: name the enumeration of these states, as in `as<cca::ode_status>()`";
  }
};

}  // namespace detail

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
      static_assert(detail::holds_or_tells<(Self::space::size == 1),
                                           detail::states_of_many_axes<typename Self::space, Enum>>::value);
      return read<Enum>(this->self().vector().coeff(0));
    }

    template <class Enum>
    constexpr bool is(Enum state) const {
      return as<Enum>() == state;
    }

  private:
    template <class Enum>
    static constexpr Enum read(double number) {
      static_assert(
          detail::holds_or_tells<std::is_enum_v<Enum>, detail::no_state<typename Self::space, Enum>>::value);
      if constexpr (!std::is_enum_v<Enum>) return {};
      else return enumerator<Enum>(number);
    }
    template <class Enum>
    static constexpr Enum enumerator(double number) {
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
