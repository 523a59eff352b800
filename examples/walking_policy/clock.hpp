#pragma once
// The clock that the policy observes: the phase of the stride as a point on a circle, because a phase jumps
// once in a turn.
//
//   in  "phase"       gait_phase
//   in  "amplitude"   gait_amplitude
//   out "clock"       stride_clock

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace walking {

struct clock {
  auto process(cca::in<"phase", trot::gait_phase> phase, cca::in<"amplitude", trot::gait_amplitude> amplitude)
      -> cca::out<"clock", stride_clock> {
    const double at = phase[trot::stride{}];
    return Eigen::Vector3d(cca::math::cos(at), cca::math::sin(at), amplitude[trot::stride{}]);
  }
};

}  // namespace walking
