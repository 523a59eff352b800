#pragma once
// The clock of the walk, and how the policy observes it.
//
// oscillator: that of the trot, faster. On slippery ground and at 0.6 m/s single runs slip more than the
// others at 4.05 Hz and below, at 4 Hz (the trot's) beyond the bound; at 4.1 Hz none that was tried does
// (docs/walking_policy.md).
//
// clock: what the policy observes, the phase of the stride as a point on a circle, because a phase jumps
// once in a turn.
//
//   in  "phase"       gait_phase
//   in  "amplitude"   gait_amplitude
//   out "clock"       stride_clock

#include <cca/cca.hpp>

#include "../trot/stride_oscillator.hpp"
#include "spaces.hpp"

namespace walking {

struct oscillator : trot::stride_oscillator {
  oscillator() { p.frequency = 4.1; }
};

struct clock {
  auto process(cca::in<"phase", trot::gait_phase> phase, cca::in<"amplitude", trot::gait_amplitude> amplitude)
      -> cca::out<"clock", stride_clock> {
    const double at = phase[trot::stride{}];
    return Eigen::Vector3d(cca::math::cos(at), cca::math::sin(at), amplitude[trot::stride{}]);
  }
};

}  // namespace walking
