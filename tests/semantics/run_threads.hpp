// Architectures with farms on threads. Each beat waits until the workers are idle, so a result arrives in the
// same beat in every run and the interpreter can predict it.
#pragma once

#include <cca/skeleton/farm_on_threads.hpp>

#include "run.hpp"

namespace semantics {

// A worker is no probe: another thread cannot write into the log of the loop.
template <class From, class To>
struct apprentice {
  int done = 0;
  auto process(cca::in<"x", From> x) -> cca::out<"y", To> { return worker_result(x.vector()[0], done++); }
};

}  // namespace semantics
