#pragma once
// What a run of the learned gait is worth, for its training, and whether it walks, for its judgement.
#include <algorithm>
#include <cmath>

#include "way.hpp"

namespace walking {

// As fast as commanded, turning as commanded, with little slip and work, level. What is off by more than 0.03
// m/s or rad/s counts three times, so that no command is given up for the others. A fall counts as much as
// 0.6 m/s that are missing. Work counts up to four times the weight, so that a robot that stands has reason
// to walk.
inline double worth(const figures& f, const command& wanted, double seconds) {
  if (f.fell) return f.seconds / seconds - 6;
  const auto off = [](double is, double shall) {
    const double by = std::abs(is - shall);
    return by + 2 * std::max(0.0, by - 0.03);
  };
  const double transport = f.way > 0 ? std::min(f.transport, 4.0) : 4.0;
  return -3 * off(f.cruise, wanted.speed) - 3 * off(f.turn, wanted.turn) - 2 * f.slip - 0.3 * transport -
         0.3 * (f.max_roll + f.max_pitch);
}

struct bounds {
  double off_speed = 0.05;  // m/s, or this share of the commanded speed, whichever is more
  double off_speed_share = 0.1;
  double off_turn = 0.05;    // rad/s
  double most_slip = 0.15;   // m/s, of all feet, weighted by load: that of the trot (report/bounds.hpp)
  double most_drift = 0.15;  // of the way, straight on
};

// Not if a figure is NaN.
inline bool walks(const figures& f, const command& wanted, const bounds& b = {}) {
  return !f.fell &&
         std::abs(f.cruise - wanted.speed) <= std::max(b.off_speed, b.off_speed_share * wanted.speed) &&
         std::abs(f.turn - wanted.turn) <= b.off_turn && f.slip <= b.most_slip &&
         (wanted.turn != 0 || std::abs(f.drift) <= b.most_drift * f.way);
}

}  // namespace walking
