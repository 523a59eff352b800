// The random decisions of a bus in memory: which frame a fault hits, and which bits it flips.
//
// The same seed gives the same decisions in the same order; a copy goes on like the original.
#pragma once

#include <cstddef>
#include <cstdint>

#include <cca/base/math/random_numbers.hpp>
#include <cca/hardware/bus/can_frame.hpp>

namespace cca::hardware::detail {

class fault_dice {
public:
  explicit fault_dice(std::uint64_t seed) : random(seed) {}

  bool hits(double chance) { return chance >= 1 || random.happens(chance); }

  // Flips one to four bits of the payload, and cuts one in four classic frames short.
  void damage(can_frame& frame) {
    const std::size_t bytes = frame.payload().size();
    if (bytes == 0) return;
    for (std::uint64_t flips = 1 + random.below(4); flips > 0; --flips) {
      const std::uint64_t bit = random.below(8 * bytes);
      frame.data[bit / 8] = static_cast<std::uint8_t>(frame.data[bit / 8] ^ (1u << (bit % 8)));
    }
    if (random.below(4) == 0 && !frame.fd) frame.length = static_cast<std::uint8_t>(random.below(bytes));
  }

private:
  cca::random_numbers random;
};

}  // namespace cca::hardware::detail
