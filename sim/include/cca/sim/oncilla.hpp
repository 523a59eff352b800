#pragma once
// The simulated Oncilla as a graph to be used in any other: `cca::node<"robot", cca::sim::oncilla>`.
//
//   in   "command"       leg_angles: hips and knees, rad            "abduction"  abduction_angles, optional
//                                                                   "stiffness"  hip_stiffnesses, optional
//   out  "angles"        leg_angles                                 "velocities" leg_velocities   "torques"
//   leg_torques
//        "orientation"   trunk_orientation                          "angular_velocity" "acceleration"
//        "contacts"      foot_contacts                              "foot_loads"                  "abducted"
//        abduction_angles
//
// Source: seed, section 6.1 and figure 6.1. As there, hip and knee nodes exist four times each, the
// synchronizer alone knows the simulator, and a splitter and collectors turn samples of eight axes into
// samples of one and back. All of it vanishes in the loop. A real robot takes its place with the same ports.
// Errors: robot.unlimited_command, where a command reaches "command" without a limiter.
#include <cca/graph/graph.hpp>
#include <cca/skeleton/collector.hpp>
#include <cca/skeleton/splitter.hpp>

#include <cca/sim/oncilla_spaces.hpp>
#include <cca/sim/resource_nodes.hpp>
#include <cca/sim/simulator.hpp>

namespace cca::sim {

struct oncilla : cca::graph<cca::rate<1000>,
                            cca::node<"simulator", simulator>,
                            cca::node<"left_front_hip", hip_node<left_front_hip>>,
                            cca::node<"right_front_hip", hip_node<right_front_hip>>,
                            cca::node<"left_hind_hip", hip_node<left_hind_hip>>,
                            cca::node<"right_hind_hip", hip_node<right_hind_hip>>,
                            cca::node<"left_front_knee", knee_node<left_front_knee>>,
                            cca::node<"right_front_knee", knee_node<right_front_knee>>,
                            cca::node<"left_hind_knee", knee_node<left_hind_knee>>,
                            cca::node<"right_hind_knee", knee_node<right_hind_knee>>,
                            cca::node<"trunk", trunk_node>,
                            cca::node<"splitter", cca::splitter<"command", leg_angles>>,
                            cca::node<"angles", cca::collector<"whole", leg_angles>, cca::moderate>,
                            cca::node<"velocities", cca::collector<"whole", leg_velocities>, cca::moderate>,
                            cca::node<"torques", cca::collector<"whole", leg_torques>, cca::moderate>,

                            cca::wire<"simulator.left_front_hip", "left_front_hip.measured">,
                            cca::wire<"simulator.right_front_hip", "right_front_hip.measured">,
                            cca::wire<"simulator.left_hind_hip", "left_hind_hip.measured">,
                            cca::wire<"simulator.right_hind_hip", "right_hind_hip.measured">,
                            cca::wire<"simulator.left_front_knee", "left_front_knee.measured">,
                            cca::wire<"simulator.right_front_knee", "right_front_knee.measured">,
                            cca::wire<"simulator.left_hind_knee", "left_hind_knee.measured">,
                            cca::wire<"simulator.right_hind_knee", "right_hind_knee.measured">,
                            cca::wire<"simulator.trunk", "trunk.measured">,

                            cca::wire<"left_front_hip.angle", "angles.left_front_hip">,
                            cca::wire<"right_front_hip.angle", "angles.right_front_hip">,
                            cca::wire<"left_hind_hip.angle", "angles.left_hind_hip">,
                            cca::wire<"right_hind_hip.angle", "angles.right_hind_hip">,
                            cca::wire<"left_front_knee.angle", "angles.left_front_knee">,
                            cca::wire<"right_front_knee.angle", "angles.right_front_knee">,
                            cca::wire<"left_hind_knee.angle", "angles.left_hind_knee">,
                            cca::wire<"right_hind_knee.angle", "angles.right_hind_knee">,
                            cca::wire<"left_front_hip.velocity", "velocities.left_front_hip">,
                            cca::wire<"right_front_hip.velocity", "velocities.right_front_hip">,
                            cca::wire<"left_hind_hip.velocity", "velocities.left_hind_hip">,
                            cca::wire<"right_hind_hip.velocity", "velocities.right_hind_hip">,
                            cca::wire<"left_front_knee.velocity", "velocities.left_front_knee">,
                            cca::wire<"right_front_knee.velocity", "velocities.right_front_knee">,
                            cca::wire<"left_hind_knee.velocity", "velocities.left_hind_knee">,
                            cca::wire<"right_hind_knee.velocity", "velocities.right_hind_knee">,
                            cca::wire<"left_front_hip.torque", "torques.left_front_hip">,
                            cca::wire<"right_front_hip.torque", "torques.right_front_hip">,
                            cca::wire<"left_hind_hip.torque", "torques.left_hind_hip">,
                            cca::wire<"right_hind_hip.torque", "torques.right_hind_hip">,
                            cca::wire<"left_front_knee.torque", "torques.left_front_knee">,
                            cca::wire<"right_front_knee.torque", "torques.right_front_knee">,
                            cca::wire<"left_hind_knee.torque", "torques.left_hind_knee">,
                            cca::wire<"right_hind_knee.torque", "torques.right_hind_knee">,

                            cca::wire<"splitter.left_front_hip", "left_front_hip.command">,
                            cca::wire<"splitter.right_front_hip", "right_front_hip.command">,
                            cca::wire<"splitter.left_hind_hip", "left_hind_hip.command">,
                            cca::wire<"splitter.right_hind_hip", "right_hind_hip.command">,
                            cca::wire<"splitter.left_front_knee", "left_front_knee.command">,
                            cca::wire<"splitter.right_front_knee", "right_front_knee.command">,
                            cca::wire<"splitter.left_hind_knee", "left_hind_knee.command">,
                            cca::wire<"splitter.right_hind_knee", "right_hind_knee.command">,

                            cca::wire<"left_front_hip.target", "simulator.left_front_hip">,
                            cca::wire<"right_front_hip.target", "simulator.right_front_hip">,
                            cca::wire<"left_hind_hip.target", "simulator.left_hind_hip">,
                            cca::wire<"right_hind_hip.target", "simulator.right_hind_hip">,
                            cca::wire<"left_front_knee.target", "simulator.left_front_knee">,
                            cca::wire<"right_front_knee.target", "simulator.right_front_knee">,
                            cca::wire<"left_hind_knee.target", "simulator.left_hind_knee">,
                            cca::wire<"right_hind_knee.target", "simulator.right_hind_knee">,

                            cca::expose<"splitter.command", "command">,
                            cca::expose<"simulator.abduction", "abduction">,
                            cca::expose<"simulator.stiffness", "stiffness">,
                            cca::expose<"angles.whole", "angles">,
                            cca::expose<"velocities.whole", "velocities">,
                            cca::expose<"torques.whole", "torques">,
                            cca::expose<"trunk.orientation", "orientation">,
                            cca::expose<"trunk.angular_velocity", "angular_velocity">,
                            cca::expose<"trunk.acceleration", "acceleration">,
                            cca::expose<"trunk.contacts", "contacts">,
                            cca::expose<"trunk.foot_loads", "foot_loads">,
                            cca::expose<"trunk.abduction", "abducted">> {};

}  // namespace cca::sim
