// The exit codes, and the error for a wrong command line.
#pragma once

#include <stdexcept>
#include <string>

#include <cca/base/refused.hpp>

namespace cca_can {

enum ending : int {
  done = 0,
  failed = 1,         // a drive or a bus: no answer, a fault, silence. What was enabled has been disabled.
  misunderstood = 2,  // the command line
  refused = 3,        // a file or an interface
  not_confirmed = 4,  // nobody confirmed
  interrupted = 130,  // ctrl-c: stopped, and disabled
};

struct usage_error : std::runtime_error {
  using runtime_error::runtime_error;
};

}  // namespace cca_can
