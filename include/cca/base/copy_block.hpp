// copy_block<Count>(to, from): copies Count numbers so that the compiler can drop the copy. inlining.hpp says
// where it copies in pieces, and why.
#pragma once

#include <cstring>

#include <cca/base/unrolled.hpp>

namespace cca::detail {

template <int Count>
inline void copy_block(double* to, const double* from) {
  if constexpr (copies_in_pieces) {
    using four [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;
    unrolled<Count / 4>(
        [&](auto i) { *reinterpret_cast<four*>(to + 4 * i) = *reinterpret_cast<const four*>(from + 4 * i); });
    constexpr int rest = Count % 4;
    if constexpr (rest > 0) std::memcpy(to + Count - rest, from + Count - rest, sizeof(double) * rest);
  } else {
    std::memcpy(to, from, sizeof(double) * Count);
  }
}

}  // namespace cca::detail
