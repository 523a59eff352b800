// Two legs that hang from a fixed trunk in compiled physics, moved by torques; imported policies, `stand` and
// `damp` as its modes.
#pragma once

#include <array>
#include <limits>
#include <tuple>

#include <cca/mapping/imported/policy_watchdog.hpp>
#include <cca/mapping/imported/setpoint_blend.hpp>
#include <cca/mapping/imported/setpoint_servo.hpp>
#include <cca/modes.hpp>
#include <cca/robot.hpp>
#include <cca/robots/description.hpp>
#include <cca/sim/compiled/robot.hpp>

#include "walker.hpp"

#include "written/other.hpp"
#include "written/walk.hpp"

namespace policies::hanging {

struct left_foot : cca::frame<"left_foot"> {};
struct right_foot : cca::frame<"right_foot"> {};

template <class Foot, class Hip, class Knee, int Side>
struct leg : cca::serial_chain<trunk, Foot, cca::axes<Hip, Knee>> {
  static constexpr std::array joints{cca::revolute(cca::along_y, cca::at(0, 0.1 * Side, 0)),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.3))};
  static constexpr auto tip = cca::at(0, 0, -0.3);
  static constexpr std::array links{cca::link_inertia{2, {0, 0, -0.15}, {0.02, 0.02, 0.002, 0, 0, 0}},
                                    cca::link_inertia{1, {0, 0, -0.15}, {0.01, 0.01, 0.001, 0, 0, 0}}};
};
struct body : cca::body<trunk,
                        cca::part<"left", leg<left_foot, left_hip, walker::left_knee_bend, 1>>,
                        cca::part<"right", leg<right_foot, right_hip, right_knee, -1>>> {};
struct description {
  using body = hanging::body;
  using rate = cca::rate<1000>;
  using commands = cca::robots::commands<cca::robots::torque_command>;
  static constexpr bool floats = false;
  static constexpr auto drives = [] {
    std::array<cca::robots::joint_drive, 4> all{};
    for (auto& d : all) d.stops = false;
    return all;
  }();
};
using robot = cca::sim::robot<description, cca::sim::compiled>;
using angles = cca::robots::angles<description>;
using velocities = cca::robots::velocities<description>;
using torques = cca::robots::torques<description>;

// The sensors, which the test breaks.
struct senses {
  auto process(cca::in<"angles", angles> q, cca::in<"velocities", velocities> dq)
      -> std::tuple<cca::maybe<"angles", angles>,
                    cca::out<"velocities", velocities>,
                    cca::maybe<"rates", gyro>,
                    cca::out<"gravity", gravity>,
                    cca::out<"attitude", walker::attitude>,
                    cca::out<"command", command>> {
    auto seen = q.vector().eval();
    if (spoils_an_angle) seen[1] = std::numeric_limits<double>::quiet_NaN();
    cca::maybe<"rates", gyro> rates;
    if (says_rates) rates = Eigen::Vector3d(0.1, -0.2, 0.3);
    return {seen, dq.vector(), rates, Eigen::Vector3d(0, 0, -1), Eigen::Vector4d(0, 0, 0, 1), wish};
  }
  bool spoils_an_angle = false, says_rates = true;
  Eigen::Vector2d wish{0.25, 0.5};
};

// [policies]
struct slow_targets : cca::space<cca::joint_angles, angles::axes, cca::rate<50>> {};
struct walking : cca::imported_policy<walk::contract,
                                      cca::policy_inputs<cca::in<"joint_vel_rel", velocities>,
                                                         cca::in<"base_ang_vel", gyro>,
                                                         cca::in<"attitude", walker::attitude>,
                                                         cca::in<"joint_pos_rel", angles>,
                                                         cca::in<"velocity_commands", command>,
                                                         cca::optional_in<"applied", angles>>,
                                      slow_targets> {};
// [policies end]
struct fast_targets : cca::space<cca::joint_angles, angles::axes, cca::rate<100>> {};
struct others : cca::imported_policy<other::contract,
                                     cca::policy_inputs<cca::in<"joint_vel", velocities>,
                                                        cca::in<"base_ang_vel", gyro>,
                                                        cca::in<"projected_gravity", gravity>,
                                                        cca::in<"joint_pos", angles>,
                                                        cca::in<"velocity_commands", command>,
                                                        cca::optional_in<"applied", angles>>,
                                     fast_targets> {};

struct probe {
  void process(cca::in<"target", angles> t,
               cca::in<"stiffness", cca::setpoint_stiffness<angles>> k,
               cca::in<"torques", torques> f) {
    target = t.vector(), stiffness = k.vector(), torque = f.vector();
  }
  Eigen::Vector4d target = Eigen::Vector4d::Zero(), stiffness = target, torque = target;
};

// [intents]
// What wants to move: one of these in each mode. Their nodes have names of their own.
struct to_walk
    : cca::graph<cca::node<"walk", walking, cca::timed<20>>,
                 cca::node<"setpoints_of_walk",
                           cca::policy_setpoints<walk::contract, slow_targets, angles>,
                           cca::timed<1>>,
                 cca::node<"watchdog_of_walk", cca::policy_watchdog<walking, "stand">, cca::timed<1>>,
                 cca::wire<"walk.output", "setpoints_of_walk.target", cca::latest>,
                 cca::wire<"walk.status", "watchdog_of_walk.status", cca::latest>,
                 cca::wire<"walk.term", "watchdog_of_walk.term", cca::latest>,
                 cca::expose<"walk.joint_vel_rel", "velocities">,
                 cca::expose<"walk.base_ang_vel", "rates">,
                 cca::expose<"walk.attitude", "attitude">,
                 cca::expose<"walk.joint_pos_rel", "angles">,
                 cca::expose<"walk.velocity_commands", "command">,
                 cca::expose<"walk.applied", "applied">,
                 cca::expose<"setpoints_of_walk.target", "target">,
                 cca::expose<"setpoints_of_walk.stiffness", "stiffness">,
                 cca::expose<"setpoints_of_walk.damping", "damping">,
                 cca::expose<"setpoints_of_walk.begins", "begins">> {};
// [intents end]
struct to_do_other
    : cca::graph<cca::node<"other", others, cca::timed<10>>,
                 cca::node<"setpoints_of_other",
                           cca::policy_setpoints<other::contract, fast_targets, angles>,
                           cca::timed<1>>,
                 cca::node<"watchdog_of_other", cca::policy_watchdog<others, "damp">, cca::timed<1>>,
                 cca::wire<"other.output", "setpoints_of_other.target", cca::latest>,
                 cca::wire<"other.status", "watchdog_of_other.status", cca::latest>,
                 cca::wire<"other.term", "watchdog_of_other.term", cca::latest>,
                 cca::expose<"other.joint_vel", "velocities">,
                 cca::expose<"other.base_ang_vel", "rates">,
                 cca::expose<"other.projected_gravity", "gravity">,
                 cca::expose<"other.joint_pos", "angles">,
                 cca::expose<"other.velocity_commands", "command">,
                 cca::expose<"other.applied", "applied">,
                 cca::expose<"setpoints_of_other.target", "target">,
                 cca::expose<"setpoints_of_other.stiffness", "stiffness">,
                 cca::expose<"setpoints_of_other.damping", "damping">,
                 cca::expose<"setpoints_of_other.begins", "begins">> {};
struct to_stand : cca::graph<cca::node<"standing", cca::standing_setpoints<angles>, cca::timed<1>>,
                             cca::expose<"standing.applied", "applied">,
                             cca::expose<"standing.measured", "measured">,
                             cca::expose<"standing.target", "target">,
                             cca::expose<"standing.stiffness", "stiffness">,
                             cca::expose<"standing.damping", "damping">,
                             cca::expose<"standing.begins", "begins">> {};
struct to_damp : cca::graph<cca::node<"braking", cca::damping_setpoints<angles>, cca::timed<1>>,
                            cca::expose<"braking.applied", "applied">,
                            cca::expose<"braking.measured", "measured">,
                            cca::expose<"braking.target", "target">,
                            cca::expose<"braking.stiffness", "stiffness">,
                            cca::expose<"braking.damping", "damping">,
                            cca::expose<"braking.begins", "begins">> {};

// [below]
// What all modes share. `Wires`: to the inputs of the intent.
template <class Intent, class... Wires>
using mode_of =
    cca::graph<cca::rate<1000>,
               cca::node<"senses", senses, cca::timed<1>>,
               cca::node<"intent", Intent>,
               cca::node<"blend", cca::setpoint_blend<angles>, cca::timed<1>>,
               cca::node<"servo", cca::setpoint_servo<angles, velocities, torques>, cca::timed<1>>,
               cca::node<"limits", cca::limiter<torques>>,
               cca::node<"robot", robot>,
               cca::node<"probe", probe, cca::timed<1>>,

               cca::wire<"robot.angles", "senses.angles">,
               cca::wire<"robot.velocities", "senses.velocities">,
               Wires...,
               cca::wire<"blend.target", "intent.applied", cca::delayed<1>>,

               cca::wire<"intent.target", "blend.target">,
               cca::wire<"intent.stiffness", "blend.stiffness">,
               cca::wire<"intent.damping", "blend.damping">,
               cca::wire<"intent.begins", "blend.begins">,
               cca::wire<"senses.angles", "blend.measured">,
               cca::wire<"blend.target", "servo.target">,
               cca::wire<"blend.stiffness", "servo.stiffness">,
               cca::wire<"blend.damping", "servo.damping">,
               cca::wire<"senses.angles", "servo.angles">,
               cca::wire<"senses.velocities", "servo.velocities">,
               cca::wire<"servo.torques", "limits.command">,
               cca::wire<"limits.safe", "robot.torque">,

               cca::wire<"blend.target", "probe.target">,
               cca::wire<"blend.stiffness", "probe.stiffness">,
               cca::wire<"limits.safe", "probe.torques">>;

struct walk_mode : mode_of<to_walk,
                           cca::wire<"senses.velocities", "intent.velocities", cca::latest>,
                           cca::wire<"senses.rates", "intent.rates", cca::latest>,
                           cca::wire<"senses.attitude", "intent.attitude", cca::latest>,
                           cca::wire<"senses.angles", "intent.angles", cca::latest>,
                           cca::wire<"senses.command", "intent.command", cca::latest>> {};
struct stand_mode : mode_of<to_stand, cca::wire<"senses.angles", "intent.measured">> {};
struct damp_mode : mode_of<to_damp, cca::wire<"senses.angles", "intent.measured">> {};
// [below end]
struct other_mode : mode_of<to_do_other,
                            cca::wire<"senses.velocities", "intent.velocities", cca::latest>,
                            cca::wire<"senses.rates", "intent.rates", cca::latest>,
                            cca::wire<"senses.gravity", "intent.gravity", cca::latest>,
                            cca::wire<"senses.angles", "intent.angles", cca::latest>,
                            cca::wire<"senses.command", "intent.command", cca::latest>> {};

// [modes]
struct legs : cca::modes<cca::mode<"walk", walk_mode>,
                         cca::mode<"other", other_mode>,
                         cca::mode<"stand", stand_mode>,
                         cca::mode<"damp", damp_mode>> {};
// [modes end]

}  // namespace policies::hanging
