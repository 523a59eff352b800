// A dense sample of all 32-bit patterns: every exponent, both signs, and one in `stride` of the fractions.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>

// As floats; also zeros, ends of ranges, infinities and NaN.
template <class F>
void for_floats(std::uint32_t stride, F&& f) {
  for (std::uint64_t bits = 0; bits < 0x100000000u; bits += stride)
    f(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  for (const std::uint32_t bits : {0u, 1u, 0x007FFFFFu, 0x00800000u, 0x3F800000u, 0x7F7FFFFFu, 0x7F800000u,
                                   0x7F800001u, 0x7FC00000u, 0x7FFFFFFFu})
    for (const std::uint32_t sign : {0u, 0x80000000u}) f(std::bit_cast<float>(bits | sign));
}
