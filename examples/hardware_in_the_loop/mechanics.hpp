#pragma once
// The simulated Oncilla as the mechanics of the virtual drives: their laws in, its joints and sensors out. It
// is a plant for cca::hardware::virtual_hardware.
//
// A drive measures its velocity with its encoder: it is the change of the angle over the last millisecond.
// The simulator's own velocity is that of one step of the engine. Where a joint chatters in a stop or a
// contact, faster than a millisecond, this is always the same phase of the chatter: a joint at rest then
// shows up to 1 rad/s, and the velocity check of the start refuses it.
#include <array>
#include <cstddef>
#include <utility>

#include <cca/hardware/sensor_board.hpp>
#include <cca/hardware/virtual_drive.hpp>
#include <cca/robots/oncilla/axes.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/oncilla/world.hpp>

namespace hil {

namespace axes = cca::robots::oncilla;

class mechanics {
public:
  explicit mechanics(cca::sim::world&& w = cca::sim::world()) : world(std::move(w)), former(angles()) {}

  void move_servos(const std::array<double, 4>& targets) { abduction = targets; }

  // One millisecond.
  void advance(const std::array<cca::hardware::drive_command, 8>& drives,
               const std::array<bool, 8>& = {},
               double = 1e-3) {
    const auto law = [](const cca::hardware::drive_command& c) {
      return cca::sim::joint_law{c.position, c.velocity, c.torque, c.stiffness, c.damping};
    };
    // The knee's drive measures the joint, and its law acts there: it pulls the cable with what the law says,
    // without a pulley that has a place of its own.
    const auto pull = [](const cca::hardware::drive_command& c, double angle) {
      return cca::sim::joint_law{.velocity = c.velocity,
                                 .torque = c.torque + c.stiffness * (c.position - angle),
                                 .damping = c.damping};
    };
    using built = axes::as_built;
    std::array<cca::sim::joint_law, built::drives.size()> laws{};  // abduction, hip, knee and toe of each leg
    for (std::size_t leg = 0; leg < axes::leg_count; ++leg) {
      laws[4 * leg] = {.position = abduction[leg],
                       .stiffness = built::abduction.stiffness,
                       .damping = built::abduction.damping};
      laws[4 * leg + 1] = law(drives[axes::hip_of(leg)]);
      laws[4 * leg + 2] = pull(drives[axes::knee_of(leg)], world.joints()[4 * leg + 2].angle);
    }
    former = angles();
    const auto push = disturbance.push_at(world.time());
    world.push({push[0], push[1], push[2]});
    world.advance(laws);
  }

  std::array<cca::hardware::drive_motion, 8> motions() const {
    std::array<cca::hardware::drive_motion, 8> all;
    const auto at = angles();
    const auto measured = [&](std::size_t joint, double torque) {
      all[joint] = {at[joint], (at[joint] - former[joint]) * 1000, torque};
    };
    for (std::size_t leg = 0; leg < axes::leg_count; ++leg) {
      measured(axes::hip_of(leg), world.joints()[4 * leg + 1].torque);
      measured(axes::knee_of(leg), world.joints()[4 * leg + 2].torque);
    }
    return all;
  }

  // Somebody puts the robot down, or sets it on its feet.
  void put_down(cca::sim::world&& w) {
    world = std::move(w);
    former = angles();
  }

  void feel(cca::hardware::board_reading& b) const {
    const auto r = world.reading();
    const auto& q = r.trunk.orientation;
    b.orientation = {q.x, q.y, q.z, q.w};
    b.angular_velocity = {r.trunk.angular_velocity[0], r.trunk.angular_velocity[1],
                          r.trunk.angular_velocity[2]};
    b.specific_force = {r.trunk.specific_force[0], r.trunk.specific_force[1], r.trunk.specific_force[2]};
    for (std::size_t leg = 0; leg < axes::leg_count; ++leg) {
      b.foot_load[leg] = r.legs[leg].foot_force[2];
      b.contact[leg] = r.legs[leg].contact();
      b.abduction[leg] = r.legs[leg].abduction.angle;
    }
  }
  cca::hardware::board_reading board() const {
    cca::hardware::board_reading b;
    feel(b);
    return b;
  }

  cca::sim::world world;
  cca::sim::disturbance disturbance{};

private:
  std::array<double, 8> angles() const {
    std::array<double, 8> all;
    for (std::size_t leg = 0; leg < axes::leg_count; ++leg) {
      all[axes::hip_of(leg)] = world.joints()[4 * leg + 1].angle;
      all[axes::knee_of(leg)] = world.joints()[4 * leg + 2].angle;
    }
    return all;
  }

  std::array<double, 8> former;       // a millisecond ago
  std::array<double, 4> abduction{};  // where its servos shall go
};

}  // namespace hil
