// The disturbances of a run, drawn from a seed: the joints' angles at the start, the friction of the ground,
// pushes on the trunk.
//
// The same seed gives the same bits with every compiler: std::mt19937_64 is specified exactly, and the
// distribution is written here.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <random>

#include <cca/base/math.hpp>
#include <cca/sim/oncilla/oncilla_model.hpp>
#include <cca/sim/robot/model/push.hpp>

namespace cca::sim {

class uniform_numbers {
public:
  explicit uniform_numbers(std::uint64_t seed) : bits_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }

private:
  std::mt19937_64 bits_;
};

struct disturbance {
  std::array<double, leg_count> hip_offset{}, knee_offset{};  // rad, of the posture at the start
  std::array<double, 3> trunk_velocity{};                     // m/s, at the start
  double friction = 0.75;
  std::array<push, 3> pushes{};
  push another{};  // set by a program, never drawn

  // For a run without a seed.
  static disturbance none() { return {}; }

  static disturbance from_seed(std::uint64_t seed, double duration) {
    uniform_numbers u(seed * 7919 + 13);
    disturbance d;
    for (std::size_t leg = 0; leg < leg_count; ++leg) {
      d.hip_offset[leg] = u.between(-0.06, 0.06);
      d.knee_offset[leg] = u.between(-0.08, 0.08);
    }
    d.friction = u.between(0.6, 0.9);
    for (double& v : d.trunk_velocity) v = u.between(-0.05, 0.05);
    for (push& p : d.pushes) {
      p.start = u.between(2.0, std::max(2.0, duration - 1.0));
      p.duration = 0.06;
      const double direction = u.between(0, 2 * std::numbers::pi), strength = u.between(8, 16);
      p.force = {strength * math::cos(direction), strength * math::sin(direction), 0};
    }
    return d;
  }

  // For cca::sim::simulator.
  operator push_plan() const { return {{pushes[0], pushes[1], pushes[2], another}}; }
  std::array<double, 3> push_at(double time) const { return push_plan(*this).force_at(time); }
};

}  // namespace cca::sim
