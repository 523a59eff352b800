#pragma once
// A robot to test with: its posture at the start, and the command with which it stands.
#include <cmath>
#include <cstdint>

#include <cca/sim/disturbance.hpp>
#include <cca/sim/world.hpp>

namespace test {

namespace sim = cca::sim;

// Feet 40 mm ahead of the hips, 165 mm below them, where the springs carry the robot.
inline sim::initial_posture crouched() {
  const sim::leg_angles_in_plane q = sim::leg_angles_for(sim::oncilla_defaults, {0.04, -0.165});
  sim::initial_posture p;
  for (auto& l : p.legs) l = {q.hip, q.knee, 0};
  return p;
}

inline sim::robot_command stand() {
  const sim::initial_posture p = crouched();
  sim::robot_command c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = {p.legs[i].hip, p.legs[i].knee, 0, 120};
  return c;
}

// Legs that swing out of phase: a motion that moves every joint.
inline sim::robot_command swinging(std::int64_t beat) {
  sim::robot_command c = stand();
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double phase = 0.02 * static_cast<double>(beat) + 1.6 * static_cast<double>(i);
    c[i].hip += 0.2 * std::sin(phase);
    c[i].knee += 0.3 * std::cos(phase);
    c[i].abduction = 0.1 * std::sin(0.7 * phase);
    c[i].hip_stiffness = 40;
  }
  return c;
}

// Returns the last command. Do not compute it again: its last bit may differ where a compiler evaluates a
// sine at compile time.
inline sim::robot_command run(sim::world& w, std::int64_t from, std::int64_t to) {
  sim::robot_command last;
  for (std::int64_t k = from; k < to; ++k) {
    w.push(k % 300 < 60 ? sim::vector3{3, 7, 0} : sim::vector3{});
    last = swinging(k);
    w.advance(last);
  }
  return last;
}

}  // namespace test
