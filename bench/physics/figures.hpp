#pragma once
// What the programs of this folder print: a line for each figure, `name <tab> number`. physics.py reads them.
#include <cstdio>

namespace bench {

inline void figure(const char* name, double value) {
  std::printf("%s\t%.17g\n", name, value);
  std::fflush(stdout);
}

}  // namespace bench
