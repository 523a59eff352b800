#pragma once
// One run of the Combination of Skills in the Open Dynamics Engine, which is the simulator's unless a program
// says otherwise.
#include <cca/cca.hpp>
#include <cca/sim/oncilla.hpp>

#include "any_engine.hpp"

namespace skills {

struct simulated : architecture<cca::sim::oncilla> {};
using combined = cca::controller<simulated>;

}  // namespace skills
