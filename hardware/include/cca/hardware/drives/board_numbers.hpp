// The numbers of a sensor board in its frames: i16, little-endian, in steps of a unit.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <cca/base/math/roots.hpp>
#include <cca/hardware/bus/can_frame.hpp>
#include <cca/hardware/drives/wire_number.hpp>

namespace cca::hardware::detail {

constexpr double board_number(const can_frame& f, std::size_t i, double step) {
  return static_cast<std::int16_t>(got<std::uint16_t>(f.payload(), 2 * i)) * step;
}

// One that is out of range is clamped, one that isn't finite is sent as 0.
constexpr void put_board_number(can_frame& f, std::size_t i, double number, double step) {
  bool cut = false;
  const double steps = is_finite(number) ? number / step : 0;
  put(f.data, 2 * i, static_cast<std::uint16_t>(nearest_integer(steps, 16, cut)));
}

// Of a quaternion, x y z w.
inline constexpr double orientation_step = 1.0 / 32767;

// False: the four numbers of the frame are not of unit length (within 2 %). Then nothing is taken.
inline bool take_board_orientation(const can_frame& f, std::array<double, 4>& orientation) {
  std::array<double, 4> q{};
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double steps = board_number(f, i, 1);
    q[i] = steps * orientation_step;
    square += q[i] * steps * orientation_step;
  }
  if (!(square > 0.96 && square < 1.04)) return false;
  for (std::size_t i = 0; i < 4; ++i) orientation[i] = q[i] / math::sqrt(square);
  return true;
}

}  // namespace cca::hardware::detail
