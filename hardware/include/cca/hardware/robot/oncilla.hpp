// The Oncilla on real drives as a graph with the ports of the simulated one: `cca::node<"robot",
// my_oncilla>`, where
//
//   struct my_oncilla : cca::hardware::oncilla<cca::hardware::socket_can, left_front_hip_drive, ..., board>
//   {};
//
// Bus: any CanBus. Drives: eight joints (joint.hpp) in the order of sim::leg_axes, then the sensor board
// (sensor_board.hpp). Ports: those of cca::sim::oncilla, in the same spaces. In front of the drives stands
// the safety chain, each link a node:
//
//   servos -> finite -> stale -> emergency_stop -> soft_stop -> damping -> rate -> limits -> synchronizer
//
// It has to be given its buses: controller.get<"robot.synchronizer">().connect(bus0, ...). Starting the
// controller is the deliberate call that enables the drives; until they are, and after a trip, the controller
// runs and nothing moves. Errors: robot.unlimited_command, space.missing_limits, bus.overloaded,
// drive.duplicate_id. Example: examples/hardware_in_the_loop; docs/hardware.md.
#pragma once

#include <tuple>
#include <utility>

#include <cca/graph/graph.hpp>
#include <cca/hardware/safety/bounds.hpp>
#include <cca/hardware/robot/can_synchronizer.hpp>
#include <cca/hardware/safety/emergency_stop.hpp>
#include <cca/hardware/safety/guards.hpp>
#include <cca/hardware/robot/oncilla_nodes.hpp>
#include <cca/hardware/robot/robot_buses.hpp>
#include <cca/hardware/safety/stopping.hpp>
#include <cca/skeleton/collector.hpp>
#include <cca/skeleton/splitter.hpp>

namespace cca::hardware {

namespace detail {

template <class Drives, class Index = std::make_index_sequence<8>>
struct eight_joints;
template <class Drives, std::size_t... I>
struct eight_joints<Drives, std::index_sequence<I...>> {
  using type = joint_list<std::tuple_element_t<I, Drives>...>;
};

template <class... Drives>
struct oncilla_parts {
  static_assert(sizeof...(Drives) == 9,
                "cca::hardware::oncilla<Bus, Drives...>: eight joints and the sensor board");
  using joints = typename eight_joints<std::tuple<Drives...>>::type;
  using board = std::tuple_element_t<8, std::tuple<Drives...>>;
  static_assert(std::is_same_v<typename joints::axes, sim::leg_axes>,
                "cca::hardware::oncilla<Bus, Drives...>: its joints come in the order of cca::sim::leg_axes");
  using sound = typename robot_buses<cca::rate<1000>, board, joints>::sound;
};

}  // namespace detail

template <class Bus, class... Drives>
struct oncilla
    : cca::graph<
          cca::rate<1000>,
          cca::node<"synchronizer",
                    can_synchronizer<Bus,
                                     typename detail::oncilla_parts<Drives...>::board,
                                     typename detail::oncilla_parts<Drives...>::joints>>,
          cca::node<"left_front_hip", joint_node<sim::left_front_hip>>,
          cca::node<"right_front_hip", joint_node<sim::right_front_hip>>,
          cca::node<"left_hind_hip", joint_node<sim::left_hind_hip>>,
          cca::node<"right_hind_hip", joint_node<sim::right_hind_hip>>,
          cca::node<"left_front_knee", joint_node<sim::left_front_knee>>,
          cca::node<"right_front_knee", joint_node<sim::right_front_knee>>,
          cca::node<"left_hind_knee", joint_node<sim::left_hind_knee>>,
          cca::node<"right_hind_knee", joint_node<sim::right_hind_knee>>,
          cca::node<"trunk", trunk_node>,
          cca::node<"splitter", cca::splitter<"command", sim::leg_angles>>,
          cca::node<"angles", cca::collector<"whole", sim::leg_angles>, cca::moderate>,
          cca::node<"velocities", cca::collector<"whole", sim::leg_velocities>, cca::moderate>,
          cca::node<"torques", cca::collector<"whole", sim::leg_torques>, cca::moderate>,
          cca::node<"servos", joint_servos<typename detail::oncilla_parts<Drives...>::joints>>,
          cca::node<"finite", finite_guard<typename detail::oncilla_parts<Drives...>::joints>>,
          cca::node<"stale", stale_guard<typename detail::oncilla_parts<Drives...>::joints>>,
          cca::node<"emergency_stop", emergency_stop<typename detail::oncilla_parts<Drives...>::joints>>,
          cca::node<"soft_stop", soft_stop<typename detail::oncilla_parts<Drives...>::joints>>,
          cca::node<"damping", damping_stop<typename detail::oncilla_parts<Drives...>::joints>>,
          cca::node<"rate", rate_guard<typename detail::oncilla_parts<Drives...>::joints>>,
          cca::node<"limits", limit_guard<typename detail::oncilla_parts<Drives...>::joints>>,

          cca::wire<"synchronizer.left_front_hip", "left_front_hip.measured">,
          cca::wire<"synchronizer.right_front_hip", "right_front_hip.measured">,
          cca::wire<"synchronizer.left_hind_hip", "left_hind_hip.measured">,
          cca::wire<"synchronizer.right_hind_hip", "right_hind_hip.measured">,
          cca::wire<"synchronizer.left_front_knee", "left_front_knee.measured">,
          cca::wire<"synchronizer.right_front_knee", "right_front_knee.measured">,
          cca::wire<"synchronizer.left_hind_knee", "left_hind_knee.measured">,
          cca::wire<"synchronizer.right_hind_knee", "right_hind_knee.measured">,
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
          cca::wire<"left_front_hip.target", "servos.left_front_hip">,
          cca::wire<"right_front_hip.target", "servos.right_front_hip">,
          cca::wire<"left_hind_hip.target", "servos.left_hind_hip">,
          cca::wire<"right_hind_hip.target", "servos.right_hind_hip">,
          cca::wire<"left_front_knee.target", "servos.left_front_knee">,
          cca::wire<"right_front_knee.target", "servos.right_front_knee">,
          cca::wire<"left_hind_knee.target", "servos.left_hind_knee">,
          cca::wire<"right_hind_knee.target", "servos.right_hind_knee">,
          cca::wire<"synchronizer.trunk", "trunk.measured">,

          cca::wire<"servos.wanted", "finite.wanted">,
          cca::wire<"finite.safe", "stale.wanted">,
          cca::wire<"stale.safe", "emergency_stop.wanted">,
          cca::wire<"emergency_stop.safe", "soft_stop.wanted">,
          cca::wire<"soft_stop.safe", "damping.wanted">,
          cca::wire<"damping.safe", "rate.wanted">,
          cca::wire<"rate.safe", "limits.wanted">,
          cca::wire<"limits.safe", "synchronizer.set_points">,
          cca::wire<"synchronizer.joints", "servos.joints">,
          cca::wire<"synchronizer.joints", "emergency_stop.joints">,
          cca::wire<"synchronizer.joints", "soft_stop.joints">,
          cca::wire<"synchronizer.joints", "damping.joints">,
          cca::wire<"synchronizer.joints", "rate.joints">,
          cca::wire<"synchronizer.joints", "limits.joints">,

          cca::expose<"splitter.command", "command">,
          cca::expose<"synchronizer.abduction", "abduction">,
          cca::expose<"servos.stiffness", "stiffness">,
          cca::expose<"angles.whole", "angles">,
          cca::expose<"velocities.whole", "velocities">,
          cca::expose<"torques.whole", "torques">,
          cca::expose<"trunk.orientation", "orientation">,
          cca::expose<"trunk.angular_velocity", "angular_velocity">,
          cca::expose<"trunk.acceleration", "acceleration">,
          cca::expose<"trunk.contacts", "contacts">,
          cca::expose<"trunk.foot_loads", "foot_loads">,
          cca::expose<"trunk.abduction", "abducted">> {};

}  // namespace cca::hardware
