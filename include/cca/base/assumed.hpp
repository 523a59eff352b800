// What a function may assume about its values, as an ordinary function.
#pragma once

#include <cstdint>

#include <cca/base/inlining.hpp>

namespace cca::detail {

// n, which is never negative: clang then needs no sign in `n % 64`.
CCA_GLUE constexpr std::int64_t non_negative(std::int64_t n) {
  CCA_ASSUME(n >= 0);
  return n;
}

}  // namespace cca::detail
