// A former path of robot/model/robot_state.hpp: the state of a world.
#pragma once

#include <cca/sim/robot/model/robot_state.hpp>
