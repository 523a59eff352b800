#pragma once
// What a run of the trot must keep at full speed: it is fast, its feet slip little and stand for about as
// long as commanded, and it does not fall. All figures count from 2 s on, so standing and starting don't.
#include <cmath>

#include "statistics.hpp"

namespace trot {

struct bounds {
  double least_cruise = 0.6;    // m/s, along the ground
  double most_slip = 0.15;      // m/s, of all feet, weighted by load
  double most_off_duty = 0.12;  // of each foot's duty factor from the commanded one
};

// How far the duty factor of a foot is off at most.
inline double farthest_off_duty(const statistics& s, double commanded) {
  double off = 0;
  for (const double duty : s.duty_factor) {
    const double now = std::abs(duty - commanded);
    if (!std::isnan(off) && !(now <= off)) off = now;  // NaN stays
  }
  return off;
}

// Not if a figure is NaN.
inline bool keeps(const statistics& s, double commanded_duty, const bounds& b = {}) {
  return !s.fell && s.cruise >= b.least_cruise && s.foot_slip <= b.most_slip &&
         farthest_off_duty(s, commanded_duty) <= b.most_off_duty;
}

}  // namespace trot
