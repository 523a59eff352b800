// The balls of a scene in a compiled world: solid spheres that move freely. How they lie turned is not kept:
// nothing shows it.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

struct balls_around {
  static constexpr std::size_t most = 4;

  struct one {
    double radius = 0, mass = 0;  // m, kg
    constexpr double inertia() const { return 0.4 * mass * radius * radius; }
  };
  std::size_t count = 0;
  std::array<one, most> all{};
};

// Along the world's axes, of its centre.
template <class Real>
struct ball_motion {
  triple<Real> at{}, velocity{}, turning{};

  constexpr void drift(double time) { at = at + Real(time) * velocity; }
  // Of its point at `arm` from its centre.
  constexpr triple<Real> speed(const triple<Real>& arm) const { return velocity + cross(turning, arm); }
};

}  // namespace cca::sim::detail
