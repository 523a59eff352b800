// The four legs of an Oncilla, in the order of all arrays: front before hind, left before right.
#pragma once

#include <cstddef>
#include <numbers>

namespace cca::robots::oncilla {

inline constexpr std::size_t leg_count = 4;

enum class leg_id : std::size_t { left_front, right_front, left_hind, right_hind };

constexpr bool is_front(std::size_t leg) { return leg < 2; }

// +1: left, the side of positive y.
constexpr double side_of(std::size_t leg) { return leg % 2 == 0 ? 1.0 : -1.0; }

// In radians.
constexpr double degrees(double angle) { return angle * std::numbers::pi / 180.0; }

}  // namespace cca::robots::oncilla
