#pragma once
// The clock of the walk, and how the policy observes it.
//
// oscillator: that of the trot, at the frequency of the walk. In fast circles on slippery ground the feet
// slip less than at the 4 Hz of the trot; at 4.2 Hz they slip more straight on (measured).
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
  oscillator() { p.frequency = 4.05; }
};

struct clock {
  auto process(cca::in<"phase", trot::gait_phase> phase, cca::in<"amplitude", trot::gait_amplitude> amplitude)
      -> cca::out<"clock", stride_clock> {
    const double at = phase[trot::stride{}];
    return Eigen::Vector3d(cca::math::cos(at), cca::math::sin(at), amplitude[trot::stride{}]);
  }
};

}  // namespace walking
