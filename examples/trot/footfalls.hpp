#pragma once
// When each foot stood on the ground: contacts without the bounces of a foot that has just landed.
#include <array>
#include <cstddef>
#include <vector>

#include "recording.hpp"

namespace trot {

struct stance {
  double begin, end;  // s
};

// A break shorter than `shortest` is still the same stance, a contact shorter than that is none.
inline std::vector<stance> stances(const recording& run, std::size_t leg, double shortest = 0.03) {
  std::vector<stance> found;
  for (const moment& m : run.moments) {
    if (!m.contact[leg]) continue;
    const double begin = m.time - run.beat;
    if (found.empty() || begin - found.back().end > shortest) found.push_back({begin, m.time});
    found.back().end = m.time;
  }
  std::erase_if(found, [&](const stance& s) { return s.end - s.begin < shortest; });
  return found;
}

}  // namespace trot
