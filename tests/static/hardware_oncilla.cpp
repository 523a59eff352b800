// An architecture for the simulated Oncilla compiles for the Oncilla on drives.
#include <cca/sim/oncilla.hpp>

#include "../../examples/combination_of_skills/architecture.hpp"
#include "../../examples/hardware_in_the_loop/in_memory.hpp"
#include "../../examples/trot/architecture.hpp"

namespace {

struct trot_in_simulator : trot::architecture<cca::sim::oncilla> {};
static_assert(cca::well_formed<trot_in_simulator>);
static_assert(cca::well_formed<hil::trot_on_drives>);

struct skills_in_simulator : skills::architecture<cca::sim::oncilla> {};
struct skills_on_drives : skills::architecture<hil::oncilla<hil::memory_end>> {};
static_assert(cca::well_formed<skills_in_simulator>);
static_assert(cca::well_formed<skills_on_drives>);

}  // namespace
