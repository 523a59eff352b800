// EXPECT: criterion\.spaces: the criterion of this adaptive component measures in paw \(.*\), but the target of its module is in leg_angles \(.*\): the domain types differ
// The module commands joint angles, but the criterion measures a paw.
#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/motor/vite.hpp>

#include "parts.hpp"

struct paw : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::z>> {};
#if CCA_REJECT
using follows = cca::tracking<paw>;
#else
using follows = cca::tracking<leg_angles>;
#endif
struct reach : cca::tracker<cca::vite<leg_angles>, follows, cca::named<"target", "position", "status">> {};

struct camera {
#if CCA_REJECT
  auto process(cca::beat) -> cca::out<"seen", paw> { return {}; }
#else
  auto process(cca::beat) -> cca::out<"seen", leg_angles> { return {}; }
#endif
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"camera", camera>,
                         cca::node<"reach", reach>,
                         cca::wire<"stance.angles", "reach.reference">,
                         cca::wire<"camera.seen", "reach.feedback">> {};

cca::controller<walk> c;
