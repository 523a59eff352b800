// EXPECT: part\.unknown_path: `orders` \(orders\) stops or starts `gait`, but not every mode that has this node lets it be stopped: give it cca::stoppable<\.\.\.> in all of them
// What is stopped in one mode stays so in the next one that has it. So each of them must test whether it
// runs.
#include <cca/modes.hpp>

#include "parts.hpp"

struct orders {
  auto process(cca::beat now) -> cca::stops<"gait"> { return now.index() == 1000; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"orders", orders>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait, cca::stoppable<>>,
                         cca::wire<"cpg.phase", "gait.phase">> {};
struct trot : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
#if CCA_REJECT
                         cca::node<"gait", gait>,
#else
                         cca::node<"gait", gait, cca::stoppable<>>,
#endif
                         cca::wire<"cpg.phase", "gait.phase">> {
};

struct gaits : cca::modes<cca::mode<"walk", walk>, cca::mode<"trot", trot>> {};

cca::controller<gaits> c;
