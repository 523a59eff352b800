// EXPECT: strategy\.not_stoppable: `greeting` \(greeting\) returns cca::done, by which it stops itself, but its strategy does not let it be stopped: write cca::stoppable<\.\.\.> around the strategy
// A component that has finished stops itself. Its node must allow that, because the loop asks each component
// that can be stopped in each beat whether it runs.
#include "parts.hpp"

struct greeting {
  auto process() -> std::tuple<cca::out<"angles", leg_angles>, cca::done> {
    return {Eigen::Vector2d(0.1, 0.2), ++steps == 100};
  }
  int steps = 0;
};

struct wave : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"greeting", greeting, cca::timed<2>>
#else
                         cca::node<"greeting", greeting, cca::stoppable<cca::timed<2>>>
#endif
                         > {
};

cca::controller<wave> c;
