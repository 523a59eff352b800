#pragma once
// The kinds of uncertainty that the programs of this folder try, each alone, in growing amounts.
#include <string_view>
#include <vector>

#include <cca/sim/uncertain/uncertainty.hpp>

namespace uncertain {

using cca::sim::uncertainty;

struct kind {
  std::string_view name, unit;
  std::vector<double> amounts;  // rising
  void (*set)(uncertainty&, double);
  bool in_compiled_physics = true;
};

inline const std::vector<kind>& kinds() {
  static const std::vector<kind> all{
      {"orientation noise",
       "rad",
       {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5},
       [](uncertainty& u, double x) { u.orientation.noise = x; }},
      {"orientation bias",
       "rad",
       {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5},
       [](uncertainty& u, double x) { u.orientation.bias = x; }},
      {"gyroscope noise",
       "rad/s",
       {0.1, 0.2, 0.5, 1, 2, 5, 10},
       [](uncertainty& u, double x) { u.angular_velocity.noise = x; }},
      {"gyroscope bias",
       "rad/s",
       {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2},
       [](uncertainty& u, double x) { u.angular_velocity.bias = x; }},
      {"angle noise",
       "rad",
       {0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2},
       [](uncertainty& u, double x) { u.angle.noise = x; }},
      {"angle bias",
       "rad",
       {0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3},
       [](uncertainty& u, double x) { u.angle.bias = x; }},
      {"angle resolution",
       "rad",
       {0.0001, 0.0002, 0.0005, 0.001, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5},
       [](uncertainty& u, double x) { u.angle.resolution = x; }},
      {"velocity noise",
       "rad/s",
       {0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1},
       [](uncertainty& u, double x) { u.velocity.noise = x; }},
      {"torque noise",
       "N m",
       {0.05, 0.1, 0.2, 0.5, 1, 2, 5},
       [](uncertainty& u, double x) { u.torque.noise = x; }},
      {"torque bias",
       "N m",
       {0.05, 0.1, 0.2, 0.5, 1, 2, 5},
       [](uncertainty& u, double x) { u.torque.bias = x; }},
      {"force noise",
       "N",
       {0.1, 0.2, 0.5, 1, 2, 5, 10, 20},
       [](uncertainty& u, double x) { u.load.noise = u.foot_load.noise = x, u.load.torque_noise = 0.1 * x; }},
      {"force bias",
       "N",
       {0.1, 0.2, 0.5, 1, 2, 5, 10, 20},
       [](uncertainty& u, double x) { u.load.bias = u.foot_load.bias = x, u.load.torque_bias = 0.1 * x; }},
      {"delay of sensors",
       "s",
       {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2},
       [](uncertainty& u, double x) {
         u.angle.delay = u.velocity.delay = u.torque.delay = u.load.delay = u.orientation.delay =
             u.angular_velocity.delay = u.acceleration.delay = u.foot_load.delay = u.foot_contact.delay = x;
       }},
      {"loss of readings",
       "",
       {0.05, 0.1, 0.2, 0.5, 0.8, 0.9, 0.95, 0.98},
       [](uncertainty& u, double x) {
         u.angle.loss = u.velocity.loss = u.torque.loss = u.load.loss = u.orientation.loss =
             u.angular_velocity.loss = u.acceleration.loss = u.foot_load.loss = u.foot_contact.loss = x;
       }},
      {"delay of drives",
       "s",
       {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2},
       [](uncertainty& u, double x) { u.drives.delay = x; }},
      {"loss of commands",
       "",
       {0.05, 0.1, 0.2, 0.5, 0.8, 0.9, 0.95, 0.98},
       [](uncertainty& u, double x) { u.drives.loss = x; }},
      {"backlash",
       "rad",
       {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5},
       [](uncertainty& u, double x) { u.drives.backlash = x; }},
      {"weaker motors, share lost",
       "",
       {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8},
       [](uncertainty& u, double x) { u.drives.weakness = x; }},
      {"strength of each motor",
       "",
       {0.05, 0.1, 0.15, 0.2, 0.3},
       [](uncertainty& u, double x) { u.drives.strength = x; }},
      {"viscous friction up to",
       "N m s/rad",
       {0.02, 0.05, 0.1, 0.2, 0.5, 1, 2},
       [](uncertainty& u, double x) { u.drives.friction = x; }},
      {"dry friction up to",
       "N m",
       {0.05, 0.1, 0.2, 0.5, 1, 2, 4},
       [](uncertainty& u, double x) { u.drives.dry_friction = x; }},
      {"battery of 12 V, resistance",
       "ohm",
       {0.1, 0.2, 0.5, 1, 2, 5},
       [](uncertainty& u, double x) {
         u.battery.open_circuit = 12, u.battery.resistance = x, u.battery.mean = 0.05;
       }},
      {"masses",
       "",
       {0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3},
       [](uncertainty& u, double x) { u.body.mass = x; }},
      {"lengths",
       "",
       {0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.03, 0.05, 0.1},
       [](uncertainty& u, double x) { u.body.length = x; },
       false},
      {"friction of the ground",
       "",
       {0.05, 0.1, 0.15, 0.2, 0.3},
       [](uncertainty& u, double x) { u.ground.friction = x; }},
      {"slope",
       "rad",
       {0.02, 0.05, 0.1, 0.15, 0.2, 0.3},
       [](uncertainty& u, double x) { u.ground.slope = x; }},
      {"steps",
       "m",
       {0.002, 0.005, 0.01, 0.015, 0.02, 0.03},
       [](uncertainty& u, double x) { u.ground.step = x; }},
  };
  return all;
}

}  // namespace uncertain
