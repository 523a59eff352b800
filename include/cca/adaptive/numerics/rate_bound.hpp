// Bounds of parameters that follow from the rate of the node, for the function `check_at(step)` of a struct
// of parameters: a rate of the component times the step is at most `most_parts` (ode_solver.hpp).
//
//   std::string check_at(double step) const {
//     return detail::above_rate_bound("convergence", convergence, detail::rate_bound(step), step);
//   }
//
// The text names the parameter, its bound and the rate. Runs between beats.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include <cca/adaptive/numerics/ode_integrators.hpp>

namespace cca::detail {

// The fastest rate, in 1/s, that a node with this step in s can follow.
constexpr double rate_bound(double step) { return most_parts * longest_step / step; }

inline std::string short_text(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 6).ptr};
}

inline std::string rate_text(
    std::string_view name, double value, std::string_view relation, double bound, double step) {
  return std::string("`").append(name) + "` is " + short_text(value) + ", but at " + short_text(1 / step) +
         " Hz it must be " + std::string(relation) + " " + short_text(bound) +
         ": run the node faster, or change it";
}
// Empty if the value holds.
inline std::string above_rate_bound(std::string_view name, double value, double bound, double step) {
  return value <= bound ? std::string() : rate_text(name, value, "at most", bound, step);
}
inline std::string below_rate_bound(std::string_view name, double value, double bound, double step) {
  return value >= bound ? std::string() : rate_text(name, value, "at least", bound, step);
}

}  // namespace cca::detail
