#pragma once
// The times in which each foot stands: it carries some of the robot's weight. A toe that brushes the ground
// in swing carries less.
#include <array>
#include <cstddef>
#include <vector>

#include "recording.hpp"

namespace trot {

struct stance {
  double begin, end;  // s
};

inline bool stands(const recording& run, const moment& m, std::size_t leg) {
  constexpr double carried = 0.05;  // of the robot's weight
  return m.foot_force[leg] > carried * run.mass * run.gravity;
}

// A break shorter than `shortest` (a bounce after landing) does not end a stance; a stance shorter than that
// does not count.
inline std::vector<stance> stances(const recording& run, std::size_t leg, double shortest = 0.03) {
  std::vector<stance> found;
  for (const moment& m : run.moments) {
    if (!stands(run, m, leg)) continue;
    const double begin = m.time - run.beat;
    if (found.empty() || begin - found.back().end > shortest) found.push_back({begin, m.time});
    found.back().end = m.time;
  }
  std::erase_if(found, [&](const stance& s) { return s.end - s.begin < shortest; });
  return found;
}

}  // namespace trot
