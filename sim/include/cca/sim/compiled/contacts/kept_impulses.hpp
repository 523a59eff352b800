// The impulses of a step's contacts, for the next step; `key`: touches.hpp.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

template <class Real, std::size_t Most>
struct kept_impulses {
  std::size_t count = 0;
  std::array<int, Most> keys{};
  std::array<triple<Real>, Most> impulses{};  // in the world, N s

  // Contacts mostly stay in their order, so `near` is the first place to look.
  constexpr triple<Real> of(int key, std::size_t near) const {
    if (near < count && keys[near] == key) return impulses[near];
    for (std::size_t k = 0; k < count; ++k)
      if (keys[k] == key) return impulses[k];
    return {};
  }
};

}  // namespace cca::sim::detail
