#pragma once
// One run of the demonstrator in the Open Dynamics Engine, which is the simulator's unless a program says
// otherwise.
#include <cca/sim/robot.hpp>

#include "any_engine.hpp"

namespace touch {

struct simulated : architecture<cca::sim::robot<arm::description>> {};

}  // namespace touch
