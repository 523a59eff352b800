// EXPECT: modes\.missing_robot: the resource node `leg` \(leg\) is in mode `walk` but not in mode `rest`, so after a switch nothing would command it or go on stopping it: put it into every mode, under the same path
// Every mode has all resource nodes. One that a mode lacks would be driven by nobody, and nobody would go on
// stopping it.
#include <cca/modes.hpp>

#include "parts.hpp"

template <cca::fixed_string Wire, class... More>
using moving = cca::graph<cca::rate<1000>,
                          cca::node<"stance", stance>,
                          cca::node<"limits", cca::limiter<leg_angles>>,
                          cca::node<"leg", leg>,
                          cca::wire<"stance.angles", "limits.command">,
                          cca::wire<Wire, "leg.command">,
                          More...>;

struct walk : moving<"limits.safe"> {};
#if CCA_REJECT
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
#else
struct rest : moving<"limits.safe", cca::node<"log", logbook>> {};
#endif

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

cca::controller<legs> c;
