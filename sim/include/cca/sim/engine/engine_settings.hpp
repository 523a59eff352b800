// The settings of one world of the physics engine. All defaults are CHOSEN.
#pragma once

namespace cca::sim {

struct engine_settings {
  double gravity = 9.81;  // m/s^2, down
  double erp = 0.2;       // of joints: the share of an error that a step corrects
  double cfm = 1e-9;
  double correcting_speed = 1.0;  // m/s, of contacts
  double surface_layer = 0.0005;  // m, depth of contacts that is not corrected
};

}  // namespace cca::sim
