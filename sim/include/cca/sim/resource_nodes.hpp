// A shorter or former path of robot/simulated_robot.hpp: the nodes of a simulated robot.
#pragma once

#include <cca/sim/robot/simulated_robot.hpp>
