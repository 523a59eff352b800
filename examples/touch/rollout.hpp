#pragma once
// One run of the demonstrator in the Open Dynamics Engine, which is the simulator's unless a program says
// otherwise.
#include <cca/sim/robot.hpp>

#include "engines/any.hpp"

namespace touch {

struct simulated : architecture<cca::sim::robot<arm::description>> {};

}  // namespace touch
