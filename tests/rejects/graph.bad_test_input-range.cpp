// EXPECT: graph\.bad_test_input: the test of the input `reference` of `servo` has no largest amplitude: give the axes limits, or state it
// The amplitude of a test has a bound: the limits of the axes, or the one that the declaration states.
#include <cca/cca.hpp>

struct angle : cca::space<cca::joint_angles, cca::axes<cca::x>> {};
struct plan {
  auto process(cca::beat) -> cca::out<"wanted", angle> { return 0.0; }
};
struct servo {
  void process(cca::in<"reference", angle>, cca::optional_in<"velocity", angle>) {}
};

struct axis : cca::graph<cca::rate<1000>,
                         cca::node<"plan", plan>,
                         cca::node<"servo", servo>,
#if CCA_REJECT
                         cca::test_input<"servo.reference">,
#endif
                         cca::wire<"plan.wanted", "servo.reference">> {
};
cca::controller<axis> c;
