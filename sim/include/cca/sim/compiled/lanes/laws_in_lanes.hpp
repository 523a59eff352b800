// The laws of the drives of a compiled world: plain ones, or of each lane its own.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include <cca/robots/joint_law.hpp>
#include <cca/sim/compiled/scalar.hpp>

namespace cca::sim::detail {

template <class Real>
struct law_in_lanes {
  Real position{}, velocity{}, torque{}, stiffness{}, damping{};
};
template <class Real>
using law_of = std::conditional_t<is_in_lanes<Real>, law_in_lanes<Real>, robots::joint_law>;
// Whether it follows a position. Lanes do the same: what the first one does.
template <class Law>
constexpr bool is_law_of_position(const Law& law) {
  if constexpr (requires { law.stiffness[0]; }) return law.stiffness[0] > 0;
  else return law.stiffness > 0;
}

// Laws that are not finite are not taken.
template <std::size_t N>
void take_laws(std::span<const robots::joint_law> from, std::array<robots::joint_law, N>& to) {
  for (std::size_t c = 0; c < std::min(from.size(), N); ++c)
    if (from[c].is_finite()) to[c] = from[c];
}
// Those of lane l begin at l N, if there are more than N; else they are those of all lanes.
template <class Real, std::size_t N>
void take_laws(std::span<const robots::joint_law> from, std::array<law_in_lanes<Real>, N>& to) {
  for (std::size_t l = 0; l < static_cast<std::size_t>(Real::count); ++l)
    for (std::size_t c = 0; c < std::min(from.size(), N); ++c) {
      const std::size_t at = from.size() > N ? l * N + c : c;
      if (at >= from.size() || !from[at].is_finite()) continue;
      const auto set = [&](Real& x, double y) { x.set(static_cast<int>(l), y); };
      set(to[c].position, from[at].position), set(to[c].velocity, from[at].velocity);
      set(to[c].torque, from[at].torque), set(to[c].stiffness, from[at].stiffness);
      set(to[c].damping, from[at].damping);
    }
}

}  // namespace cca::sim::detail
