// Prints what require_same_bits() says of this build, or of a thread in another mode: start [upward|flushed]
#include <cfenv>
#include <cstdio>
#include <string_view>

#include <Eigen/Core>

#include <cca/base/math/same_bits.hpp>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

int main(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "";
  if (mode == "upward") std::fesetround(FE_UPWARD);
#if defined(__SSE2__)
  if (mode == "flushed") _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
  try {
    cca::require_same_bits();
  } catch (const cca::refused& problem) {
    std::puts(problem.what());
    return 1;
  }
  std::puts("it has the bits that it has everywhere");
}
