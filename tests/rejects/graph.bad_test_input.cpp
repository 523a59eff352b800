// EXPECT: graph\.bad_test_input: `servos\.reference` of a cca::test_input is no input of a node of this graph: write it as in a wire
// A test names an input as a wire does.
#include <cca/cca.hpp>

struct angle : cca::space<cca::joint_angles, cca::axes<cca::x>> {};
struct plan {
  auto process(cca::beat) -> cca::out<"wanted", angle> { return 0.0; }
};
struct servo {
  void process(cca::in<"reference", angle>) {}
};

struct axis : cca::graph<cca::rate<1000>,
                         cca::node<"plan", plan>,
                         cca::node<"servo", servo>,
                         cca::wire<"plan.wanted", "servo.reference">,
#if CCA_REJECT
                         cca::test_input<"servos.reference", cca::up_to<0.1>>
#else
                         cca::test_input<"servo.reference", cca::up_to<0.1>>
#endif
                         > {
};
cca::controller<axis> c;
