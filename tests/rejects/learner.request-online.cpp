// EXPECT: learner\.request: `lesson\.learn` may request of `walk\.module\.learn` \(exposed as `walk\.learn`\) what is not possible there: `collect` and `batch` need a learner that learns in batches, and this one learns online only: request `learn`
// This learner has no batch. The component that requests one is wired to the adaptive component around it.
#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/learning/timed_requests.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>

#include "parts.hpp"

struct stride : cca::dimension<"stride"> {};
using shape = cca::rhythmic_shape<leg_angles, 10>;
struct online_only : cca::locally_weighted_regression<shape> {
  static void batch() = delete;
};
struct dmp
    : cca::tracker<cca::dmp_rhythmic_module<leg_angles, stride, 10, online_only>, cca::tracking<leg_angles>> {
};

#if CCA_REJECT
using lesson = cca::timed_requests<cca::request_at<0, cca::learning_call::collect>,
                                   cca::request_at<1000, cca::learning_call::batch>>;
#else
using lesson = cca::timed_requests<cca::request_at<0, cca::learning_call::learn>,
                                   cca::request_at<1000, cca::learning_call::rest>>;
#endif
struct source {
  auto process(cca::beat) -> std::tuple<cca::out<"phase", cca::over<cca::phase, stride>>,
                                        cca::out<"amplitude", cca::over<cca::amplitude, stride>>> {
    return {0.0, 1.0};
  }
};
struct school : cca::graph<cca::rate<1000>,
                           cca::node<"log", logbook>,
                           cca::node<"lesson", lesson>,
                           cca::node<"in", source>,
                           cca::node<"stance", stance>,
                           cca::node<"walk", dmp>,
                           cca::wire<"lesson.learn", "walk.learn">,
                           cca::wire<"in.phase", "walk.phase">,
                           cca::wire<"in.amplitude", "walk.amplitude">,
                           cca::wire<"stance.angles", "walk.demonstration">,
                           cca::wire<"stance.angles", "walk.reference">,
                           cca::wire<"stance.angles", "walk.feedback">> {};

cca::controller<school> c;
