// Angles on the circle, as ordinary functions.
#pragma once

#include <cmath>
#include <numbers>

#include <cca/base/compiler.hpp>

namespace cca {

inline constexpr double pi = std::numbers::pi;

// Into (-pi, pi]. An angle inside the range keeps every bit. NaN for an infinity.
inline double wrap_signed(double angle) {
  if (angle > -pi && angle <= pi) return angle;
  const double wrapped = angle - 2 * pi * std::ceil((angle - pi) / (2 * pi));
  return wrapped > pi ? wrapped - 2 * pi : wrapped <= -pi ? wrapped + 2 * pi : wrapped;
}

// Into [0, 2 pi). An angle inside the range keeps every bit. NaN for an infinity.
inline double wrap_turn(double angle) {
  if (angle >= 0 && angle < 2 * pi) return angle;
  const double wrapped = angle - 2 * pi * std::floor(angle / (2 * pi));
  return wrapped >= 2 * pi || wrapped < 0 ? 0.0 : wrapped;  // only rounding leads here
}

}  // namespace cca
