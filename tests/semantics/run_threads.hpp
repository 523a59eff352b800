// Architectures with farms on threads. After each beat one waits until the workers have nothing left to do:
// so it doesn't depend on the threads when a result comes, and the interpreter can say it.
#pragma once

#include <cca/skeleton/farm_on_threads.hpp>

#include "run.hpp"

namespace semantics {

// A worker, who is no probe: another thread can't write into the log of the loop.
template <class From, class To>
struct apprentice {
  int done = 0;
  auto process(cca::in<"x", From> x) -> cca::out<"y", To> { return practised(x.vector()[0], done++); }
};

}  // namespace semantics
