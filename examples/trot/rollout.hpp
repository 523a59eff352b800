#pragma once
// One run of the trot in the Open Dynamics Engine, which is the simulator's unless a program says otherwise.
#include <cca/cca.hpp>
#include <cca/sim/oncilla.hpp>

#include "any_engine.hpp"

namespace trot {

struct simulated_trot : architecture<cca::sim::oncilla> {};
using trotting = cca::controller<simulated_trot>;

}  // namespace trot
