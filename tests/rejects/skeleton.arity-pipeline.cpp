// EXPECT: skeleton\.arity: `signal` \(pipeline<.*>\) is a pipeline whose stage 1 correct has 2 inputs that must be wired and 1 output \(of a status none counts\), but it takes what has one
// This stage needs more than the stage before it returns.
#include "parts.hpp"

struct correct {
#if CCA_REJECT
  auto process(cca::in<"angles", leg_angles> a, cca::in<"offset", leg_angles> b)
      -> cca::out<"angles", leg_angles> {
    return a.vector() - b.vector();
  }
#else
  auto process(cca::in<"angles", leg_angles> a, cca::optional_in<"offset", leg_angles> b)
      -> cca::out<"angles", leg_angles> {
    return a.vector() - b.vector();
  }
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"signal", cca::pipeline<posture, correct>>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"stance.angles", "signal.input">,
                         cca::wire<"signal.output", "recorder.angles">> {};

cca::controller<walk> c;
