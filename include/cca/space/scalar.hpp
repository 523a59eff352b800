// Domain types of plain numbers: amplitude, frequency, number, status.
#pragma once

#include <string_view>

#include <cca/space/linear.hpp>

namespace cca {

struct amplitude : detail::linear_domain {};

// In Hz. A quantity and a domain type: what is measured along the axes of a space of frequencies is a frequency.
struct frequency {
  double lower, upper;
  static constexpr std::string_view unit = "Hz";

  using quantity = frequency;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {};
};

// No unit.
struct number : detail::linear_domain {};

struct status : detail::linear_domain {};

}  // namespace cca
