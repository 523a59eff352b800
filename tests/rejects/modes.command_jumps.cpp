// EXPECT: modes\.command_jumps: `leg\.command` gets its commands from `limits\.safe` in mode `walk` but from `other_limits\.safe` in mode `rest`, so at a switch they could jump: put one cca::limiter in front of it that both modes have, of the same path and type
// Every command to an actuator comes from the same limiter by the same kind of wire in all modes: the limiter
// goes on from its last command, so no command jumps at a switch.
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">> {};

#if CCA_REJECT
struct rest : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"other_limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::wire<"stance.angles", "other_limits.command">,
                         cca::wire<"other_limits.safe", "leg.command">> {};
#else
struct rest : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::wire<"stance.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">> {};
#endif

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

cca::controller<legs> c;
