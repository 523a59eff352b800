// An Oncilla's world: that of a described robot (robot/world/robot_world.hpp), put down in a posture on a
// terrain, with the questions that programs of an Oncilla ask, by leg: left front, right front, left hind,
// right hind.
//
//   cca::sim::world w(cca::sim::terrain::slope(0.1), cca::sim::standing_posture());
//   w.trunk_position(), w.foot(0).slip, w.fallen()
//
// A value, as every world. It has no state besides that of the robot's world.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <cca/base/math.hpp>
#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/oncilla/attitude.hpp>
#include <cca/sim/oncilla/oncilla_posture.hpp>
#include <cca/sim/robot/world/robot_world.hpp>
#include <cca/sim/engine/terrain.hpp>

namespace cca::sim {

using foot_account = contact_account;

class world : public robot_world {
public:
  explicit world(const terrain& ground = terrain::flat(),
                 const initial_posture& posture = {},
                 const robot_world_settings& settings = {})
      : robot_world(model_of<robots::oncilla::as_built>(), on(ground), settings) {
    put_down(posture);
  }
  // The numbers are the robot's: to change them, change a robot_model.
  world(const oncilla_model& numbers, const terrain& ground, const initial_posture& posture = {})
      : world(ground, posture) {
    if (&numbers != &oncilla_defaults)
      throw std::invalid_argument(
          "cca::sim::world: other numbers than oncilla_defaults change nothing here; change a copy of "
          "cca::sim::model_of<cca::robots::oncilla::as_built>() and make a cca::sim::robot_world of it");
  }

  // Of a simulator that is not told where: it stands on flat ground.
  static world at_start() { return world(terrain::flat(), standing_posture()); }

  robot_reading reading() const {
    robot_reading r;
    for (std::size_t leg = 0; leg < leg_count; ++leg) {
      const joint_reading* of = &joints()[joints_of_leg * leg];
      r.legs[leg] = {of[hip], of[knee], of[abduction], of[toe], force_on_end(leg)};
    }
    const inertial_reading& unit = inertial(0);
    const auto& [x, y, z, w] = unit.orientation;
    r.trunk = {{w, x, y, z}, unit.angular_velocity, unit.specific_force};
    return r;
  }

  // The targets that the motors follow.
  robot_command targets() const {
    robot_command taken;
    for (std::size_t leg = 0; leg < leg_count; ++leg) {
      const joint_law* of = &laws()[joints_of_leg * leg];
      taken[leg] = {of[hip].position, of[knee].position, of[abduction].position, of[hip].stiffness};
    }
    return taken;
  }

  // The true state, which no sensor of the robot measures.
  vector3 trunk_position() const { return vector(frame(-1).where.at); }
  vector3 trunk_velocity() const { return vector(frame(-1).velocity); }
  vector3 foot_position(std::size_t leg) const { return vector(end(leg).where.at); }
  double hip_height() const {
    const vector3 p = trunk_position();
    return p[2] - oncilla_defaults.trunk_above_hips - ground_shape().height(p[0]);
  }
  // The trunk has touched the ground, or rolled or pitched by 30 degrees.
  bool fallen() const {
    const roll_pitch_yaw a = attitude(reading().trunk.orientation);
    constexpr double limit = degrees(30);
    return contact_of_base().touching > 0 || !(std::abs(a.roll) < limit) || !(std::abs(a.pitch) < limit);
  }
  foot_account foot(std::size_t leg) const { return contact_at_end(leg); }
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a world always has a ground
  const terrain& ground_shape() const { return *around().ground; }

private:
  static constexpr std::size_t abduction = 0, hip = 1, knee = 2, toe = 3, joints_of_leg = 4;
  static constexpr double clearance = 0.001;

  static scene on(const terrain& ground) {
    scene s;
    s.ground = ground;
    return s;
  }
  static vector3 vector(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

  void put_down(const initial_posture& posture) {
    double lowest = 0;
    std::vector<double> q;
    for (const leg_posture& p : posture.legs) {
      lowest =
          std::min(lowest, math::cos(p.abduction) * sim::foot_position(oncilla_defaults, {p.hip, p.knee}).z);
      q.insert(q.end(), {p.abduction, p.hip, p.knee, 0.0});
    }
    moving_frame base;
    base.where.at[2] = -lowest + oncilla_defaults.foot_radius + clearance + oncilla_defaults.trunk_above_hips;
    base.velocity = Eigen::Vector3d::Map(posture.trunk_velocity.data());
    place(q, std::vector<double>(q.size(), 0.0), base);
  }
};

}  // namespace cca::sim
