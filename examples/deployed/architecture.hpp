#pragma once
// The Combination of Skills, cut into four environments (the source document, figure 4.7): the robot, its
// reflexes, its mind, and the simulation on a workstation of its own. docs/deployed.md
//
// Read first: stage.hpp (the simulation), remote_oncilla.hpp, recorder.hpp; forms.hpp runs it. Components and
// graphs are those of examples/combination_of_skills. Only the wires from one environment to another are
// different: they are delayed.
#include <cca/deployment.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/robots/oncilla/legged_body.hpp>

#include "../combination_of_skills/architecture.hpp"
#include "recorder.hpp"
#include "remote_oncilla.hpp"
#include "with_items.hpp"

namespace deployed {

using skills::point_in_trunk;

// The camera of the robot. Its pictures come from the stage.
struct camera {
  auto sense(cca::in<"picture", point_in_trunk> seen) -> cca::maybe<"ball", point_in_trunk> {
    if (seen.origin() == cca::never) return {};
    return seen.vector();
  }
};

// [architecture]
struct architecture
    : with_items<
          skills::architecture<remote_oncilla, camera>,
          // From the simulation to the robot, and back: as on a bus.
          cca::wire<"robot.ball", "camera.picture", cca::delayed<1>>,
          cca::wire<"sequencer.step", "robot.step", cca::delayed<2>>,
          cca::wire<"sequencer.timed_out", "robot.timed_out", cca::delayed<2>>,

          // From the robot to its reflexes.
          cca::wire<"robot.angles", "measured.angles", cca::delayed<1>>,
          cca::wire<"robot.abducted", "measured.abducted", cca::delayed<1>>,
          cca::wire<"robot.angles", "dmp.feedback", cca::delayed<1>>,
          cca::wire<"robot.angles", "paw.angles", cca::delayed<1>>,
          cca::wire<"robot.abducted", "paw.abducted", cca::delayed<1>>,
          cca::wire<"robot.contacts", "paw.contacts", cca::delayed<2>>,
          cca::wire<"robot.angular_velocity", "balance.angular_velocity", cca::delayed<2>>,
          cca::wire<"robot.angular_velocity", "trunk.angular_velocity", cca::delayed<2>>,
          cca::wire<"camera.ball", "ball.ball", cca::delayed<1>>,
          cca::wire<"camera.ball", "paw.ball", cca::delayed<1>>,
          cca::wire<"camera.ball", "aim.ball", cca::delayed<1>>,
          cca::wire<"camera.ball", "reaching.ball", cca::delayed<1>>,
          cca::wire<"camera.ball", "steady.ball", cca::delayed<1>>,

          // From the reflexes to the robot.
          cca::wire<"balance.angles", "limits.command", cca::delayed<1>>,
          cca::wire<"steady.abducted", "abduction_limits.command", cca::delayed<1>>,

          // To the mind. The sequencer hears of all statuses a beat later anyway.
          cca::wire<"robot.orientation", "heading.orientation", cca::delayed<2>>,
          cca::wire<"camera.ball", "heading.ball", cca::delayed<1>>,
          cca::wire<"camera.ball", "orders.ball", cca::delayed<1>>,
          cca::wire<"aim.aim", "orders.aim", cca::delayed<1>>,
          cca::wire<"paw.side", "orders.side", cca::delayed<1>>,
          cca::wire<"paw.side", "heading.side", cca::delayed<1>>,
          cca::wire<"cpg.amplitude", "heading.amplitude", cca::delayed<1>>,

          // From the mind, which fires every 10 beats: it may take 2 of them.
          cca::wire<"inverse_kinematics.hips", "hip_reaching.target", cca::delayed<2>>,
          cca::wire<"inverse_kinematics.knees", "knee_reaching.target", cca::delayed<2>>,
          cca::wire<"orders.amplitude", "cpg.amplitude", cca::delayed<2>>,
          cca::wire<"orders.supports", "balance.supports", cca::delayed<2>>,
          cca::wire<"orders.stiffness", "stiffness_limits.command", cca::delayed<2>, cca::initial<30.0>>,
          cca::wire<"sequencer.step", "steady.step", cca::delayed<2>>,
          cca::wire<"heading.turn", "steering.turn", cca::delayed<2>>,

          // Records all samples, for the comparison.
          cca::node<"recorder", recorder, cca::timed<1>>> {};
// [architecture end]

// [deployment]
struct split
    : cca::deployment<
          architecture,
          cca::environment<"simulation", cca::nodes<"robot.simulator", "recorder">>,
          cca::environment<"robot",
                           cca::nodes<"robot.left_front_hip",
                                      "robot.right_front_hip",
                                      "robot.left_hind_hip",
                                      "robot.right_hind_hip",
                                      "robot.left_front_knee",
                                      "robot.right_front_knee",
                                      "robot.left_hind_knee",
                                      "robot.right_hind_knee",
                                      "robot.left_front_abduction",
                                      "robot.right_front_abduction",
                                      "robot.left_hind_abduction",
                                      "robot.right_hind_abduction",
                                      "robot.command",
                                      "robot.abduction",
                                      "robot.stiffness",
                                      "robot.angles",
                                      "robot.abducted",
                                      "robot.velocities",
                                      "robot.torques",
                                      "camera",
                                      "limits",
                                      "abduction_limits",
                                      "stiffness_limits">>,
          cca::environment<"mind", cca::nodes<"sequencer", "orders", "inverse_kinematics", "heading">>,
          cca::environment<"reflexes", cca::other_nodes>,
          cca::tolerate<100'000>>,  // no robot falls on anybody: a simulation goes on
      cca::shows<cca::robots::oncilla::legged_body, "robot.angles", "robot.simulator.orientation">,
      cca::recordable,
      cca::traceable {};
// [deployment end]

}  // namespace deployed
