// What must hold, whatever the bytes are: else the fuzzer has found something.
#pragma once

#include <cstdlib>

namespace fuzz {

inline void must(bool holds) {
  if (!holds) std::abort();
}

}  // namespace fuzz
