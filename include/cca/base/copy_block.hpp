// copy_block<Count>(to, from): copies Count numbers so that g++ can drop the copy.
//
// g++ copies what memcpy copies in pieces of 16 bytes. A loop that it has vectorised stores 32 bytes at a
// time, so it can't see that both are the same numbers, and keeps the copy: a graph of 22 nodes with samples
// of eight axes took 302 instructions per beat instead of 221 (docs/decisions/0017). Pieces of 32 bytes
// match. Without AVX its vectors have 16 bytes, and memcpy matches. clang drops either. Samples of more than
// 64 numbers are copied by memcpy: in pieces they would take long to compile.
#pragma once

#include <cstring>

#include <cca/base/unrolled.hpp>

namespace cca::detail {

template <int Count>
inline void copy_block(double* to, const double* from) {
#if defined(__AVX__) && !defined(__clang__)
  constexpr bool in_pieces = true;
#else
  constexpr bool in_pieces = false;
#endif
  if constexpr (in_pieces) {
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
