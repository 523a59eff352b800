// Times of origin, in nanoseconds since beat 0.
#pragma once

#include <cstdint>
#include <limits>

#include <cca/base/compiler.hpp>

namespace cca {

// The time of origin of an initial value.
inline constexpr std::int64_t never = std::numeric_limits<std::int64_t>::lowest();

namespace detail {

// A sample made of two others takes the older origin; an initial value doesn't count.
constexpr std::int64_t older(std::int64_t a, std::int64_t b) {
  // Without a branch: as unsigned numbers, `never` is the largest.
  const auto rank = [](std::int64_t t) {
    return static_cast<std::uint64_t>(t) - static_cast<std::uint64_t>(never) - 1;
  };
  return rank(a) < rank(b) ? a : b;
}

}  // namespace detail
}  // namespace cca
