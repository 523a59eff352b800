// The other translation unit.
#include "two_units.hpp"

void core_test::step_elsewhere(cca::controller<shared>& c) {
  c.step();
  c.run(cca::for_beats<2>{});
}

std::string core_test::picture_elsewhere() { return cca::describe<shared>::mermaid(); }
