// What a function may assume about its values, as an ordinary function.
#pragma once

#include <cstdint>

#include <cca/base/inlining.hpp>

namespace cca::detail {

// n, which is never negative, so that `n % 64` needs no sign.
CCA_INLINE constexpr std::int64_t non_negative(std::int64_t n) {
  CCA_ASSUME(n >= 0);
  return n;
}

}  // namespace cca::detail
