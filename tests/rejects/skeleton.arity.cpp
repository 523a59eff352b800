// EXPECT: skeleton\.arity: `blend` \(blend<.*>\) blends 3 sources by 2 weights, but it takes one for each source, or of two sources one: give it a space of weights with 3 axes
// A skeleton needs parts that fit it. A blend of three needs a weight for each. An arbiter and a switch need
// two sources. A stage of a pipeline takes what the stage before it returns, and nothing else. A farm shares
// out a whole number of parts, and a worker on a thread is no graph, because a graph belongs to the loop. A
// splitter and a collector need a number for each axis, which a quaternion does not have. Of two rates one is
// a whole multiple of the other, and a hold changes the rate and nothing else.
#include "parts.hpp"

struct two_weights : cca::space<cca::amplitude, cca::axes<cca::x, cca::y>> {};
struct three_weights : cca::space<cca::amplitude, cca::axes<cca::x, cca::y, cca::z>> {};
#if CCA_REJECT
using weights = two_weights;
#else
using weights = three_weights;
#endif

struct mood {
  auto process(cca::beat) -> cca::out<"mood", weights> { return {}; }
};

struct walk
    : cca::graph<cca::rate<1000>,
                 cca::node<"stance", stance>,
                 cca::node<"swing", stance>,
                 cca::node<"reach", stance>,
                 cca::node<"mood", mood>,
                 cca::node<"recorder", recorder>,
                 cca::node<"blend", cca::blend<"angles", leg_angles, weights, "stance", "swing", "reach">>,
                 cca::wire<"mood.mood", "blend.weight">,
                 cca::wire<"stance.angles", "blend.stance">,
                 cca::wire<"swing.angles", "blend.swing">,
                 cca::wire<"reach.angles", "blend.reach">,
                 cca::wire<"blend.angles", "recorder.angles">> {};

cca::controller<walk> c;
