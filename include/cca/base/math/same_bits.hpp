// Same bits of a whole program: refuses a build that computes other bits than the builds of other compilers
// and machines. CMake's target cca::same_bits, or the option CCA_SAME_BITS, gives a program the flags that it
// takes and includes this in each file that includes cca. docs/same_bits.md says which flags, and what each
// costs.
//
//   cca::require_same_bits();    throws cca::refused, with a sentence: what breaks the promise, what to change
//   cca::same_bits_problem()     the sentence, or nothing
//
// A controller's load() requires it where CCA_SAME_BITS is defined.
//
// Errors, when it is compiled: math.fast (rounding.hpp); with CCA_SAME_BITS math.vectorised, else at start.
// At start, since no compiler tells of them: math.fused, a product is added before it is rounded, in any file
// that includes this; math.fast, of parts of -ffast-math that a compiler may not tell; math.rounding and
// math.subnormal, of the thread that asks. Cost: microseconds before main, for each file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <cca/base/math/rounding.hpp>
#include <cca/base/refused.hpp>

#if defined(CCA_SAME_BITS) && (!defined(EIGEN_DONT_VECTORIZE) || defined(EIGEN_VECTORIZE))
#error \
    "math.vectorised: Eigen adds in another order on each machine: compile with -DEIGEN_DONT_VECTORIZE, or link cca::same_bits"
#endif

namespace cca {
namespace detail {

// The first that a file of the program has found.
inline const char* broken_bits = nullptr;

// Products and sums, as this file's flags compile them; and one after the other, each rounded. In the forms
// in which compilers are known to fuse: alone, beside others, in a loop.
namespace {

struct bit_probe {
  static constexpr int size = 8;
  double a[size], b[size], c[size];

  [[gnu::noinline]] void fuse_alone(double* to) const {
    for (int i = 0; i < size; ++i) to[i] = one(a[i], b[i], c[i]);
  }
  [[gnu::noinline]] static double one(double x, double y, double z) { return x * y + z; }
  [[gnu::noinline]] void round_alone(double* to) const {
    for (int i = 0; i < size; ++i) to[i] = rounded(a[i] * b[i]) + c[i];
  }

  [[gnu::noinline]] void fuse_beside(double* to) const {
    const double x = a[0] * b[0] - a[1] * b[1], y = a[0] * b[1] + a[1] * b[0];
    to[0] = c[0] + a[2] * x;
    to[1] = c[1] + a[2] * y;
    for (int i = 2; i < size; ++i) to[i] = 0;
  }
  [[gnu::noinline]] void round_beside(double* to) const {
    const double x = rounded(a[0] * b[0]) - rounded(a[1] * b[1]),
                 y = rounded(a[0] * b[1]) + rounded(a[1] * b[0]);
    to[0] = c[0] + rounded(a[2] * x);
    to[1] = c[1] + rounded(a[2] * y);
    for (int i = 2; i < size; ++i) to[i] = 0;
  }

  [[gnu::noinline]] void fuse_in_loop(double* __restrict to) const {
    for (int i = 0; i < size; i += 2) {
      to[i] = a[i] * b[i] - c[i];
      to[i + 1] = a[i + 1] * b[i + 1] + c[i + 1];
    }
  }
  [[gnu::noinline]] void round_in_loop(double* to) const {
    for (int i = 0; i < size; i += 2) {
      to[i] = rounded(a[i] * b[i]) - c[i];
      to[i + 1] = rounded(a[i + 1] * b[i + 1]) + c[i + 1];
    }
  }

  // What only -freciprocal-math and -fassociative-math, parts of -ffast-math, may compute otherwise.
  [[gnu::noinline]] void reorder(double* to) const {
    double sum = 0;
    const double by = b[0];
    for (int i = 0; i < size; ++i) sum += a[i];
    for (int i = 0; i < size; i += 2) {
      to[i] = a[i] / by;
      to[i + 1] = (sum + b[i]) - sum;
    }
  }
  [[gnu::noinline]] void keep_order(double* to) const {
    double sum = 0;
    for (int i = 0; i < size; ++i) sum = rounded(sum + a[i]);
    for (int i = 0; i < size; i += 2) {
      to[i] = a[i] / rounded(b[0]);
      to[i + 1] = rounded(sum + b[i]) - sum;
    }
  }

  static double rounded(double product) {
    volatile double kept_apart = product;
    return kept_apart;
  }
  bool differs(void (bit_probe::*as_compiled)(double*) const,
               void (bit_probe::*by_steps)(double*) const) const {
    double one_way[size], other_way[size];
    (this->*as_compiled)(one_way);
    (this->*by_steps)(other_way);
    for (int i = 0; i < size; ++i)
      if (std::bit_cast<std::int64_t>(one_way[i]) != std::bit_cast<std::int64_t>(other_way[i])) return true;
    return false;
  }
  static const char* problem() {
    std::uint64_t state = 88172645463325252u;
    const auto draw = [&state] {  // 1 to 2
      state ^= state << 13, state ^= state >> 7, state ^= state << 17;
      return std::bit_cast<double>(std::int64_t(state >> 12) | std::int64_t{0x3ff} << 52);
    };
    for (int k = 0; k < 16; ++k) {
      bit_probe p;
      for (int i = 0; i < size; ++i) p.a[i] = draw(), p.b[i] = draw(), p.c[i] = draw();
      if (p.differs(&bit_probe::fuse_alone, &bit_probe::round_alone) ||
          p.differs(&bit_probe::fuse_beside, &bit_probe::round_beside) ||
          p.differs(&bit_probe::fuse_in_loop, &bit_probe::round_in_loop))
        return "math.fused: this program adds products before they are rounded, so it has other bits on a "
               "machine that can't: link cca::same_bits, or compile all of it with -ffp-contract=off and as "
               "docs/same_bits.md says";
      if (p.differs(&bit_probe::reorder, &bit_probe::keep_order))
        return "math.fast: this program adds or divides in another order than it is written, as with "
               "-ffast-math or a part of it: compile all of it without that option";
    }
    return nullptr;
  }
};
[[maybe_unused]] const bool bits_are_probed = [] {
#if !defined(EIGEN_DONT_VECTORIZE) || defined(EIGEN_VECTORIZE)
  broken_bits =
      "math.vectorised: Eigen adds in another order on each machine: link cca::same_bits, or compile all of "
      "it with -DEIGEN_DONT_VECTORIZE";
#endif
  if (const char* const found = bit_probe::problem()) broken_bits = found;
  return true;
}();

}  // namespace
}  // namespace detail

inline std::string_view same_bits_problem() {
  if (detail::broken_bits != nullptr) return detail::broken_bits;
  const volatile double one = 1, half_unit = 0x1p-53, more = 0x1.8p-53, small = 0x1p-1022, tiny = 0x1p-1074;
  if (one + half_unit != one || one + more == one || -one - half_unit != -one)
    return "math.rounding: this thread does not round to nearest: call std::fesetround(FE_TONEAREST), or "
           "find what set "
           "another mode";
  if (small * 0.5 == 0 || tiny * 0x1p1000 == 0)
    return "math.subnormal: this thread takes subnormal numbers for 0: find what sets flush-to-zero, as "
           "linking with "
           "-ffast-math does";
  return {};
}

inline void require_same_bits() {
  if (const std::string_view problem = same_bits_problem(); !problem.empty())
    throw refused(std::string(problem));
}

}  // namespace cca
