// EXPECT: learner\.request: `lesson\.learn` may request of `ik\.learn` what is not possible there: `learn` needs a learner that learns online, and this one learns in batches only: request `collect`, and then `batch`
// An extreme learning machine learns in batches only, and this component says which requests it publishes. A
// learner without batches learns online only. A component that requests something of an adaptive component's
// learner is wired to the adaptive component.
#include <cca/adaptive/extreme_learning_machine.hpp>
#include <cca/adaptive/learning/timed_requests.hpp>
#include <cca/mapping/adaptive_mapping.hpp>

#include "parts.hpp"

using machine = cca::extreme_learning_machine<cca::elm_function<leg_angles, leg_angles, 10>>;

#if CCA_REJECT
using lesson = cca::timed_requests<cca::request_at<0, cca::learning_call::learn>>;
#else
using lesson = cca::timed_requests<cca::request_at<0, cca::learning_call::collect>,
                                   cca::request_at<1000, cca::learning_call::batch>>;
#endif
struct school : cca::graph<cca::rate<1000>,
                           cca::node<"log", logbook>,
                           cca::node<"lesson", lesson>,
                           cca::node<"stance", stance>,
                           cca::node<"ik", cca::adaptive_mapping<leg_angles, leg_angles, machine>>,
                           cca::wire<"lesson.learn", "ik.learn">,
                           cca::wire<"stance.angles", "ik.input">,
                           cca::wire<"stance.angles", "ik.teacher">> {};

cca::controller<school> c;
