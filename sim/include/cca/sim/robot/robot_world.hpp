// A former path of robot/world/robot_world.hpp: the world of a robot.
#pragma once

#include <cca/sim/robot/world/robot_world.hpp>
