// EXPECT: graph\.bad_test_input: two cca::test_input name `servo\.reference`: leave one out
// An input has one test, and one largest amplitude.
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
                         cca::test_input<"servo.reference", cca::up_to<0.1>>,
                         cca::test_input<"servo.reference", cca::up_to<0.2>>,
#endif
                         cca::wire<"plan.wanted", "servo.reference">> {
};
cca::controller<axis> c;
