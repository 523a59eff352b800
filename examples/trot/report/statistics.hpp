#pragma once
// The figures of a run: distance, speed, steadiness and cost of transport.
#include <algorithm>
#include <array>
#include <cmath>

#include "footfalls.hpp"
#include "recording.hpp"

namespace trot {

struct statistics {
  double seconds = 0;                  // simulated
  double distance = 0;                 // m forward (along x) from the start, standing and starting included
  double speed = 0;                    // m/s, distance over all seconds
  double cruise = 0;                   // m/s from 2 s on, along the ground: uphill it is more than along x
  double drift = 0;                    // m to the left of the line of the start
  double max_roll = 0, max_pitch = 0;  // rad
  double stride_frequency = 0;         // Hz
  std::array<double, 4> duty_factor{};
  double cost_of_transport = 0;  // positive mechanical work / (weight * distance), without unit
  // From 2 s on: how fast the feet slide over the ground while they carry. Each moment counts by its load.
  double foot_slip = 0;                  // m/s, of all feet
  std::array<double, 4> slip_of_foot{};  // m/s
  double friction_power = 0;             // W, lost between feet and ground
  bool fell = false;
};

namespace detail {

// Counts forward swings of a hip through the middle of its range: one per stride. `still` excludes jitter.
inline double stride_frequency(const recording& run, std::size_t leg, double settled) {
  constexpr double still = 0.03;  // rad
  double sum = 0, count = 0;
  for (const moment& m : run.moments)
    if (m.time >= settled) sum += m.hip[leg], ++count;
  const double middle = sum / count;
  double first = 0, last = 0;
  int strides = -1;
  bool behind = false;
  for (const moment& m : run.moments) {
    if (m.time < settled) continue;
    if (m.hip[leg] < middle - still) behind = true;
    if (!behind || m.hip[leg] < middle + still) continue;
    behind = false;
    last = m.time;
    if (++strides == 0) first = m.time;
  }
  return strides > 0 ? strides / (last - first) : 0;
}

inline double duty_factor(const recording& run, std::size_t leg, double settled) {
  double stood = 0, count = 0;
  for (const moment& m : run.moments)
    if (m.time >= settled) stood += stands(run, m, leg), ++count;
  return count > 0 ? stood / count : 0;
}

}  // namespace detail

inline void evaluate_feet(const recording& run, statistics& s) {
  double load = 0, slip = 0, work = 0;
  for (std::size_t leg = 0; leg < 4; ++leg) {
    const cca::sim::foot_account &now = run.feet[leg], &before = run.feet_when_settled[leg];
    const double carried = now.load - before.load, slipped = now.slip - before.slip;
    s.slip_of_foot[leg] = carried > 0 ? slipped / carried : 0;
    load += carried;
    slip += slipped;
    work += now.friction_work - before.friction_work;
  }
  if (load > 0) s.foot_slip = slip / load;
  if (s.seconds > settled) s.friction_power = work / (s.seconds - settled);
}

inline statistics evaluate(const recording& run) {
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
  const auto cruising = std::find_if(run.moments.begin(), run.moments.end(),
                                     [&](const moment& m) { return m.time >= settled; });
  if (cruising != run.moments.end() && cruising->time < last.time) {
    const double forward = last.position[0] - cruising->position[0],
                 up = last.position[2] - cruising->position[2];
    s.cruise = std::copysign(std::hypot(forward, up), forward) / (last.time - cruising->time);
  }
  for (std::size_t leg = 0; leg < 4; ++leg) {
    s.stride_frequency += detail::stride_frequency(run, leg, settled) / 4;
    s.duty_factor[leg] = detail::duty_factor(run, leg, settled);
  }
  evaluate_feet(run, s);
  if (s.distance > 0) s.cost_of_transport = run.work / (run.mass * run.gravity * s.distance);
  return s;
}

}  // namespace trot
