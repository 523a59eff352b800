#pragma once
// What a run of the learned gait is worth, for its training, and whether it walks, for its judgement.
#include <algorithm>
#include <cmath>

#include "../trot/report/statistics.hpp"

namespace walking {

// As fast as commanded, with little slip and work, straight on, level. A fall is worse than any walk.
inline double worth(const trot::statistics& s, double commanded_speed, double seconds) {
  if (s.fell) return s.seconds / seconds - 4;
  return -3 * std::abs(s.cruise - commanded_speed) - 3 * s.foot_slip - 0.3 * std::abs(s.drift) / s.seconds -
         0.3 * (s.max_roll + s.max_pitch) - 0.15 * std::min(s.cost_of_transport, 5.0);
}

struct bounds {
  double least_part = 0.9;   // of the commanded speed, once it walks
  double most_slip = 0.15;   // m/s, of all feet, weighted by load: that of the trot (report/bounds.hpp)
  double most_drift = 0.15;  // of the distance
};

// Not if a figure is NaN.
inline bool walks(const trot::statistics& s, double commanded_speed, const bounds& b = {}) {
  return !s.fell && s.cruise >= b.least_part * commanded_speed && s.foot_slip <= b.most_slip &&
         std::abs(s.drift) <= b.most_drift * s.distance;
}

}  // namespace walking
