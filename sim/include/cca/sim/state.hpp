// A shorter or former path of robot/robot_state.hpp: the state of a world.
#pragma once

#include <cca/sim/robot/robot_state.hpp>
