// The nodes and wires of a robot's joints, generated from the list of its axes. Any number of joints.
//
//   joint_nodes<Node, Axes>                      a resource node `Node<Axis>` for each axis, under its name
//   whole_robot_nodes<Angles, Velocities, Torques>
//                                                "splitter": one command becomes a command for each joint
//                                                "angles", "velocities", "torques": collectors, the way back
//   joint_wires<Synchronizer, Motors, Axes>      the wires between all of these, and to two nodes:
//     Synchronizer   the node that knows the device; has an output for each axis, under its name
//     Motors         the node that takes the targets; has an input for each axis, under its name
//
// `Node<Axis>` has
//   sense   in "measured", what the synchronizer read; out "angle", "velocity", "torque"
//   act     in "command"; out "target"
//
// Source: the source document, section 6.1 and figure 6.1. Cost: none after inlining; the same compile time
// as the wires written by hand. Example: robots/oncilla; tests/runtime/sim/wiring.cpp.
#pragma once

#include <cca/base/joined_names.hpp>
#include <cca/component/strategy.hpp>
#include <cca/robots/items.hpp>
#include <cca/skeleton/collector.hpp>
#include <cca/skeleton/splitter.hpp>

namespace cca::robots {

namespace detail {

using cca::detail::joined_name;

template <template <class> class Node, class Axes>
struct joint_nodes_of;
template <template <class> class Node, class... Axes>
struct joint_nodes_of<Node, axes<Axes...>> {
  using type = items<node<Axes::label, Node<Axes>>...>;
};

template <fixed_string Synchronizer, fixed_string Motors, class Axes>
struct joint_wires_of;
template <fixed_string Synchronizer, fixed_string Motors, class... Axes>
struct joint_wires_of<Synchronizer, Motors, axes<Axes...>> {
  using type = items<wire<joined_name<Synchronizer, Axes::label>, joined_name<Axes::label, "measured">>...,
                     wire<joined_name<Axes::label, "angle">, joined_name<"angles", Axes::label>>...,
                     wire<joined_name<Axes::label, "velocity">, joined_name<"velocities", Axes::label>>...,
                     wire<joined_name<Axes::label, "torque">, joined_name<"torques", Axes::label>>...,
                     wire<joined_name<"splitter", Axes::label>, joined_name<Axes::label, "command">>...,
                     wire<joined_name<Axes::label, "target">, joined_name<Motors, Axes::label>>...>;
};

}  // namespace detail

template <template <class> class Node, class Axes>
using joint_nodes = typename detail::joint_nodes_of<Node, Axes>::type;

template <class Angles, class Velocities, class Torques>
using whole_robot_nodes = items<node<"splitter", splitter<"command", Angles>>,
                                node<"angles", collector<"whole", Angles>, moderate>,
                                node<"velocities", collector<"whole", Velocities>, moderate>,
                                node<"torques", collector<"whole", Torques>, moderate>>;

template <fixed_string Synchronizer, fixed_string Motors, class Axes>
using joint_wires = typename detail::joint_wires_of<Synchronizer, Motors, Axes>::type;

// The ports of the whole robot that its joints make.
using joint_ports = items<expose<"splitter.command", "command">,
                          expose<"angles.whole", "angles">,
                          expose<"velocities.whole", "velocities">,
                          expose<"torques.whole", "torques">>;

}  // namespace cca::robots
