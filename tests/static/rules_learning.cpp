// Rules about learners in a graph: the message of each mistake, and that the mended one is sound.
#include <tuple>

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/learning/timed_requests.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>

#include "rules_parts.hpp"

namespace {

using namespace parts;

// A learner without batches, inside of an adaptive component that exposes its requests.
struct stride : cca::dimension<"stride"> {};
struct online_only : cca::locally_weighted_regression<cca::rhythmic_shape<angles, 10>> {
  static void batch() = delete;
};
struct walking
    : cca::tracker<cca::dmp_rhythmic_module<angles, stride, 10, online_only>, cca::tracking<angles>> {};
struct rhythm {
  auto process(cca::beat) -> std::tuple<cca::out<"phase", cca::over<cca::phase, stride>>,
                                        cca::out<"amplitude", cca::over<cca::amplitude, stride>>> {
    return {0.0, 1.0};
  }
};
template <cca::learning_call First, cca::learning_call Second>
struct school
    : khz<cca::node<"lesson", cca::timed_requests<cca::request_at<0, First>, cca::request_at<9, Second>>>,
          cca::node<"in", rhythm>,
          cca::node<"a", source<angles>>,
          cca::node<"walk", walking>,
          cca::wire<"lesson.learn", "walk.learn">,
          cca::wire<"in.phase", "walk.phase">,
          cca::wire<"in.amplitude", "walk.amplitude">,
          cca::wire<"a.y", "walk.demonstration">,
          cca::wire<"a.y", "walk.reference">,
          cca::wire<"a.y", "walk.feedback">> {};
using call = cca::learning_call;
static_assert(tells<school<call::collect, call::batch>, school<call::learn, call::rest>>(
    {"learner.request", "lesson.learn -> walk.learn",
     "`lesson.learn` may request of `walk.module.learn` (exposed as `walk.learn`) what is not possible "
     "there: `collect` and `batch` need a learner that learns in batches, and this one learns online "
     "only: request `learn`"}));

}  // namespace
