// The synchronizer of a robot in the Open Dynamics Engine: simulated_node.hpp, with robot_world for its
// world.
#pragma once

#include <cca/sim/robot/simulated_node.hpp>
#include <cca/sim/robot/world/robot_world.hpp>
