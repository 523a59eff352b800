#pragma once
// An Oncilla that walks by a policy from PyTorch: what the policy observes and commands, and the graph around
// it. docs/tutorial/10_policy.md.
//
// Observed: a clock that turns once in a stride, gravity and rotation of the trunk, the angles of the legs.
// Commanded: the angles of the legs, at 100 Hz, between a clock and a robot at 1 kHz.
#include <limits>

#include <cca/cca.hpp>
#include <cca/mapping/policy.hpp>
#include <cca/robots/oncilla/spaces.hpp>

#include "../trot/stride_oscillator.hpp"
#include "../walking_policy/teacher.hpp"

namespace pytorch_walk {

namespace oncilla = cca::robots::oncilla;

// [spaces]
using rate = cca::rate<100>;
inline constexpr int period = 10;  // in beats of the robot

struct cosine : cca::dimension<"cosine"> {};
struct sine : cca::dimension<"sine"> {};
struct amplitude : cca::dimension<"amplitude"> {};
struct gait_clock : cca::space<cca::number, cca::axes<cosine, sine, amplitude>, rate> {};
struct gravity
    : cca::space<cca::cartesian_position<oncilla::trunk_frame>, cca::axes<cca::x, cca::y, cca::z>, rate> {};
struct targets : cca::space<cca::joint_angles, oncilla::leg_axes, rate> {};

using observations = cca::policy_inputs<cca::in<"gait_clock", gait_clock>,
                                        cca::in<"projected_gravity", gravity>,
                                        cca::in<"base_ang_vel", oncilla::trunk_angular_velocity>,
                                        cca::in<"joint_pos", oncilla::leg_angles>>;
struct learner {  // for `cca-policy contract`: where the policy will stand
  using inputs = observations;
  using action_space = targets;
};
// [spaces end]

// The phase of the stride as a point on a circle, and how far the legs swing: 0, stand.
struct clock {
  auto process(cca::in<"phase", trot::gait_phase> phase, cca::in<"amplitude", trot::gait_amplitude> swing)
      -> cca::out<"clock", gait_clock> {
    const double at = phase[trot::stride{}];
    return Eigen::Vector3d(cca::math::cos(at), cca::math::sin(at), swing[trot::stride{}]);
  }
};
// The way down in the frame of the trunk, of length 1.
struct down {
  auto process(cca::in<"orientation", oncilla::trunk_orientation> trunk) -> cca::out<"gravity", gravity> {
    const auto& q = trunk.vector();  // x y z w; the last row of its rotation matrix is the way up
    return Eigen::Vector3d(2 * (q[3] * q[1] - q[0] * q[2]), -2 * (q[1] * q[2] + q[3] * q[0]),
                           2 * (q[0] * q[0] + q[1] * q[1]) - 1);
  }
};
// From the policy's rate to that of the robot.
struct smooth : cca::interpolate<targets, oncilla::leg_angles> {};
// Until the policy answers, the limiter holds the measured angles: NaN is no command.
using before_the_first = cca::initial<std::numeric_limits<double>::quiet_NaN()>;

// [graph]
// What walks, on any robot with the Oncilla's ports. `More`: what a training adds.
template <class Policy, class... More>
using gait_of = cca::graph<cca::node<"throttle", walking::teachers_throttle, cca::timed<period>>,
                           cca::node<"cpg", trot::stride_oscillator, cca::timed<1>>,
                           cca::node<"clock", clock, cca::timed<period>>,
                           cca::node<"down", down, cca::timed<period>>,
                           cca::node<"policy", Policy, cca::timed<period>>,
                           cca::node<"smooth", smooth, cca::timed<1>>,

                           cca::wire<"throttle.amplitude", "cpg.amplitude", cca::latest>,
                           cca::wire<"cpg.phase", "clock.phase", cca::latest>,
                           cca::wire<"cpg.amplitude", "clock.amplitude", cca::latest>,
                           cca::wire<"clock.clock", "policy.gait_clock">,
                           cca::wire<"down.gravity", "policy.projected_gravity">,
                           cca::wire<"policy.output", "smooth.input", cca::latest, before_the_first>,

                           cca::expose<"down.orientation", "orientation">,
                           cca::expose<"policy.base_ang_vel", "rates">,
                           cca::expose<"policy.joint_pos", "angles">,
                           cca::expose<"smooth.output", "command">,
                           cca::expose<"policy.status", "status">,
                           More...>;
// [graph end]

}  // namespace pytorch_walk
