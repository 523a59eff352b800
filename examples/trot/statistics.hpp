#pragma once
// The figures of a run: how far, how fast, how steady, at what cost.
#include <algorithm>
#include <array>
#include <cmath>

#include "footfalls.hpp"
#include "recording.hpp"

namespace trot {

struct statistics {
  double seconds = 0;   // simulated
  double distance = 0;  // m forward (along x) from where it was put down, standing and starting included
  double speed = 0;     // m/s, distance over all seconds
  double cruise = 0;    // m/s from 2 s on
  double drift = 0;     // m to the left of the line it started on
  double max_roll = 0, max_pitch = 0;  // rad
  double stride_frequency = 0;         // Hz
  std::array<double, 4> duty_factor{};
  double cost_of_transport = 0;  // positive mechanical work / (weight * distance), without unit
  bool fell = false;
};

namespace detail {

// Strides from 2 s on, from touch-down to touch-down: how many a second, and which part of them the foot stood.
struct strides {
  double frequency = 0, duty_factor = 0;
};

inline strides count_strides(const recording& run, std::size_t leg, double settled) {
  std::vector<stance> found = stances(run, leg);
  std::erase_if(found, [&](const stance& s) { return s.begin < settled; });
  if (found.size() < 2) return {};
  const double time = found.back().begin - found.front().begin;
  double stood = 0;
  for (std::size_t i = 0; i + 1 < found.size(); ++i) stood += found[i].end - found[i].begin;
  return {static_cast<double>(found.size() - 1) / time, stood / time};
}

}  // namespace detail

inline statistics evaluate(const recording& run) {
  constexpr double settled = 2.0;
  statistics s;
  s.fell = run.fell;
  if (run.moments.empty()) return s;
  const moment& last = run.moments.back();
  s.seconds = last.time;
  s.distance = last.position[0] - run.start[0];
  s.drift = last.position[1] - run.start[1];
  s.speed = s.distance / s.seconds;
  for (const moment& m : run.moments) {
    s.max_roll = std::max(s.max_roll, std::abs(m.attitude.roll));
    s.max_pitch = std::max(s.max_pitch, std::abs(m.attitude.pitch));
  }
  const auto cruising = std::find_if(run.moments.begin(), run.moments.end(), [&](const moment& m) { return m.time >= settled; });
  if (cruising != run.moments.end() && cruising->time < last.time)
    s.cruise = (last.position[0] - cruising->position[0]) / (last.time - cruising->time);
  for (std::size_t leg = 0; leg < 4; ++leg) {
    const detail::strides found = detail::count_strides(run, leg, settled);
    s.stride_frequency += found.frequency / 4;
    s.duty_factor[leg] = found.duty_factor;
  }
  if (s.distance > 0) s.cost_of_transport = run.work / (run.mass * run.gravity * s.distance);
  return s;
}

}  // namespace trot
