// Loops over a few indices of which one compiles to straight code and the other stays a loop, on every
// compiler.
#pragma once

#include <type_traits>
#include <utility>

#include <cca/base/inlining.hpp>

namespace cca::detail {

template <class F, int... Index>
CCA_GLUE constexpr void unrolled_over(F& f, std::integer_sequence<int, Index...>) {
  CCA_INLINE_CALL(f(std::integral_constant<int, Index>{}), ...);
}

// f(integral_constant 0), f(integral_constant 1), ...: without this clang calls f if it is large.
template <int Count, class F>
CCA_GLUE constexpr void unrolled(F f) {
  unrolled_over(f, std::make_integer_sequence<int, Count>{});
}

// f(0), f(1), ..., in a loop that clang does not unroll. For code that rarely runs: unrolled it would take
// registers from the rest of the beat.
template <int Count, class F>
CCA_GLUE constexpr void rolled(F f) {
  CCA_STAY_ROLLED
  for (int index = 0; index < Count; ++index) CCA_INLINE_CALL f(index);
}

}  // namespace cca::detail
