// EXPECT: node\.unknown_path: walk has no node `cgp`; did you mean `cpg`\?
// The same for parameters.
#include "parts.hpp"

struct pacemaker {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, pace));
  } p{1.0};
  auto process(cca::beat now) -> cca::out<"phase", gait_phase> { return p.pace * now.dt(); }
};
struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"cpg", pacemaker>> {};

void use(cca::controller<walk>& c) {
#if CCA_REJECT
  c.set<"cgp">({1.5});
#else
  c.set<"cpg">({1.5});
#endif
}
