#pragma once
// A robot to test with: its posture at the start, and the laws with which it stands.
#include <array>
#include <cmath>
#include <cstdint>

#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/oncilla/world.hpp>

namespace test {

namespace sim = cca::sim;

using laws = std::array<sim::joint_law, cca::robots::oncilla::as_built::drives.size()>;

inline sim::initial_posture crouched() { return sim::standing_posture(); }

// The laws of servos with the stiffnesses of the robot.
inline laws laws_of(const sim::robot_command& wanted) {
  laws all{};
  for (std::size_t leg = 0; leg < wanted.size(); ++leg) {
    const sim::leg_command& c = wanted[leg];
    all[4 * leg] = {.position = c.abduction, .stiffness = 80, .damping = 0.8};
    all[4 * leg + 1] = {.position = c.hip, .stiffness = c.hip_stiffness, .damping = 0.0125 * c.hip_stiffness};
    all[4 * leg + 2] = {.position = c.knee, .stiffness = 80};
  }
  return all;
}

inline sim::robot_command standing_command() {
  const sim::initial_posture p = crouched();
  sim::robot_command c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = {p.legs[i].hip, p.legs[i].knee, 0, 120};
  return c;
}
inline laws stand() { return laws_of(standing_command()); }

// Legs that swing out of phase: a motion that moves every joint.
inline laws swinging(std::int64_t beat) {
  sim::robot_command c = standing_command();
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double phase = 0.02 * static_cast<double>(beat) + 1.6 * static_cast<double>(i);
    c[i].hip += 0.2 * std::sin(phase);
    c[i].knee += 0.3 * std::cos(phase);
    c[i].abduction = 0.1 * std::sin(0.7 * phase);
    c[i].hip_stiffness = 40;
  }
  return laws_of(c);
}

// Returns the last laws. Do not compute them again: their last bit may differ where a compiler evaluates a
// sine at compile time.
inline laws run(sim::world& w, std::int64_t from, std::int64_t to) {
  laws last{};
  for (std::int64_t k = from; k < to; ++k) {
    w.push(k % 300 < 60 ? Eigen::Vector3d(3, 7, 0) : Eigen::Vector3d(0, 0, 0));
    last = swinging(k);
    w.advance(last);
  }
  return last;
}

}  // namespace test
