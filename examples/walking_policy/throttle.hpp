#pragma once
// From a wanted speed to the amplitude of the clock: a straight line, and, where the speed is measured, an
// integral that corrects it.
//
//   in  "speed"       trunk_speed, optional: not wired, the straight line alone counts
//   out "amplitude"   wanted_amplitude, in parts of the full gait; -1 before `start` and for speed 0, so that
//                     the oscillator rests
//
//   amplitude = intercept + slope (speed + c),  c' = gain (speed - measured),  |c| <= most
//
// The integral stops at its bounds, so it is back at once when the error changes its sign. A measured speed
// that is not finite leaves it as it is.
#include <algorithm>
#include <cmath>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace walking {

struct throttle {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::speed, 0, 1>, speed),        // m/s
                             (cca::quantity<cca::duration, 0, 3600>, start),  // s to stand first
                             (double, intercept),
                             (double, slope),
                             (cca::bounded<double, 0, 10>, gain),       // 1/s
                             (cca::quantity<cca::speed, 0, 1>, most));  // of the correction
  };
  parameters p{0.66, 0.2, 0.191, 1.076, 0.7, 0.15};

  auto process(cca::optional_in<"speed", trunk_speed> measured, cca::beat now)
      -> cca::out<"amplitude", trot::wanted_amplitude> {
    const double time = static_cast<double>(now.time()) * 1e-9;
    if (p.speed <= 0 || time < p.start) return correction_ = 0, -1.0;
    const double missing = p.speed - measured[forward{}];
    if (measured && std::isfinite(missing))
      correction_ = std::clamp(correction_ + now.dt() * p.gain * missing, -p.most, +p.most);
    return p.intercept + p.slope * (p.speed + correction_);
  }

private:
  double correction_ = 0;  // m/s
};

}  // namespace walking
