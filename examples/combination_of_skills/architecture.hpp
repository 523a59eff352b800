#pragma once
// The Combination of Skills (the source document, section 6.3, figure 6.2) for any robot with the Oncilla's
// ports and a camera.
//
// Read first: spaces.hpp, then plan.hpp (the sequence of skills), orders.hpp (what each step asks for), and
// the components: eyes.hpp, inverse_kinematics.hpp, joints.hpp, steady.hpp, trunk.hpp. rollout.hpp runs it in
// the simulator.
#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/reaching_criterion.hpp>
#include <cca/adaptive/sequencer.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/cca.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/hopf.hpp>
#include <cca/motor/vite.hpp>

#include "eyes.hpp"
#include "inverse_kinematics.hpp"
#include "joints.hpp"
#include "orders.hpp"
#include "plan.hpp"
#include "steady.hpp"
#include "trunk.hpp"

namespace skills {

// [parts]
// Two Reaching Controllers: one for the hips, one for the knees.
template <class Joints>
struct reaching_controller : cca::vite<Joints> {
  reaching_controller() { this->p.settling = {0.05, 0.1}; }
};

struct oscillator : cca::hopf<stride> {
  oscillator() { p.frequency = 4.0; }
};

// The shape of the trot. `combination_of_skills_learn` learns it and writes the file that is read here.
template <int Examples>
struct shape_of_trot
    : cca::dmp_rhythmic_module<oncilla::leg_angles,
                               stride,
                               40,
                               cca::locally_weighted_regression<cca::rhythmic_shape<oncilla::leg_angles, 40>>,
                               Examples> {
  shape_of_trot() { this->p.frequency = 4.0; }
};

struct tracking_criterion : cca::tracking<oncilla::leg_angles> {
  tracking_criterion() { p.limits = {0.2, 0.3, 1.0, 0.1}; }
};

// The DMP Transformation System of figure 6.3.
template <int Examples = 1>
struct dmp_transformation_system : cca::tracker<shape_of_trot<Examples>, tracking_criterion> {};

struct gait_or_stand : cca::arbiter<"angles", oncilla::leg_angles, cca::by_priority<"walking", "standing">> {
};

// Is the paw at the ball? Published as `reaching.status`.
struct reaching_criterion : cca::reaching_goal<point_in_trunk> {
  reaching_criterion() { p.limits = {0.002, 0.004, 1.0, 0.1}; }
};
struct reaching : cca::graph<cca::node<"status", reaching_criterion, cca::timed<1>>,
                             cca::expose<"status.target", "ball">,
                             cca::expose<"status.feedback", "paw">> {};
// [parts end]

// [architecture]
template <class Robot, class Camera = camera>
struct architecture
    : cca::graph<cca::rate<1000>,
                 cca::node<"robot", Robot>,
                 cca::node<"camera", Camera>,
                 cca::node<"sequencer", cca::sequencer<"*.status.*", plan>, cca::timed<10>>,
                 cca::node<"orders", orders, cca::timed<10>>,
                 cca::node<"inverse_kinematics", inverse_kinematics>,
                 cca::node<"hip_reaching", reaching_controller<hip_angles>, cca::timed<1>>,
                 cca::node<"knee_reaching", reaching_controller<knee_angles>, cca::timed<1>>,
                 cca::node<"cpg", oscillator, cca::stoppable<cca::timed<1>>>,
                 cca::node<"dmp", dmp_transformation_system<>, cca::stoppable<>>,

                 // From the sequencer to the joints.
                 cca::wire<"sequencer.step", "orders.step">,
                 cca::wire<"orders.left_front", "inverse_kinematics.left_front">,
                 cca::wire<"orders.right_front", "inverse_kinematics.right_front">,
                 cca::wire<"orders.left_hind", "inverse_kinematics.left_hind">,
                 cca::wire<"orders.right_hind", "inverse_kinematics.right_hind">,
                 cca::wire<"inverse_kinematics.hips", "hip_reaching.target", cca::latest>,
                 cca::wire<"inverse_kinematics.knees", "knee_reaching.target", cca::latest>,
                 cca::wire<"hip_reaching.position", "goal.hips">,
                 cca::wire<"knee_reaching.position", "goal.knees">,
                 cca::node<"goal", joint_goal>,
                 cca::wire<"orders.amplitude", "cpg.amplitude", cca::latest>,
                 cca::wire<"cpg.phase", "dmp.phase">,
                 cca::wire<"cpg.amplitude", "dmp.amplitude">,
                 cca::wire<"steady.angles", "dmp.reference">,
                 cca::wire<"robot.angles", "dmp.feedback">,
                 // While the gait rests, the legs follow the Reaching Controllers.
                 cca::node<"gait", gait_or_stand, cca::port_triggered<"standing">>,
                 cca::wire<"dmp.command", "gait.walking">,
                 cca::wire<"steady.angles", "gait.standing">,
                 cca::wire<"gait.angles", "steering.command">,
                 cca::wire<"steering.angles", "balance.command">,
                 cca::wire<"balance.angles", "limits.command">,
                 cca::wire<"limits.safe", "robot.command">,
                 cca::wire<"steady.abducted", "abduction_limits.command">,
                 cca::wire<"abduction_limits.safe", "robot.abduction">,
                 cca::wire<"orders.stiffness", "stiffness_limits.command", cca::latest>,
                 cca::wire<"stiffness_limits.safe", "robot.stiffness">,
                 cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                 cca::node<"abduction_limits", cca::limiter<oncilla::abduction_angles>>,
                 cca::node<"stiffness_limits", cca::limiter<oncilla::hip_stiffnesses>, cca::timed<1>>,
                 cca::wire<"robot.angles", "limits.measured">,
                 cca::wire<"robot.abducted", "abduction_limits.measured">,

                 // The controllers begin at the measured angles.
                 cca::node<"measured", measured_joints, cca::moderate>,
                 cca::wire<"robot.angles", "measured.angles">,
                 cca::wire<"robot.abducted", "measured.abducted">,
                 cca::wire<"measured.hips", "hip_reaching.start">,
                 cca::wire<"measured.knees", "knee_reaching.start">,

                 // The trunk: heading, balance.
                 cca::node<"heading", heading, cca::stoppable<cca::timed<10>>>,
                 cca::node<"steering", steering, cca::port_triggered<"command">>,
                 cca::node<"balance", balance, cca::port_triggered<"command">>,
                 cca::wire<"robot.orientation", "heading.orientation", cca::latest>,
                 cca::wire<"camera.ball", "heading.ball", cca::latest>,
                 cca::wire<"paw.side", "heading.side", cca::latest>,
                 cca::wire<"cpg.amplitude", "heading.amplitude", cca::latest>,
                 cca::wire<"steady.angles", "steering.goal">,
                 cca::wire<"heading.turn", "steering.turn", cca::latest>,
                 cca::wire<"robot.angular_velocity", "balance.angular_velocity">,
                 cca::wire<"orders.supports", "balance.supports", cca::latest>,

                 // The ball and the paw.
                 cca::node<"paw", nearer_paw, cca::timed<1>>,
                 cca::node<"aim", aim, cca::stoppable<cca::timed<1>>>,
                 cca::node<"ball", ball_watch, cca::timed<1>>,
                 cca::node<"reaching", reaching, cca::stoppable<>>,
                 cca::wire<"camera.ball", "ball.ball", cca::latest>,
                 cca::wire<"camera.ball", "paw.ball", cca::latest>,
                 cca::wire<"robot.angles", "paw.angles">,
                 cca::wire<"robot.abducted", "paw.abducted">,
                 cca::wire<"camera.ball", "aim.ball", cca::latest>,
                 cca::wire<"paw.paw", "aim.paw">,
                 cca::wire<"camera.ball", "reaching.ball", cca::latest>,
                 cca::wire<"paw.paw", "reaching.paw">,
                 cca::node<"steady", steadying, cca::port_triggered<"legs">>,
                 cca::wire<"goal.legs", "steady.legs">,
                 cca::wire<"goal.abduction", "steady.abduction">,
                 cca::wire<"camera.ball", "steady.ball", cca::latest>,
                 cca::wire<"paw.paw", "steady.paw">,
                 cca::wire<"aim.aim", "steady.aim">,
                 cca::wire<"paw.side", "steady.side">,
                 cca::wire<"sequencer.step", "steady.step", cca::latest>,

                 cca::wire<"robot.contacts", "paw.contacts">,
                 cca::wire<"camera.ball", "orders.ball", cca::latest>,
                 cca::wire<"aim.aim", "orders.aim", cca::latest>,
                 cca::wire<"paw.side", "orders.side", cca::latest>,
                 cca::node<"trunk", stillness, cca::timed<1>>,
                 cca::wire<"robot.angular_velocity", "trunk.angular_velocity">,

                 // For programs that look on.
                 cca::observe<"dmp.criterion.*">,
                 cca::observe<"dmp.status.*">> {};
// [architecture end]

}  // namespace skills
