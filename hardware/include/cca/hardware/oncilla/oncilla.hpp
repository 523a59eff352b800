// The Oncilla on real drives as a graph with the ports of the simulated one:
// `cca::node<"robot", my_oncilla>`, where
//
//   struct my_oncilla : cca::hardware::oncilla<cca::hardware::socket_can, left_front_hip_drive, ..., board>
//   {};
//
// Bus: any CanBus. Drives: eight joints (joint.hpp) in the order of robots::oncilla::leg_axes, then the
// sensor board (sensor_board.hpp). Ports, nodes and wires are those of every Oncilla
// (cca/robots/oncilla/robot.hpp); the safety chain (safety_chain.hpp) stands between the joints' targets and
// the drives. The limits of the axes bound it; body.hpp there says which of them are chosen.
//
// Give it its buses: controller.get<"robot.synchronizer">().connect(bus0, ...). Starting the controller
// enables the drives. Until they are enabled, and after a trip, the controller runs and nothing moves.
// Errors: robot.unlimited_command, space.missing_limits, bus.overloaded, drive.duplicate_id. Example:
// examples/hardware_in_the_loop; docs/hardware.md.
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/hardware/oncilla/can_synchronizer.hpp>
#include <cca/hardware/oncilla/oncilla_nodes.hpp>
#include <cca/hardware/robot/joints_of.hpp>
#include <cca/hardware/robot/robot_buses.hpp>
#include <cca/hardware/robot/safety_chain.hpp>
#include <cca/robots/oncilla/former_names.hpp>
#include <cca/robots/oncilla/robot.hpp>

namespace cca::hardware {

namespace detail {

template <class... Drives>
struct oncilla_drives {
  static constexpr std::size_t count = robots::oncilla::leg_axes::count;
  static_assert(sizeof...(Drives) == count + 1,
                "cca::hardware::oncilla<Bus, Drives...>: eight joints and the sensor board");
  using joints = first_joints<count, Drives...>;
  using board = std::tuple_element_t<count, std::tuple<Drives...>>;
  static_assert(std::is_same_v<typename joints::axes, robots::oncilla::leg_axes>,
                "cca::hardware::oncilla<Bus, Drives...>: its joints come in the order of "
                "cca::robots::oncilla::leg_axes");
  using sound = typename robot_buses<cca::rate<1000>, board, joints>::sound;
};

template <class Bus, class Board, class Joints>
using oncilla_graph = robots::oncilla::robot<"synchronizer",
                                             can_synchronizer<Bus, Board, Joints>,
                                             "servos",
                                             joint_node,
                                             trunk_node,
                                             safety_nodes<joint_servos<Joints>>,
                                             safety_wires<"synchronizer">,
                                             safety_readings<"synchronizer">>;

}  // namespace detail

template <class Bus, class... Drives>
struct oncilla : detail::oncilla_graph<Bus,
                                       typename detail::oncilla_drives<Drives...>::board,
                                       typename detail::oncilla_drives<Drives...>::joints> {};

}  // namespace cca::hardware
