// The random decisions of a bus in memory: which frame a fault hits, and which bits it flips.
//
// The same seed gives the same decisions in the same order; a copy goes on like the original.
#pragma once

#include <cstddef>
#include <cstdint>

#include <cca/hardware/bus/can_frame.hpp>

namespace cca::hardware::detail {

class fault_dice {
public:
  explicit fault_dice(std::uint64_t s) : seed(s) {}

  bool hits(double chance) { return chance >= 1 || static_cast<double>(random() >> 11) * 0x1p-53 < chance; }

  // Flips one to four bits of the payload, and cuts one in four classic frames short.
  void damage(can_frame& frame) {
    const std::size_t bytes = frame.payload().size();
    if (bytes == 0) return;
    for (std::uint64_t flips = 1 + random() % 4; flips > 0; --flips) {
      const std::uint64_t bit = random() % (8 * bytes);
      frame.data[bit / 8] = static_cast<std::uint8_t>(frame.data[bit / 8] ^ (1u << (bit % 8)));
    }
    if (random() % 4 == 0 && !frame.fd) frame.length = static_cast<std::uint8_t>(random() % bytes);
  }

private:
  std::uint64_t random() {  // splitmix64
    std::uint64_t z = seed + 0x9e3779b97f4a7c15u * ++drawn;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t seed = 0, drawn = 0;
};

}  // namespace cca::hardware::detail
