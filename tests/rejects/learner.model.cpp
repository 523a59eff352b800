// EXPECT: learner\.model: the learner of this module adapts the model discrete_shape<leg_angles, 25>, and the module runs rhythmic_shape<leg_angles, 25>
// This learner learns discrete shapes, but the module runs a rhythmic one.
#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>

#include "parts.hpp"

struct stride : cca::dimension<"stride"> {};
#if CCA_REJECT
using learner = cca::locally_weighted_regression<cca::discrete_shape<leg_angles, 25>>;
#else
using learner = cca::locally_weighted_regression<cca::rhythmic_shape<leg_angles, 25>>;
#endif
struct dmp
    : cca::tracker<cca::dmp_rhythmic_module<leg_angles, stride, 25, learner>, cca::tracking<leg_angles>> {};

struct source {
  auto process(cca::beat) -> std::tuple<cca::out<"phase", cca::over<cca::phase, stride>>,
                                        cca::out<"amplitude", cca::over<cca::amplitude, stride>>> {
    return {0.0, 1.0};
  }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"in", source>,
                         cca::node<"stance", stance>,
                         cca::node<"dmp", dmp>,
                         cca::wire<"in.phase", "dmp.phase">,
                         cca::wire<"in.amplitude", "dmp.amplitude">,
                         cca::wire<"stance.angles", "dmp.reference">,
                         cca::wire<"stance.angles", "dmp.feedback">> {};

cca::controller<walk> c;
