// The Combination of Skills compiles for any robot with the Oncilla's ports: the simulated one, and one
// without a simulator.
#include "../../examples/combination_of_skills/architecture.hpp"
#include "../../examples/combination_of_skills/idle_robot.hpp"

#include <cca/sim/oncilla.hpp>

struct simulated : skills::architecture<cca::sim::oncilla> {};
struct idle : skills::architecture<skills::idle_robot> {};

static_assert(cca::well_formed<simulated>);
static_assert(cca::well_formed<idle>);
