// Gaits of a quadruped as phases of its legs: left front, right front, left hind, right hind.
//
//   gait    phases, in turns    meaning
//   walk    0, 1/2, 1/4, 3/4    one leg after the other: left hind, left front, right hind, right front
//   trot    0, 1/2, 1/2, 0      diagonal legs together
//   pace    0, 1/2, 0, 1/2      the legs of a side together
//   bound   0, 0, 1/2, 1/2      both front legs together, both hind legs together
//
// Source: Righetti and Ijspeert, Pattern generators with sensory feedback for the control of quadruped
// locomotion, ICRA 2008 (the four gaits); the walk is the lateral sequence of Hildebrand, Symmetrical gaits
// of horses, Science 150, 1965.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <cca/space/methods/circle.hpp>
#include <cca/space/dimension.hpp>
#include <cca/base/eigen.hpp>
#include <cca/space/methods/scalar.hpp>
#include <cca/space/space.hpp>

namespace cca {

enum class gait : std::uint8_t { walk, trot, pace, bound };

struct gait_axis : dimension<"gait"> {};
struct gait_choice : space<status, axes<gait_axis>> {};

// In rad. An unknown number means walk.
constexpr std::array<double, 4> gait_phases(gait which) {
  constexpr std::array<std::array<double, 4>, 4> turns{
      {{0, 0.5, 0.25, 0.75}, {0, 0.5, 0.5, 0}, {0, 0.5, 0, 0.5}, {0, 0, 0.5, 0.5}}};
  const auto row = static_cast<std::size_t>(which);
  auto phases = turns[row < turns.size() ? row : 0];
  for (double& one : phases) one *= 2 * pi;
  return phases;
}

// Entry (i, j): the phase of leg j minus the phase of leg i, in rad.
inline Eigen::Matrix<double, 4, 4> phase_matrix(gait which) {
  const auto phases = gait_phases(which);
  Eigen::Matrix<double, 4, 4> ahead;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      ahead(i, j) = phases[static_cast<std::size_t>(j)] - phases[static_cast<std::size_t>(i)];
  return ahead;
}

}  // namespace cca
