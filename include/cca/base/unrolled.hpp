// Loops over a few indices of which one compiles to straight code and the other stays a loop, on every
// compiler.
#pragma once

#include <type_traits>
#include <utility>

#include <cca/base/inlining.hpp>

namespace cca::detail {

template <class F, int... Index>
CCA_INLINE constexpr void unrolled_over(F& f, std::integer_sequence<int, Index...>) {
  CCA_INLINE_CALL(f(std::integral_constant<int, Index>{}), ...);
}

// f(integral_constant 0), f(integral_constant 1), ...: inlined even if f is large.
template <int Count, class F>
CCA_INLINE constexpr void unrolled(F f) {
  if constexpr (Count > 0) unrolled_over(f, std::make_integer_sequence<int, Count>{});
}

// f(0), f(1), ..., in a loop that stays a loop. For code that rarely runs: unrolled it would take
// registers from the rest of the beat.
template <int Count, class F>
CCA_INLINE constexpr void rolled(F f) {
  CCA_STAY_ROLLED
  for (int index = 0; index < Count; ++index) CCA_INLINE_CALL f(index);
}

}  // namespace cca::detail
