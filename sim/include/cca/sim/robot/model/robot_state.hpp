// The state of a robot's world as a value: put it back, and a run goes on bit for bit.
//
// Forces are cleared by each step, contacts are made in each step, and joints hold no state of their own.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include <cca/mapping/placement.hpp>
#include <cca/robots/inertial.hpp>
#include <cca/sim/robot/model/cable_winch.hpp>
#include <cca/sim/robot/model/contact_account.hpp>
#include <cca/sim/robot/model/drive_condition.hpp>
#include <cca/sim/robot/model/joint_law.hpp>
#include <cca/sim/robot/model/plausible.hpp>
#include <cca/sim/robot/model/saved_body.hpp>

namespace cca::sim {

// What pulls at the end of a part, in the world, until it is set again: N, and N m about that end.
struct outer_load {
  std::array<double, 3> force{}, torque{};
};

using robots::inertial_reading;

struct robot_state {
  std::vector<body_state> bodies;            // the base, if it floats; the links; the balls
  std::vector<joint_law> laws;               // over the coordinates
  std::vector<drive_condition> conditions;   // over the coordinates
  std::vector<joint_reading> joints;         // over the coordinates; torques are means over the beat
  std::vector<std::array<double, 6>> loads;  // of the force sensors: torque, then force; means over the beat
  std::vector<std::array<double, 3>> end_forces;  // N, of the contacts at the ends of the parts; means
  std::vector<cable_winch> winches;               // over the coordinates
  std::vector<inertial_reading> inertial;         // of the inertial units; forces are means over the beat
  std::vector<outer_load> pulls;                  // at the ends of the parts
  std::array<double, 3> push{};                   // N on the base, in the world, until it is set again
  std::vector<contact_account> contacts;          // of the robot's shapes
  double positive_work = 0;                       // J, mechanical work of the motors, without braking
  double absolute_work = 0;                       // J, the same, with braking counted as work
  double parallel_error = 0;                      // rad, the largest so far of links that are held parallel
  std::vector<double> pressing;                   // N, of each pair of shapes
  std::vector<std::array<double, 7>> boxes;       // translation, then rotation
  std::int64_t beats = 0;
  world_trouble trouble{};          // then it stands still
  std::array<double, 3> planned{};  // N, the push that a plan said last

  // FNV-1a over all numbers that a beat of physics depends on or adds to.
  std::uint64_t hash() const {
    std::uint64_t h = 0xcbf29ce484222325U;
    const auto add = [&h](const auto& all) {
      const auto* bytes = reinterpret_cast<const unsigned char*>(all.data());
      for (std::size_t i = 0; i < all.size() * sizeof(all[0]); ++i) h = (h ^ bytes[i]) * 0x100000001b3U;
    };
    add(bodies), add(laws), add(conditions), add(joints), add(loads), add(winches), add(inertial), add(pulls),
        add(pressing), add(boxes), add(push), add(contacts), add(end_forces);
    add(std::array{positive_work, absolute_work, parallel_error});
    add(std::array<std::int64_t, 1>{beats});
    return h;
  }
};

}  // namespace cca::sim
