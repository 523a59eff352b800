#pragma once
// From a wanted speed to the amplitude of the gait: a straight line through the speeds that it reaches on
// flat ground in both engines, 0.2 to 0.8 m/s (docs/simulator.md, "The trot").
//
//   out "amplitude"   wanted_amplitude, in parts of the full gait; -1 before `start` and for speed 0, so that
//                     the oscillator rests
#include <cca/cca.hpp>

#include "spaces.hpp"

namespace trot {

struct throttle {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::speed, 0, 1>, speed),        // m/s
                             (cca::quantity<cca::duration, 0, 3600>, start),  // s to stand first
                             (double, intercept),
                             (double, slope));  // amplitude = intercept + slope * speed
  };
  parameters p{0.75, 0.2, 0.165, 0.95};

  auto process(cca::beat now) -> cca::out<"amplitude", wanted_amplitude> {
    const double time = static_cast<double>(now.time()) * 1e-9;
    return p.speed > 0 && time >= p.start ? p.intercept + p.slope * p.speed : -1.0;
  }
};

}  // namespace trot
