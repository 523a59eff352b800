// EXPECT: wire\.unconnected_input: `gait\.phase` is not connected: in walk
// LINES: 20
// The same where a recorder, a tracer and a live_access are made from the controller: they say nothing of
// their own.
#include <cca/deployment.hpp>
#include <cca/record.hpp>
#include <cca/runtime/live/live_access.hpp>
#include <cca/trace.hpp>

#include "parts.hpp"

// A diagnosis does not tell what else the compiler reports.

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"log", logbook>,
#if !CCA_REJECT
                         cca::wire<"oscillator.phase", "gait.phase">,
#endif
                         cca::observe<"gait.angles">> {
};
struct split : cca::deployment<walk, cca::environment<"one", cca::other_nodes>>,
               cca::recordable,
               cca::traceable {};

template <class Controller>
void go(Controller& c) {
  cca::recording::recorder recording(c, "walk.mcap");
  cca::tracer trace(c, "walk.json");
  cca::live_access live(c);
  c.load();
  c.start();
  recording.note("seed", "1");
  c.run(cca::for_<10>{}, cca::at_wall_clock(), live);
  const auto angles = live.newest("gait.angles");
  live.end_run();
  trace.close();
  recording.close();
}
bool replayed() { return bool(cca::recording::replay<split>("walk.mcap")); }

void both(cca::controller<split>& one, cca::deployed<split>& several) {
  go(one);
  go(several);
}
