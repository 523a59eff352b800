// EXPECT: plan\.unknown_path: `leader` \(.*\) asks for `raech\.status`, which nobody publishes under what it observes \(`\*\.status\.\*\|\*\.status`\), so it would wait for ever; did you mean `reach\.status`\?
// A plan asks for what is published under the scope of its sequencer.
#include <cca/adaptive/sequencer.hpp>

#include "parts.hpp"

struct skill {
  auto process(cca::beat) -> cca::out<"status", cca::component_status_port> { return {}; }
};

struct plan : cca::steps<cca::step<"reach">,
#if CCA_REJECT
                         cca::step<"hold", cca::is<"raech.status", cca::component_status::reached>>
#else
                         cca::step<"hold", cca::is<"reach.status", cca::component_status::reached>>
#endif
                         > {
};

struct skills : cca::graph<cca::rate<1000>,
                           cca::node<"reach", skill>,
                           cca::node<"leader", cca::sequencer<"*.status.*", plan>, cca::timed<10>>,
                           cca::node<"log", logbook>> {};

cca::controller<skills> c;
