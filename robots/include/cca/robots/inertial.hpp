// What inertial units and feet read, as numbers and as domain types.
//
// Its orientation is a sample of cca::orientation<World>. Units: rad/s, m/s^2. The sensors are in
// sensors.hpp.
#pragma once

#include <array>
#include <string_view>

#include <cca/space/domain.hpp>
#include <cca/space/limits.hpp>

namespace cca::robots {

namespace detail {

// A domain type with one number for each axis. Its samples have no methods besides those of all samples.
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

// The vertical part of the ground's force on a foot, upwards; 0: no contact.
struct foot_load : detail::sensor_numbers<cca::force> {};

// Along the unit's own axes.
struct inertial_reading {
  std::array<double, 4> orientation{0, 0, 0, 1};  // x y z w, turns the unit's axes into the world's
  std::array<double, 3> angular_velocity{};       // rad/s
  std::array<double, 3> specific_force{};         // m/s^2, acceleration minus gravity
};

}  // namespace cca::robots
