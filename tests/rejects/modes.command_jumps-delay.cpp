// EXPECT: modes\.command_jumps: `leg\.command` gets its commands from `limits\.safe` in mode `walk` and in mode `rest`, but by wires of different delay or queue, so at a switch they could jump: give both wires the same policy
// The wire from the limiter to the actuator is the same in all modes.
#include <cca/modes.hpp>

#include "parts.hpp"

template <class Policy>
using moving = cca::graph<cca::rate<1000>,
                          cca::node<"stance", stance>,
                          cca::node<"limits", cca::limiter<leg_angles>>,
                          cca::node<"leg", leg>,
                          cca::wire<"stance.angles", "limits.command">,
                          cca::wire<"limits.safe", "leg.command", Policy>>;

struct walk : moving<cca::latest> {};
#if CCA_REJECT
struct rest : moving<cca::delayed<20>> {};
#else
struct rest : moving<cca::latest> {};
#endif

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

cca::controller<legs> c;
