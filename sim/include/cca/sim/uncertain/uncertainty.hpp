// What is uncertain about a robot and the ground, as parameters: sensors, drives, battery, body, ground.
//
//   cca::sim::uncertainty u{};
//   u.seed = 7;
//   u.orientation.noise = 0.02, u.drives.delay = 0.01, u.body.mass = 0.1;
//   controller.set<"robot.simulator">(u);                       // sensors, drives, battery: uncertain_robot.hpp
//   cca::sim::world(cca::sim::drawn_ground(u), posture, cca::sim::drawn_settings(u));   // body and ground
//
// All are 0: nothing is uncertain. Where a parameter is a spread (a standard deviation) the seed decides what
// is drawn: the same seed the same robot, and twice the spread is twice as far from the description. Units
// are those of the SI; a file may give others ("5 ms", "2 deg"). Errors: `cca::refused`, where a parameter is
// set, for what is out of its range; std::invalid_argument for a body or a ground that no world can have.
#pragma once

#include <algorithm>
#include <cstdint>

#include <cca/base/math/random_numbers.hpp>
#include <cca/robots/inertial.hpp>
#include <cca/sim/engine/terrain.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>
#include <cca/sim/uncertain/uncertain_reading.hpp>

namespace cca::sim {

struct electrical_resistance {
  double lower, upper;
  static constexpr std::string_view unit = "ohm";
  static constexpr auto on_nan = nan_policy::hold;
};

struct uncertain_drives {
  BOOST_HANA_DEFINE_STRUCT(uncertain_drives,
                           (delay_parameter, delay),               // of commands
                           (share_parameter, loss),                // of the commands of a joint in a beat
                           (quantity<angle, 0, 1>, backlash),      // lost motion of a position, whole width
                           (quantity<velocity, 0, 1e4>, speed),    // of a position, at most; 0: no limit
                           (bounded<double, 0, 0.3>, strength),    // spread of the motors' torque
                           (bounded<double, 0, 0.99>, weakness),   // share of the motors' torque that is lost
                           (quantity<damping, 0, 1e3>, friction),  // in each joint up to this
                           (quantity<torque, 0, 1e3>, dry_friction));  // in each joint up to this
};

// Its voltage falls by resistance times current. Drawn is what the motors do and what heats them: the torque
// times the speed, and torque^2 w / (2 T) of a motor with the torque T and the no-load speed w.
struct uncertain_battery {
  BOOST_HANA_DEFINE_STRUCT(uncertain_battery,
                           (quantity<voltage, 0, 1e4>, open_circuit),
                           (quantity<electrical_resistance, 0, 1e3>, resistance),
                           (quantity<duration, 0, 100>, mean));  // of the power; 0: that of the last beat
  const char* check() const {
    return resistance > 0 && !(open_circuit > 0)
               ? "a battery with a resistance needs its open_circuit voltage"
               : "";
  }
};

struct uncertain_body {
  BOOST_HANA_DEFINE_STRUCT(uncertain_body,
                           (bounded<double, 0, 0.3>, mass),     // spread of the factor of each link's mass
                           (bounded<double, 0, 0.3>, length));  // of its length: not in compiled physics
};

struct uncertain_ground {
  BOOST_HANA_DEFINE_STRUCT(uncertain_ground,
                           (bounded<double, 0, 0.3>, friction),  // spread of the factor of the friction
                           (quantity<angle, 0, 0.3>, slope),     // spread of a slope
                           (quantity<length, 0, 0.03>, step));   // spread of the height of steps
  const char* check() const { return slope > 0 && step > 0 ? "a ground has a slope or steps, not both" : ""; }
};

struct uncertainty {
  BOOST_HANA_DEFINE_STRUCT(uncertainty,
                           (bounded<std::int64_t, 0, std::int64_t{1} << 53>, seed),
                           (uncertain_reading<cca::angle>, angle),  // of the joints
                           (uncertain_reading<cca::velocity>, velocity),
                           (uncertain_reading<cca::torque>, torque),
                           (uncertain_wrench, load),  // of force sensors
                           (uncertain_orientation, orientation),
                           (uncertain_reading<cca::velocity>, angular_velocity),
                           (uncertain_reading<robots::linear_acceleration>, acceleration),
                           (uncertain_reading<cca::force>, foot_load),
                           (uncertain_contact, foot_contact),
                           (uncertain_drives, drives),
                           (uncertain_battery, battery),
                           (uncertain_body, body),
                           (uncertain_ground, ground));
};

namespace detail {

enum class drawn_for : std::uint8_t { sensors, noise, drives, body, ground };

// A generator of its own for each purpose: what is drawn for one does not depend on the others.
inline random_numbers generator_of(const uncertainty& u, drawn_for purpose) {
  random_numbers mixed(8 * static_cast<std::uint64_t>(u.seed.value()) + static_cast<std::uint64_t>(purpose));
  return random_numbers(mixed.bits());
}
inline double drawn_factor(random_numbers& random, double spread) {
  return 1 + spread * drawn_deviation(random);  // above 0: spreads are at most 0.3
}

}  // namespace detail

// The masses and lengths of the links, for a world.
inline robot_world_settings drawn_settings(const uncertainty& u, robot_world_settings s = {}) {
  random_numbers random = detail::generator_of(u, detail::drawn_for::body);
  for (std::size_t i = 0; i < s.body.mass.size(); ++i) {
    s.body.mass[i] *= detail::drawn_factor(random, u.body.mass);
    s.body.length[i] *= detail::drawn_factor(random, u.body.length);
  }
  return s;
}

// The ground, where nothing else is said a level one: its friction, and a slope or steps on it.
inline terrain drawn_ground(const uncertainty& u, const terrain& like = terrain::flat()) {
  random_numbers random = detail::generator_of(u, detail::drawn_for::ground);
  const double friction = like.friction() * detail::drawn_factor(random, u.ground.friction);
  const double deviation = detail::drawn_deviation(random);
  const terrain shape = u.ground.slope > 0  ? terrain::slope(u.ground.slope * deviation)
                        : u.ground.step > 0 ? terrain::steps(u.ground.step * deviation)
                                            : like;
  return shape.with_friction(friction);
}

}  // namespace cca::sim
