// What an inertial unit reads, as domain types: angular velocity and specific force along the axes of a
// frame.
//
// The orientation is cca::orientation<World>. Units: rad/s, m/s^2. The sensors are in sensors.hpp.
#pragma once

#include <string_view>

#include <cca/space/domain.hpp>
#include <cca/space/limits.hpp>

namespace cca::robots {

namespace detail {

// A domain type with one number per axis and no methods of its own.
template <class Quantity>
struct sensor_numbers {
  using quantity = Quantity;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {};
};

}  // namespace detail

struct linear_acceleration {
  double lower, upper;
  static constexpr std::string_view unit = "m/s^2";
  static constexpr auto on_nan = nan_policy::zero;
};

template <class Frame>
struct angular_velocity : detail::sensor_numbers<cca::velocity> {};
// Acceleration minus gravity, the reading of an accelerometer: upwards, 9.81 m/s^2 at rest.
template <class Frame>
struct specific_force : detail::sensor_numbers<linear_acceleration> {};

}  // namespace cca::robots
