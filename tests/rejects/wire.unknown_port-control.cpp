// EXPECT: wire\.unknown_port: cca::control_through<`Go`, slower> of this adaptive component names no control input of its module or its criterion; did you mean `go`\?
// A mapping stands on an input that exists.
#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/motor/vite.hpp>

#include "parts.hpp"

// Refused by a static_assert of the adaptive component, before there is a graph.

using go = cca::over<cca::amplitude, cca::go_axis>;
struct slower {
  auto process(cca::in<"input", go> x) -> cca::out<"output", go> { return 0.5 * x.vector(); }
};
#if CCA_REJECT
using on_its_speed = cca::control_through<"Go", slower>;
#else
using on_its_speed = cca::control_through<"go", slower>;
#endif
struct reach : cca::tracker<cca::vite<leg_angles>,
                            cca::tracking<leg_angles>,
                            cca::named<"target", "position", "status">,
                            on_its_speed> {};

struct panel {
  auto process(cca::beat) -> cca::out<"go", go> { return 1.0; }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"panel", panel>,
                         cca::node<"reach", reach>,
                         cca::wire<"stance.angles", "reach.reference">,
                         cca::wire<"stance.angles", "reach.feedback">,
                         cca::wire<"panel.go", "reach.go">> {};

cca::controller<walk> c;
