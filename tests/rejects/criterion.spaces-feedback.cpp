// EXPECT: criterion\.spaces: the criterion of this adaptive component measures in leg_angles \(.*\), but its feedback_through<\.\.\.> maps to leg_torques \(.*\): the domain types differ
// The criterion measures joint angles, but the mapping of the feedback returns torques.
#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/mapping/mapping.hpp>
#include <cca/motor/vite.hpp>

#include "parts.hpp"

struct encoder : cca::space<cca::number, cca::axes<hip, knee>> {};
struct radians {
  Eigen::Vector2d operator()(const Eigen::Vector2d& counts) const { return 1e-3 * counts; }
};
#if CCA_REJECT
using counted = cca::mapping<encoder, leg_torques, radians>;
#else
using counted = cca::mapping<encoder, leg_angles, radians>;
#endif
struct reach : cca::tracker<cca::vite<leg_angles>,
                            cca::tracking<leg_angles>,
                            cca::named<"target", "position", "status">,
                            cca::feedback_through<counted>> {};

struct counter {
  auto process(cca::beat) -> cca::out<"counts", encoder> { return {}; }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"counter", counter>,
                         cca::node<"reach", reach>,
                         cca::wire<"stance.angles", "reach.reference">,
                         cca::wire<"counter.counts", "reach.feedback">> {};

cca::controller<walk> c;
