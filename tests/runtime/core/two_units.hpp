#pragma once
// One controller, used by two translation units.
#include "counting.hpp"

namespace core_test {

struct shared : cca::graph<cca::rate<1000>,
                           cca::node<"counter", counter>,
                           cca::node<"log", journal>,
                           cca::wire<"counter.y", "log.x">,
                           cca::observe<"counter.*">> {};

void step_elsewhere(cca::controller<shared>& c);
std::string picture_elsewhere();

}  // namespace core_test
