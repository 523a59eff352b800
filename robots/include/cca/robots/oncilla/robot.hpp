// An Oncilla as a graph, simulated or real: the same nodes, wires and ports around another synchronizer.
//
//   in   "command"       leg_angles: hips and knees, rad
//        "abduction"     abduction_angles, optional
//        "stiffness"     hip_stiffnesses, optional
//   out  "angles"        leg_angles            "velocities"        leg_velocities
//        "torques"       leg_torques           "orientation"       trunk_orientation
//        "acceleration"  trunk_acceleration    "angular_velocity"  trunk_angular_velocity
//        "contacts"      foot_contacts         "foot_loads"        foot_loads
//        "abducted"      abduction_angles
//
//   struct oncilla : cca::robots::oncilla::robot<"simulator", simulator, "simulator", joint_node, trunk_node>
//   {};
//
//   Synchronizer, Device   name and type of the node that alone knows the simulator or the buses; it has an
//                          output for each axis (measured_joint), "trunk" (measured_trunk), in "abduction"
//   Motors                 the node that takes the targets of the joints; in "stiffness"
//   Joint, Trunk           the resource nodes (joints.hpp); Trunk publishes the fields of trunk_record
//   More                   further lists of items (items.hpp)
//
// Source: the source document, section 6.1 and figure 6.1: hip and knee nodes, four of each, a splitter and
// collectors. Errors: robot.unlimited_command, where a command reaches "command" without a limiter. Cost:
// nothing of it is left in the loop.
#pragma once

#include <cca/robots/items.hpp>
#include <cca/robots/joints.hpp>
#include <cca/robots/oncilla/spaces.hpp>
#include <cca/robots/record.hpp>

namespace cca::robots::oncilla {

template <fixed_string Synchronizer,
          class Device,
          fixed_string Motors,
          template <class> class Joint,
          class Trunk,
          class... More>
struct robot : graph_of<items<cca::rate<1000>, node<Synchronizer, Device>>,
                        joint_nodes<Joint, leg_axes>,
                        items<node<"trunk", Trunk>>,
                        whole_robot_nodes<leg_angles, leg_velocities, leg_torques>,
                        joint_wires<Synchronizer, Motors, leg_axes>,
                        items<wire<cca::detail::joined_name<Synchronizer, "trunk">, "trunk.measured">>,
                        More...,
                        joint_ports,
                        field_ports<"trunk", trunk_record>,
                        items<expose<cca::detail::joined_name<Synchronizer, "abduction">, "abduction">,
                              expose<cca::detail::joined_name<Motors, "stiffness">, "stiffness">>> {};

}  // namespace cca::robots::oncilla
