#pragma once
// The figures of a walk along its own way, straight on or in a circle.
#include <algorithm>
#include <cmath>

#include <cca/cca.hpp>

#include "../trot/report/recording.hpp"
#include "../trot/report/statistics.hpp"

namespace walking {

// What the robot shall do: m/s forward, rad/s to the left.
struct command {
  double speed = 0.66, turn = 0;
};

struct figures {
  double seconds = 0;                  // simulated
  double way = 0;                      // m, of the trunk towards its nose; backward counts as negative
  double cruise = 0, turn = 0;         // m/s towards its nose and rad/s, means from 2 s on
  double drift = 0;                    // m, to the left of the line of the start
  double slip = 0;                     // m/s, from 2 s on (trot::statistics::foot_slip)
  double transport = 0;                // positive mechanical work / (weight * way), without unit
  double max_roll = 0, max_pitch = 0;  // rad
  bool fell = false;
};

inline figures along_its_way(const trot::recording& run) {
  figures f;
  f.fell = run.fell;
  if (run.moments.size() < 2) return f;
  double settled_way = 0, settled_time = 0;
  for (std::size_t i = 1; i < run.moments.size(); ++i) {
    const trot::moment &before = run.moments[i - 1], &now = run.moments[i];
    const double yaw = now.attitude.yaw;
    const double ahead = std::cos(yaw) * (now.position[0] - before.position[0]) +
                         std::sin(yaw) * (now.position[1] - before.position[1]);
    f.way += ahead;
    f.max_roll = std::max(f.max_roll, std::abs(now.attitude.roll));
    f.max_pitch = std::max(f.max_pitch, std::abs(now.attitude.pitch));
    if (now.time <= trot::settled) continue;
    settled_way += ahead;
    settled_time += now.time - before.time;
    f.turn += cca::wrap_signed(yaw - before.attitude.yaw);
  }
  if (settled_time > 0) f.cruise = settled_way / settled_time, f.turn /= settled_time;
  f.seconds = run.moments.back().time;
  f.drift = run.moments.back().position[1] - run.start[1];
  trot::statistics s;
  s.seconds = f.seconds;
  trot::evaluate_feet(run, s);
  f.slip = s.foot_slip;
  if (f.way > 0) f.transport = run.work / (run.mass * run.gravity * f.way);
  return f;
}

}  // namespace walking
