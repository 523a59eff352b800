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
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/hardware/bus/can_bus.hpp>
#include <cca/hardware/robot/boards/load_board.hpp>
#include <cca/hardware/robot/boards/no_board.hpp>
#include <cca/hardware/robot/drive_checks.hpp>
#include <cca/hardware/robot/robot_nodes.hpp>
#include <cca/hardware/robot/robot_synchronizer.hpp>
#include <cca/hardware/robot/safety_chain.hpp>
#include <cca/hardware/robot/shut_down.hpp>
#include <cca/hardware/safety/emergency_stop.hpp>
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

// After a mistake in its description, its joints or its board a robot has what programs ask for between runs,
// so that the sentence of the mistake is the only error.

// Carries nothing.
struct refused_bus {
  send_result send(std::span<const can_frame>) noexcept { return {}; }
  std::size_t receive(std::span<received_frame>) noexcept { return 0; }
  bus_state state() const noexcept { return {}; }
  bus_counters counters() const noexcept { return {}; }
  std::uint64_t in_flight() const noexcept { return 0; }
};

template <class Usable, class Joints>
struct first_of_each_axis;
template <class... Usable>
struct first_of_each_axis<joint_list<Usable...>, joint_list<>> {
  using type = joint_list<Usable...>;
};
template <class... Usable, class J, class... More>
struct first_of_each_axis<joint_list<Usable...>, joint_list<J, More...>> {
  static constexpr bool is_usable = [] {
    if constexpr (ListedJoint<J>) return !(std::is_same_v<typename J::axis, typename Usable::axis> || ...);
    else return false;
  }();
  using usable = std::conditional_t<is_usable, joint_list<Usable..., J>, joint_list<Usable...>>;
  using type = typename first_of_each_axis<usable, joint_list<More...>>::type;
};
template <class Joints>
using usable_joints = typename first_of_each_axis<joint_list<>, Joints>::type;

template <class Joints>
struct refused_synchronizer : drive_synchronizer<refused_bus, no_board, Joints> {
  template <class... Buses>
  void connect(Buses&...) {}
};

template <class Joints>
struct refused_graph {
  using type = graph<node<"synchronizer", refused_synchronizer<Joints>>,
                     node<"emergency_stop", emergency_stop<Joints>>>;
};
template <>
struct refused_graph<joint_list<>> {
  using type = graph<>;
};

template <class R, class Bus, class Drives, class Mistake = typename Drives::mistake>
struct robot_parts {
  struct parts {
    using description = R;
    using joints = usable_joints<typename Drives::joints>;
    using board = no_board;
    using cca_refused_by = Mistake;
  };
  using type = typename refused_graph<typename parts::joints>::type;
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
struct unchecked_robot : robot_parts<R, Bus, drives_of_robot<R, Bus, Drives...>>::type,
                         robot_parts<R, Bus, drives_of_robot<R, Bus, Drives...>>::parts {};

template <class R, class Bus, class... Drives>
using robot_check =
    cca::detail::holds_or_tells<std::is_void_v<typename drives_of_robot<R, Bus, Drives...>::mistake>,
                                typename drives_of_robot<R, Bus, Drives...>::mistake>;

}  // namespace detail

template <class R, class Bus, class... Drives>
struct robot : detail::unchecked_robot<R, Bus, Drives...> {
  static_assert(detail::robot_check<R, Bus, Drives...>::value);
};

}  // namespace cca::hardware
