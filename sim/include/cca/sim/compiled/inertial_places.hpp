// The inertial units of a described robot in a compiled world: where they are, and what they read.
#pragma once

#include <array>
#include <cstddef>

#include <cca/robots/inertial.hpp>
#include <cca/sim/compiled/compiled_tree.hpp>
#include <cca/sim/engine/moving_frame.hpp>

namespace cca::sim::detail {

// A place for each part with inertial sensors, in the order of the description.
template <class R>
constexpr auto inertial_places = []<class... Sensors>(robots::sensors<Sensors...>) {
  std::array<place_on_link, robots::detail::unit_count(robots::sensors<Sensors...>())> all{};
  constexpr robots::detail::inertial_units<Sensors...> units;
  constexpr auto ends = ends_of<typename R::body>();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int part = part_index<typename R::body>(units.parts[i]);
    if (part >= 0) all[i] = ends[static_cast<std::size_t>(part)];
  }
  return all;
}(robots::sensors_of<R>());

// After a beat in which the speed of the unit has changed from `before`. Ideal: without noise, bias or delay.
inline robots::inertial_reading inertial_reading_of(const moving_frame& now,
                                                    const std::array<double, 3>& before,
                                                    double beat,
                                                    double gravity) {
  const Eigen::Vector3d change = (now.velocity - cca::detail::as_vector(before)) / beat;
  const Eigen::Matrix3d into_unit = now.where.turn.transpose();
  robots::inertial_reading r;
  Eigen::Vector4d::Map(r.orientation.data()) = cca::detail::quaternion_of(now.where.turn);
  Eigen::Vector3d::Map(r.angular_velocity.data()) = into_unit * now.angular_velocity;
  Eigen::Vector3d::Map(r.specific_force.data()) = into_unit * (change + Eigen::Vector3d(0, 0, gravity));
  return r;
}

}  // namespace cca::sim::detail
