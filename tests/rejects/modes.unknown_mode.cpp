// EXPECT: modes\.unknown_mode: `falling` \(falling\) returns a cca::switch_to<`rets`>, but legs has no such mode; did you mean `rest`\?
// A component asks only for modes that its set has.
#include <cca/modes.hpp>

#include "parts.hpp"

struct falling {
#if CCA_REJECT
  auto process(cca::in<"phase", gait_phase>) -> cca::switch_to<"rets"> { return true; }
#else
  auto process(cca::in<"phase", gait_phase>) -> cca::switch_to<"rest"> { return true; }
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"falling", falling>,
                         cca::wire<"oscillator.phase", "falling.phase">> {};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

cca::controller<legs> c;
