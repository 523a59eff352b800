// Loops along a branch of a few rows, as straight code.
#pragma once

#include <cstddef>

#include <cca/base/unrolled.hpp>

namespace cca::sim::detail {

// f(0), f(1), ...: straight code, where it is short.
template <std::size_t Size, class F>
constexpr void each_of(F f) {
  if constexpr (Size <= 12) cca::detail::unrolled<static_cast<int>(Size)>(f);
  else
    for (std::size_t k = 0; k < Size; ++k) f(k);
}

// The same up to what each_of<Size> has given.
template <std::size_t Size, class Index, class F>
constexpr void each_before(Index end, F f) {
  if constexpr (Size <= 12) cca::detail::unrolled<end()>(f);
  else
    for (std::size_t k = 0; k < end; ++k) f(k);
}

// f(a constant that is `length`), if `Is` has true there.
template <const auto& Is, class F>
constexpr void with_length(std::size_t length, F f) {
  cca::detail::unrolled<static_cast<int>(Is.size())>([&](auto l) {
    if constexpr (Is[static_cast<std::size_t>(l())])
      if (length == static_cast<std::size_t>(l())) f(l);
  });
}

}  // namespace cca::sim::detail
