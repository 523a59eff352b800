// Pushes on the base of a robot at given times: what a run is disturbed by.
//
//   simulator.disturb({{{{.start = 2, .duration = 0.06, .force = {0, 12, 0}}}}});
//
// A value, of at most `most` pushes. Time is the world's. cca/sim/oncilla/disturbance.hpp draws them from a
// seed.
#pragma once

#include <array>
#include <cstddef>

namespace cca::sim {

struct push {
  double start = 0, duration = 0;  // s
  std::array<double, 3> force{};   // N, in the world's axes, on the centre of mass of the base

  bool acts_at(double time) const { return time >= start && time < start + duration; }
};

struct push_plan {
  static constexpr std::size_t most = 8;
  std::array<push, most> pushes{};

  // The sum of those that act.
  std::array<double, 3> force_at(double time) const {
    std::array<double, 3> sum{};
    for (const push& p : pushes)
      if (p.acts_at(time))
        for (std::size_t k = 0; k < 3; ++k) sum[k] += p.force[k];
    return sum;
  }
};

}  // namespace cca::sim
