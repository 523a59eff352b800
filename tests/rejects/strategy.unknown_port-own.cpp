// EXPECT: strategy\.unknown_port: the strategy of the node `recorder` reads the input `angle`, which its component, recorder, lacks; did you mean `angles`\?
// A strategy of your own reads inputs that the component has.
#include "parts.hpp"

// Refused by a static_assert where the strategy asks; `fires` is code, into which no diagnosis looks.

struct when_far {
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& inputs) {
#if CCA_REJECT
    return inputs.template get<"angle">().vector().norm() > 1;
#else
    return inputs.template get<"angles">().vector().norm() > 1;
#endif
  }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder, when_far>,
                         cca::wire<"stance.angles", "recorder.angles", cca::latest>> {};

void beat(cca::controller<walk>& c) { c.step(); }
