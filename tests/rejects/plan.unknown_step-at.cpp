// EXPECT: plan\.unknown_step: at<`raech`> names a step that the plan lacks; did you mean `reach`\?
// The number of a step is asked for by its name.
#include <cca/adaptive/sequencer.hpp>

struct plan : cca::steps<cca::step<"rest">, cca::step<"reach", cca::after<100>>> {};

#if CCA_REJECT
constexpr int reaching = plan::at<"raech">;
#else
constexpr int reaching = plan::at<"reach">;
#endif
