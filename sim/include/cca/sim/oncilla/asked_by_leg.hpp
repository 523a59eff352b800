// The questions that programs of an Oncilla ask of its world, by leg: left front, right front, left hind,
// right hind. The same ones of each engine's world (world.hpp, compiled_oncilla.hpp).
//
//   World   a world of cca::robots::oncilla::as_built on a terrain
//
// No state besides that of the world.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <cca/base/eigen.hpp>
#include <cca/base/math.hpp>
#include <cca/robots/inertial.hpp>
#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/engine/scene.hpp>
#include <cca/sim/engine/terrain.hpp>
#include <cca/sim/oncilla/attitude.hpp>
#include <cca/sim/oncilla/oncilla_posture.hpp>
#include <cca/sim/robot/model/contact_account.hpp>

namespace cca::sim {

using foot_account = contact_account;

template <class World>
class asked_by_leg : public World {
public:
  robot_reading reading() const {
    robot_reading r;
    for (std::size_t leg = 0; leg < leg_count; ++leg) {
      const auto joint = [&](std::size_t i) {
        const auto& of = this->joints()[joints_of_leg * leg + i];
        return joint_reading{of.angle, of.velocity, of.torque};
      };
      r.legs[leg] = {joint(hip), joint(knee), joint(abduction), joint(toe), this->force_on_end(leg)};
    }
    const robots::inertial_reading& unit = this->inertial(0);
    const auto& [x, y, z, w] = unit.orientation;
    r.trunk = {{w, x, y, z}, unit.angular_velocity, unit.specific_force};
    return r;
  }

  // The targets that the motors follow.
  robot_command targets() const {
    robot_command taken;
    for (std::size_t leg = 0; leg < leg_count; ++leg) {
      const joint_law* of = &this->laws()[joints_of_leg * leg];
      taken[leg] = {of[hip].position, of[knee].position, of[abduction].position, of[hip].stiffness};
    }
    return taken;
  }

  // The true state, which no sensor of the robot measures.
  vector3 trunk_position() const { return vector(this->frame(-1).where.at); }
  vector3 trunk_velocity() const { return vector(this->frame(-1).velocity); }
  vector3 foot_position(std::size_t leg) const { return vector(this->end(leg).where.at); }
  double hip_height() const {
    const vector3 p = trunk_position();
    return p[2] - oncilla_defaults.trunk_above_hips - this->ground_height(p[0]);
  }
  // The trunk has touched the ground, or rolled or pitched by 30 degrees.
  bool fallen() const {
    const roll_pitch_yaw a = attitude(reading().trunk.orientation);
    constexpr double limit = degrees(30);
    return this->contact_of_base().touching > 0 || !(std::abs(a.roll) < limit) ||
           !(std::abs(a.pitch) < limit);
  }
  foot_account foot(std::size_t leg) const { return this->contact_at_end(leg); }

protected:
  explicit asked_by_leg(World&& w) : World(std::move(w)) {}

  static scene on(const terrain& ground) {
    scene s;
    s.ground = ground;
    return s;
  }

  // The trunk is level, the lowest foot just above the ground.
  static std::array<double, leg_count * 4> angles_of(const initial_posture& posture) {
    std::array<double, leg_count * 4> q{};
    for (std::size_t leg = 0; leg < leg_count; ++leg) {
      double* of = &q[joints_of_leg * leg];
      of[abduction] = posture.legs[leg].abduction;
      of[hip] = posture.legs[leg].hip, of[knee] = posture.legs[leg].knee;
    }
    return q;
  }
  static double height_of(const initial_posture& posture) {
    double lowest = 0;
    for (const leg_posture& p : posture.legs)
      lowest =
          std::min(lowest, math::cos(p.abduction) * sim::foot_position(oncilla_defaults, {p.hip, p.knee}).z);
    return -lowest + oncilla_defaults.foot_radius + clearance + oncilla_defaults.trunk_above_hips;
  }

private:
  static constexpr std::size_t abduction = 0, hip = 1, knee = 2, toe = 3, joints_of_leg = 4;
  static constexpr double clearance = 0.001;

  static vector3 vector(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
};

}  // namespace cca::sim
