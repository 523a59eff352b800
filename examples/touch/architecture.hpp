#pragma once
// The demonstrator for any arm with these ports: angles, velocities, torques and the load on the flange out,
// torques in.
//
// Read first: spaces.hpp, then plan.hpp (the order of the skills), orders.hpp and leader.hpp (what each step
// asks for), and the skills: recorder.hpp, repeat.hpp, path.hpp, feel.hpp, wiping.hpp, watch.hpp. scene.hpp
// runs it in the simulator.
#include <cca/adaptive/sequencer.hpp>
#include <cca/cca.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/compliance/cartesian_impedance.hpp>
#include <cca/robot/compliance/passivity_guard.hpp>
#include <cca/robot/dynamics/momentum_observer.hpp>

#include "feel.hpp"
#include "flange.hpp"
#include "leader.hpp"
#include "orders.hpp"
#include "path.hpp"
#include "plan.hpp"
#include "recorder.hpp"
#include "repeat.hpp"
#include "watch.hpp"
#include "wiping.hpp"

namespace touch {

// [parts]
struct operators_button {
  auto process() -> cca::out<"status", button_port> {
    return cca::status_of(pressed ? button::pressed : button::released);
  }
  bool pressed = false;
};

// What the elbow holds.
struct posture {
  auto process() -> cca::out<"angles", arm::angles> {
    return arm::angles::vector_type(arm::angles::vector_type::Map(arm::description::start.data()));
  }
};
struct impedance
    : cca::cartesian_impedance<arm::body, "arm", arm::angles, arm::velocities, arm::torques, flange> {
  impedance() { p.compensate_gravity = false, p.damping_ratio = 1; }
};
struct gravity : cca::gravity_compensation<arm::body, arm::angles, arm::torques> {};
struct guard : cca::passivity_guard<arm::body, arm::angles, arm::velocities, arm::torques> {
  guard() { p = {12, 12}; }
};
struct observer : cca::momentum_observer<arm::body, arm::angles, arm::velocities, arm::torques> {};
// [parts end]

// [architecture]
template <class Robot>
struct architecture
    : cca::graph<cca::rate<1000>,
                 cca::node<"robot", Robot>,
                 cca::node<"flange", cca::part_kinematics<arm::body, "arm", arm::angles, hand>>,
                 cca::node<"motion", flange_motion>,
                 cca::wire<"robot.angles", "flange.angles">,
                 cca::wire<"robot.angles", "motion.angles">,
                 cca::wire<"robot.velocities", "motion.velocities">,
                 cca::wire<"robot.flange_load", "motion.load">,

                 // The plan, and what it asks for.
                 cca::node<"sequencer", cca::sequencer<"*.status.*", plan>, cca::timed<1>>,
                 cca::node<"orders", orders>,
                 cca::wire<"sequencer.step", "orders.step">,
                 cca::wire<"flange.pose", "orders.pose">,
                 cca::wire<"recorder.first", "orders.first">,
                 cca::wire<"recorder.last", "orders.last">,

                 // The skills.
                 cca::node<"recorder", recorder>,
                 cca::wire<"sequencer.step", "recorder.step">,
                 cca::wire<"flange.pose", "recorder.pose">,
                 cca::wire<"motion.twist", "recorder.twist">,
                 cca::node<"repeat", repeated>,
                 cca::wire<"orders.target", "repeat.reference">,
                 cca::wire<"orders.begin", "repeat.begin">,
                 cca::wire<"recorder.first", "repeat.start">,
                 cca::wire<"flange.pose", "repeat.feedback">,
                 cca::node<"path", path, cca::timed<1>>,
                 cca::wire<"orders.go", "path.go">,
                 cca::wire<"orders.goal", "path.goal">,
                 cca::wire<"orders.speed", "path.speed">,
                 cca::wire<"flange.pose", "path.measured">,
                 cca::node<"strokes", strokes, cca::timed<1>>,
                 cca::node<"wiping", ellipse, cca::timed<1>>,
                 cca::node<"middle", middle_of_table, cca::timed<1>>,
                 cca::wire<"orders.amplitude", "strokes.amplitude">,
                 cca::wire<"strokes.phase", "wiping.phase">,
                 cca::wire<"strokes.amplitude", "wiping.amplitude">,
                 cca::wire<"middle.place", "wiping.goal">,

                 // What it feels.
                 cca::node<"feel", feel>,
                 cca::wire<"motion.load", "feel.load">,
                 cca::wire<"flange.pose", "feel.pose">,
                 cca::node<"observer", observer, cca::timed<1>>,
                 cca::wire<"robot.angles", "observer.angles">,
                 cca::wire<"robot.velocities", "observer.velocities">,
                 cca::wire<"robot.torques", "observer.torques">,
                 cca::node<"watch", watch, cca::timed<1>>,
                 cca::wire<"observer.external", "watch.external">,
                 cca::wire<"robot.angles", "watch.angles">,
                 cca::wire<"motion.load", "watch.load">,
                 cca::node<"operator", operators_button, cca::timed<1>>,

                 // From the skills to the joints.
                 cca::node<"leader", leader, cca::timed<1>>,
                 cca::wire<"sequencer.step", "leader.step">,
                 cca::wire<"operator.status", "leader.stop">,
                 cca::wire<"path.pose", "leader.way">,
                 cca::wire<"path.twist", "leader.way_twist">,
                 cca::wire<"repeat.command", "leader.repeated">,
                 cca::wire<"repeat.velocity", "leader.repeated_twist">,
                 cca::wire<"orders.centre", "leader.centre">,
                 cca::wire<"wiping.position", "leader.place">,
                 cca::wire<"wiping.velocity", "leader.place_velocity">,
                 cca::wire<"feel.normal", "leader.normal">,
                 cca::wire<"feel.force", "leader.force">,
                 cca::wire<"feel.status", "leader.feeling">,
                 cca::node<"impedance", impedance, cca::timed<1>>,
                 cca::wire<"leader.reference", "impedance.reference">,
                 cca::wire<"leader.twist", "impedance.reference_twist">,
                 cca::wire<"leader.stiffness", "impedance.stiffness">,
                 cca::wire<"leader.damping", "impedance.damping">,
                 cca::wire<"leader.feedforward", "impedance.feedforward">,
                 cca::wire<"robot.angles", "impedance.angles">,
                 cca::wire<"robot.velocities", "impedance.velocities">,
                 cca::node<"posture", posture, cca::timed<1>>,
                 cca::wire<"posture.angles", "impedance.posture">,
                 cca::node<"gravity", gravity, cca::timed<1>>,
                 cca::wire<"robot.angles", "gravity.angles">,
                 cca::node<"guard", guard, cca::timed<1>>,
                 cca::wire<"impedance.torques", "guard.torques">,
                 cca::wire<"robot.angles", "guard.angles">,
                 cca::wire<"robot.velocities", "guard.velocities">,
                 cca::wire<"gravity.torques", "guard.gravity">,
                 cca::node<"limits", cca::limiter<arm::torques>>,
                 cca::wire<"guard.torques", "limits.command">,
                 cca::wire<"limits.safe", "robot.torque">,

                 // For programs that look on.
                 cca::observe<"feel.*">,
                 cca::observe<"guard.*">> {};
// [architecture end]

}  // namespace touch
