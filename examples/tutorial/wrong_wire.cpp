// Tutorial, step 5: two wrong graphs, and what the compiler says of them. docs/tutorial/5_wrong_wire.md
#include <cstdio>
#include <string>

#include "swinging_leg.hpp"

// [wrong]
struct wrong_wire : cca::graph<cca::rate<1000>,
                               cca::node<"swing", swing, cca::timed<10>>,
                               cca::node<"impedance", impedance>,
                               cca::node<"limits", cca::limiter<leg_currents>>,
                               cca::node<"leg", simple_leg>,
                               cca::wire<"swing.target", "impedance.target", cca::latest>,
                               cca::wire<"leg.velocities", "impedance.angles">,  // exchanged
                               cca::wire<"leg.angles", "impedance.velocities">,  // exchanged
                               cca::wire<"impedance.currents", "limits.command">,
                               cca::wire<"limits.safe", "leg.currents">> {};
// [wrong end]

// [unlimited]
struct without_limiter : cca::graph<cca::rate<1000>,
                                    cca::node<"swing", swing, cca::timed<10>>,
                                    cca::node<"impedance", impedance>,
                                    cca::node<"leg", simple_leg>,
                                    cca::wire<"swing.target", "impedance.target", cca::latest>,
                                    cca::wire<"leg.angles", "impedance.angles">,
                                    cca::wire<"leg.velocities", "impedance.velocities">,
                                    cca::wire<"impedance.currents", "leg.currents">> {};
// [unlimited end]

// [program]
#ifdef TUTORIAL_MISTAKE
static_assert(cca::check<wrong_wire>());  // does not compile
#endif
static_assert(cca::check<swinging_leg>());

// The same sentence as a value, for tests and tools.
static_assert(cca::diagnosis<wrong_wire>.rule == "space.mismatch");
static_assert(cca::diagnosis<without_limiter>.rule == "robot.unlimited_command");

int main() {
  std::printf("%s\n", std::string(cca::diagnosis<wrong_wire>.message).c_str());
  std::printf("%s\n", std::string(cca::diagnosis<without_limiter>.message).c_str());
}
// [program end]
