// The units that a quantity may be written in, in a file: the SI unit first, then the others with their size in it.
#pragma once

#include <numbers>
#include <string_view>

#include <cca/space/quantity.hpp>

namespace cca::detail {

struct unit_spelling {
  std::string_view text;
  double factor = 1;
};

inline constexpr double degree = std::numbers::pi / 180;

// Each list ends with an empty one. A quantity of the user's own is written in its unit alone.
template <class Quantity>
inline constexpr unit_spelling unit_spellings_of[] = {{Quantity::unit}, {}};
template <>
inline constexpr unit_spelling unit_spellings_of<angle>[] = {{"rad"}, {"deg", degree}, {"mrad", 1e-3}, {}};
template <>
inline constexpr unit_spelling unit_spellings_of<velocity>[] = {{"rad/s"}, {"deg/s", degree}, {"rpm", std::numbers::pi / 30}, {}};

}  // namespace cca::detail
