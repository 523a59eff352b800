// Every number of the simulated Oncilla in one table: its body (cca/robots/oncilla/body.hpp), the gains of
// its servos, the contact with the ground and the physics engine.
//
// All numbers here are CHOSEN; body.hpp says which of the robot's are published. SI units and radians.
//
// The table is a value: change a copy to simulate another robot. The joint limits of the axes are fixed at
// compile time, by the body that the copy starts with.
#pragma once

#include <cca/robots/oncilla/body.hpp>
#include <cca/robots/oncilla/former_names.hpp>
#include <cca/sim/robot/engine_settings.hpp>

namespace cca::sim {

struct oncilla_model : robots::oncilla::body_numbers {
  // Servos. Hip and abduction servos follow their targets with stiffness and damping; the knee's motor winds
  // a cable.
  double hip_stiffness = 30.0;         // N m/rad while trotting; 120 to stand and reach
  double hip_damping_time = 0.0125;    // damping = stiffness * this time, s
  double hip_feed_forward_speed = 20;  // rad/s, the fastest speed of the target that is fed forward
  double cable_stiffness = 80.0;       // N m/rad
  double cable_damping = 0.4;          // N m s/rad
  double abduction_stiffness = 80.0;
  double abduction_damping = 0.8;

  // Contact of feet, knees, ankles and trunk with the ground.
  double contact_stiffness = 40e3;  // N/m
  double contact_damping = 200.0;   // N s/m
  double surface_layer = 0.0005;    // m, depth that is not corrected
  double correcting_speed = 1.0;    // m/s

  // Engine.
  double gravity = 9.81;
  double step = 0.0005;    // s
  int steps_per_beat = 2;  // a beat is 1 ms
  double world_cfm = 1e-9;
  double world_erp = 0.2;
  double pantograph_erp = 0.3;
  double pantograph_cfm = 1e-8;

  constexpr double beat() const { return step * steps_per_beat; }
  constexpr engine_settings engine() const {
    return {gravity, world_erp, world_cfm, correcting_speed, surface_layer};
  }
};

inline constexpr oncilla_model oncilla_defaults{};

}  // namespace cca::sim
