#pragma once
// The learned gait as an architecture, for any robot with the Oncilla's ports.
#include <cca/cca.hpp>

#include "attitude.hpp"
#include "clock.hpp"
#include "helm.hpp"
#include "odometer.hpp"
#include "policy.hpp"
#include "sidestep.hpp"
#include "symmetric.hpp"
#include "throttle.hpp"

namespace walking {

// [architecture]
// The policy at 100 Hz, between a clock and a robot at 1 kHz.
template <class Policy, class Oscillator = oscillator>
struct gait_of : cca::graph<cca::node<"throttle", throttle, cca::timed<period>>,
                            cca::node<"cpg", Oscillator, cca::timed<1>>,
                            cca::node<"clock", clock, cca::timed<period>>,
                            cca::node<"helm", helm, cca::timed<1>>,
                            cca::node<"attitude", attitude, cca::timed<period>>,
                            cca::node<"policy", Policy, cca::timed<period>>,
                            cca::node<"smooth", smooth, cca::timed<1>>,

                            cca::wire<"throttle.amplitude", "cpg.amplitude", cca::latest>,
                            cca::wire<"cpg.phase", "clock.phase", cca::latest>,
                            cca::wire<"cpg.amplitude", "clock.amplitude", cca::latest>,
                            cca::wire<"helm.relative", "attitude.orientation", cca::latest>,
                            cca::wire<"clock.clock", "policy.clock">,
                            cca::wire<"attitude.down", "policy.down">,
                            cca::wire<"attitude.course", "policy.course">,
                            cca::wire<"policy.output", "smooth.input", cca::latest, before_the_first>,

                            cca::expose<"throttle.speed", "speed">,
                            cca::expose<"helm.orientation", "orientation">,
                            cca::expose<"policy.rates", "rates">,
                            cca::expose<"policy.angles", "angles">,
                            cca::expose<"smooth.output", "command">,
                            cca::expose<"cpg.phase", "phase">,
                            cca::expose<"cpg.amplitude", "amplitude">,
                            cca::expose<"helm.relative", "relative">,
                            cca::expose<"helm.turn", "turn">,
                            cca::expose<"clock.clock", "clock">,
                            cca::expose<"attitude.down", "down">,
                            cca::expose<"attitude.course", "course">> {};
struct learned_gait : gait_of<symmetric_policy> {};

template <class Robot, class Gait = learned_gait>
struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"gait", Gait>,
                                 cca::node<"odometer", odometer>,
                                 cca::node<"sidestep", sidestep>,
                                 cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                                 cca::node<"abduction_limits", cca::limiter<oncilla::abduction_angles>>,
                                 cca::node<"robot", Robot>,

                                 cca::wire<"robot.orientation", "gait.orientation", cca::latest>,
                                 cca::wire<"robot.angular_velocity", "gait.rates", cca::latest>,
                                 cca::wire<"robot.angles", "gait.angles", cca::latest>,
                                 cca::wire<"robot.angles", "odometer.angles", cca::latest>,
                                 cca::wire<"robot.velocities", "odometer.velocities", cca::latest>,
                                 cca::wire<"robot.angular_velocity", "odometer.rates", cca::latest>,
                                 cca::wire<"robot.foot_loads", "odometer.loads", cca::latest>,
                                 cca::wire<"odometer.speed", "gait.speed", cca::latest>,
                                 cca::wire<"gait.phase", "sidestep.phase">,
                                 cca::wire<"gait.amplitude", "sidestep.amplitude">,
                                 cca::wire<"gait.turn", "sidestep.turn">,
                                 cca::wire<"gait.command", "limits.command">,
                                 cca::wire<"robot.angles", "limits.measured">,
                                 cca::wire<"limits.safe", "robot.command">,
                                 cca::wire<"sidestep.abduction", "abduction_limits.command">,
                                 cca::wire<"robot.abducted", "abduction_limits.measured">,
                                 cca::wire<"abduction_limits.safe", "robot.abduction">> {};
// [architecture end]

}  // namespace walking
