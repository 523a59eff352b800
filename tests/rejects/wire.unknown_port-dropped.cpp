// EXPECT: wire\.unknown_port: dropped<`recorder\.angels`>\(\) names no input of walk; did you mean `recorder\.angles`\?
// Who asks what a queue has lost names an input.
#include "parts.hpp"

// Refused by a static_assert of the controller's function; the graph is sound.

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder, cca::timed<2>>,
                         cca::wire<"stance.angles", "recorder.angles", cca::queue<4>>> {};

std::int64_t lost(const cca::controller<walk>& c) {
#if CCA_REJECT
  return c.dropped<"recorder.angels">();
#else
  return c.dropped<"recorder.angles">();
#endif
}
