// EXPECT never_rests: space\.bad_limits: the limits of velocity of the axis driven are 0\.5 to 2, and a limiter of driven_angle \(joint_angles over driven at 1000 Hz\) must be able to keep a command as it is: let them include 0
// EXPECT never_stops: space\.bad_limits: the limits of acceleration of the axis pushed are 0 to infinite, and a limiter of pushed_angle \(joint_angles over pushed at 1000 Hz\) must be able to stop an axis that has begun to move
// EXPECT no_rate: rate\.missing: the axis smooth limits how fast the rate of a command changes, for which a limiter of smooth_angle \(joint_angles over smooth\) needs the time from one command to the next: give the space a rate
// EXPECT no_limits_per_axis: space\.unknown_axis: attitude \(orientation<world> over x, y, z\) has 4 numbers over 3 axes, so none of them is that of an axis, and none has limits
// EXPECT watchdog_age: cca::watchdog: the greatest age of a command, in beats, is -3 in the watchdog of leg_angles \(joint_angles over hip, knee\): make it 0 or more
// EXPECT watchdog_arrival: cca::watchdog: the watchdog of leg_angles \(joint_angles over hip, knee\) waits 5 beats for the data and 9 for a command, but has no source of data
// EXPECT no_firings: cca::fault_when_unreadable: it stops after 0 unreadable inputs in a row
// EXPECT takes_other: space\.mismatch: the function of_torques of this mapping takes neither a sample of its input space, leg_angles \(joint_angles over hip, knee\), nor the vector of 2 numbers of one: give it `operator\(\)\(const cca::sample<leg_angles>&\)`
// EXPECT takes_other_space: space\.mismatch: the function of_torques of this mapping takes neither a sample of its input space, leg_angles
// EXPECT named_twice: mapping\.chain: two outputs of this chain are named `status`, so a wire could not tell them apart
// EXPECT moves_twist: space\.mismatch: the placement there also translates, and a rigid motion only rotates what acts at a point, as a sample of motion \(twist<trunk, world> over x, y, z\)
// EXPECT also_rotates: cca::translation_by: the placement turned also rotates; use `cca::rigid_motion`
// EXPECT also_translates: cca::rotation_by: the placement there also translates; use `cca::rigid_motion`
// EXPECT no_leg_axes: mapping\.bad_chain: a cca::pantograph_leg has 1 axis \(hip\), and it moves by abduction, hip and knee, or by hip and knee
// EXPECT no_outputs: mapping\.bad_policy: a cca::feed_forward has 4 inputs and no number of outputs
// EXPECT component_option: cca::adaptive_component: `int`, `double` is no option of the adaptive component of .*vite.*; allowed are a strategy
// EXPECT no_line: cca::gmr_module: its input is leg_angles \(joint_angles over hip, knee\), which has 2 axes, and a mixture is learned over one
// EXPECT no_circle: cca::gmr_module: its input is gait_phase \(phase over x\), which is a phase
// EXPECT no_pose: space\.mismatch: a cca::pose_shape is over a space of poses, and leg_angles \(joint_angles over hip, knee\) is none
// EXPECT choices: plan\.bad_step: a `then_one_of<\.\.\.>` of cca::steps names 0 steps, and it names 1 to 8
// EXPECT no_description: body\.no_body: the body of a robot is wanted, and `described` is the description of one: write `described::body`
// LINES: 25
// What the templates of mappings, of movements and of robots take, and what they say of an argument that they
// can't use. Up to ten of the lines are of this file: an alias and a function between the mistake and where
// it is asked for.
#include <cca/adaptive.hpp>
#include <cca/mapping.hpp>
#include <cca/motor.hpp>
#include <cca/robot.hpp>

#include "../parts.hpp"
#include "late.hpp"

struct driven : cca::dimension<"driven"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::velocity{0.5, 2}};
};
struct pushed : cca::dimension<"pushed"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::acceleration{0, cca::infinity}};
};
struct smooth : cca::dimension<"smooth"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::acceleration{-5, 5}};
};
template <class Axis>
using angle_along = cca::space<cca::joint_angles, cca::axes<Axis>, cca::rate<1000>>;
struct driven_angle : angle_along<driven> {};
struct pushed_angle : angle_along<pushed> {};
struct smooth_angle : cca::space<cca::joint_angles, cca::axes<smooth>> {};
struct motion : cca::space<cca::twist<trunk, world>, xyz> {};
struct state : cca::space<cca::status, cca::axes<cca::x>> {};
struct of_torques {
  Eigen::Vector2d operator()(const cca::sample<leg_torques>& x) const { return x.vector(); }
};
struct there {
  static constexpr auto where = cca::at(1, 0, 0);
};
struct turned {
  static constexpr auto where = cca::turned_about(cca::along_z, 1);
};
struct with_status {
  auto process(cca::in<"input", leg_angles> x)
      -> std::tuple<cca::out<"output", leg_angles>, cca::out<"status", state>> {
    return {x.vector(), 0.0};
  }
};
struct leg_chain : cca::serial_chain<trunk, world, cca::axes<hip, knee>> {
  static constexpr std::array joints{cca::revolute(cca::along_y), cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0, -0.1);
};
struct described {
  struct body : cca::body<trunk, cca::part<"leg", leg_chain>> {};
};

namespace broken {

template <class T>
using never_rests = cca::limiter<late<driven_angle, T>>;
template <class T>
using never_stops = cca::limiter<late<pushed_angle, T>>;
template <class T>
using no_rate = cca::limiter<late<smooth_angle, T>>;
template <class T>
using no_limits_per_axis = cca::limiter<late<attitude, T>>;
template <class T>
using watchdog_age = typename cca::detail::watch_for<late<leg_angles, T>, -3, void, -3>::type;
template <class T>
using watchdog_arrival = cca::watchdog<late<leg_angles, T>, 5, void, 9>;
template <class T>
using no_firings = cca::fault_when_unreadable<late<cca::input_status_port, T>, 0>;
template <class T>
using takes_other = cca::mapping<late<leg_angles, T>, leg_torques, of_torques>;
template <class T>
using takes_other_space = cca::transformation<late<leg_angles, T>, of_torques>;
template <class T>
using named_twice = cca::mapping_chain<late<with_status, T>, with_status>;
template <class T>
using moves_twist = cca::rigid_motion<late<motion, T>, there>;
template <class T>
using also_rotates = cca::translation_by<late<place, T>, turned>;
template <class T>
using also_translates = cca::rotation_by<late<place, T>, there>;
template <class T>
using no_leg_axes = cca::pantograph_leg<late<trunk, T>, world, cca::axes<hip>, cca::pantograph{}>;
template <class T>
using no_outputs = cca::feed_forward<late<cca::hyperbolic_tangent, T>, 4>;
template <class T>
using component_option = cca::tracker<late<cca::vite<leg_angles>, T>, cca::tracking<leg_angles>, int, double>;
template <class T>
using no_line = cca::gmr_module<late<leg_angles, T>, leg_angles, 4>;
template <class T>
using no_circle = cca::gmr_module<late<gait_phase, T>, leg_angles, 4>;
template <class T>
using no_pose = cca::pose_shape<late<leg_angles, T>, 8>;
template <class T>
using choices = cca::detail::step_option<late<cca::then_one_of<>, T>>;
template <class T>
using no_description = cca::gravity_compensation<late<described, T>, leg_angles, leg_torques>;
template <class T>
using none = cca::limiter<late<leg_angles, T>>;

}  // namespace broken

#ifndef CCA_REJECT
constexpr auto size = sizeof(broken::none<trunk>);
#else
constexpr auto size = sizeof(broken::CCA_REJECT<trunk>);
#endif
