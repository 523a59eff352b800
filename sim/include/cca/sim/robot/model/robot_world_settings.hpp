// The settings of a robot's world.
#pragma once

#include <cca/mapping/placement.hpp>
#include <cca/sim/engine/engine_settings.hpp>
#include <cca/sim/robot/model/body_factors.hpp>
#include <cca/sim/robot/model/plausible.hpp>

namespace cca::sim {

struct robot_world_settings {
  engine_settings engine{};
  int steps_per_beat = 2;
  placement mount{};  // of the base, in the world; of a base that floats, at the start
  plausible_bounds plausible{};
  body_factors body{};  // how the links differ from the description
};

}  // namespace cca::sim
