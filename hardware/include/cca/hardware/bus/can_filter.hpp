// A set of ids: those that equal `id` in the bits of `mask`. Without a mask it is exactly one id. An 11-bit
// id never matches a 29-bit one.
#pragma once

#include <cstdint>

#include <cca/hardware/bus/can_frame.hpp>

namespace cca::hardware {

struct can_filter {
  can_id id{};
  std::uint32_t mask = 0x1FFFFFFF;

  constexpr bool matches(can_id other) const {
    return other.extended == id.extended && ((other.number ^ id.number) & mask) == 0;
  }
  friend constexpr bool operator==(const can_filter&, const can_filter&) = default;
};

// Whether some id matches both.
constexpr bool overlap(const can_filter& a, const can_filter& b) {
  return a.id.extended == b.id.extended && ((a.id.number ^ b.id.number) & a.mask & b.mask) == 0;
}

}  // namespace cca::hardware
