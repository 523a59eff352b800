// EXPECT: learner\.model: the learner of this adaptive mapping adapts the model .* from paw \(.*\) to leg_torques \(.*\), and the mapping is from paw \(.*\) to leg_angles
// This learner leads to torques, but the mapping to angles.
#include <cca/adaptive/extreme_learning_machine.hpp>
#include <cca/mapping/adaptive_mapping.hpp>

#include "parts.hpp"

struct hip_frame : cca::frame<"hip"> {};
struct paw : cca::space<cca::cartesian_position<hip_frame>, cca::axes<cca::x, cca::z>> {};
#if CCA_REJECT
using learner = cca::extreme_learning_machine<cca::elm_function<paw, leg_torques, 40>>;
#else
using learner = cca::extreme_learning_machine<cca::elm_function<paw, leg_angles, 40>>;
#endif

struct ball {
  auto process(cca::beat) -> cca::out<"position", paw> { return {}; }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"ball", ball>,
                         cca::node<"ik", cca::adaptive_mapping<paw, leg_angles, learner>>,
                         cca::wire<"ball.position", "ik.input">> {};

cca::controller<walk> c;
