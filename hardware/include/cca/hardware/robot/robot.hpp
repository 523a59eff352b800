// Any described robot on real drives, as a graph with the ports of the simulated one:
// `cca::node<"robot", my_arm>`, where
//
//   struct my_arm : cca::hardware::robot<cca::robots::arm::description, cca::hardware::socket_can,
//                                        a1_drive, ..., a7_drive, flange_board> {};
//
// R: a description (cca/robots/description.hpp), whose rate is 200 Hz to 4 kHz, if its buses carry that
// (bus.overloaded). Bus: any CanBus. Drives: one joint (drives/joint.hpp) for each measured axis of R's body,
// in their order, one by one or as a joint_list; then a board (boards/), if R has sensors. If its servos move
// some of the axes, the joints are those of the others, in any order. Ports, nodes and wires are those of
// every described robot (cca/robots/ports.hpp); the safety chain (safety_chain.hpp) stands between what the
// joints want and the drives, and the limits of the axes bound it.
//
// A drive that takes stiffness follows all commands; one that takes torque alone too: the synchronizer makes
// its torque from the measured angle and velocity. One with gains of its own follows positions, or
// velocities: describe R with these commands alone. docs/robots.md says which family does what.
//
// Give it its buses: controller.get<"robot.synchronizer">().connect(bus0, ...). Starting the controller
// enables the drives. Until they are enabled, and after a trip, the controller runs and nothing moves.
// Where there is no robot, virtual_hardware.hpp plays its drives. Errors: robot.unlimited_command,
// space.missing_limits, bus.overloaded, drive.duplicate_id,
// robot.description, robot.drives. Example: tests/runtime/robot_on_drives/one_joint.cpp; docs/robots.md,
// docs/hardware.md.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/hardware/robot/boards/load_board.hpp>
#include <cca/hardware/robot/drive_checks.hpp>
#include <cca/hardware/robot/robot_nodes.hpp>
#include <cca/hardware/robot/robot_synchronizer.hpp>
#include <cca/hardware/robot/safety_chain.hpp>
#include <cca/hardware/robot/shut_down.hpp>
#include <cca/robots/ports.hpp>

namespace cca::hardware {

namespace detail {

template <class R>
struct driven_joints_of {
  template <class Axis>
  struct node : driven_joint<R, Axis> {};
};

template <class R, class Bus, class Board, class Joints>
using robot_on_drives = robots::graph_of_robot<R,
                                               "synchronizer",
                                               robot_synchronizer<R, Bus, Board, Joints>,
                                               "servos",
                                               driven_joints_of<R>::template node,
                                               safety_nodes<robot_servos<R, Joints>, typename R::rate>,
                                               safety_wires<"synchronizer">,
                                               safety_readings<"synchronizer">>;

// After a mistake there is no graph, so that nothing else is reported.
template <class R, class Bus, class Drives, class Mistake = typename Drives::mistake>
struct robot_parts {
  using type = graph<>;
  struct parts {};
};
template <class R, class Bus, class Drives>
struct robot_parts<R, Bus, Drives, void> {
  using buses_are_sound =
      typename robot_buses<typename R::rate, typename Drives::board, typename Drives::joints>::sound;
  // For virtual_hardware.hpp.
  struct parts {
    using description = R;
    using joints = typename Drives::joints;
    using board = typename Drives::board;
  };
  using type = robot_on_drives<R, Bus, typename Drives::board, typename Drives::joints>;
};

template <class R, class Bus, class... Drives>
struct unchecked_robot : robot_parts<R, Bus, drives_of_robot<R, Drives...>>::type,
                         robot_parts<R, Bus, drives_of_robot<R, Drives...>>::parts {};

template <class R, class... Drives>
using robot_check = no_mistake<typename drives_of_robot<R, Drives...>::mistake>;

}  // namespace detail

template <class R, class Bus, class... Drives>
struct robot : detail::unchecked_robot<R, Bus, Drives...> {
  static_assert(detail::robot_check<R, Drives...>::shown);
};

}  // namespace cca::hardware
