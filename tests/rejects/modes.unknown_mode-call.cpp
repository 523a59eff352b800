// EXPECT: modes\.unknown_mode: switch_to names the mode `rets`, which [a-z_]+ lacks; did you mean `rest`\?
// switch_to names a mode of the set.
#include <cca/modes.hpp>

#include "parts.hpp"

// Refused by a static_assert of the controller's function; the graphs are sound.

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

void lie_down(cca::controller<legs>& c) {
#if CCA_REJECT
  c.switch_to<"rets">();
#else
  c.switch_to<"rest">();
#endif
}
