#pragma once
// The trot as an architecture, for any robot with the Oncilla's ports: the simulated one, the real one, or
// one of a test.
#include <cca/cca.hpp>

#include "gait.hpp"
#include "stride_oscillator.hpp"
#include "posture.hpp"
#include "throttle.hpp"

namespace trot {

template <class Robot>
struct architecture
    : cca::graph<cca::rate<1000>,
                 cca::node<"throttle", throttle, cca::timed<10>>,
                 cca::node<"posture", posture, cca::timed<10>>,
                 cca::node<"cpg", stride_oscillator, cca::timed<1>>,
                 cca::node<"gait", gait, cca::port_triggered<"phase">>,
                 cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                 cca::node<"robot", Robot>,

                 cca::wire<"robot.orientation", "posture.orientation", cca::latest>,  // 1 kHz, read at 100 Hz
                 cca::wire<"throttle.amplitude", "cpg.amplitude", cca::latest>,       // 100 Hz, read at 1 kHz
                 cca::wire<"posture.turn", "gait.turn", cca::latest>,
                 cca::wire<"posture.lean", "gait.lean", cca::latest>,
                 cca::wire<"cpg.phase", "gait.phase">,
                 cca::wire<"cpg.amplitude", "gait.amplitude">,
                 cca::wire<"gait.angles", "limits.command">,
                 cca::wire<"robot.angles", "limits.measured">,
                 cca::wire<"limits.safe", "robot.command">> {};

}  // namespace trot
