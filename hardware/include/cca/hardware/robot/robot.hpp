// Any described robot on real drives, as a graph with the ports of the simulated one:
// `cca::node<"robot", my_arm>`, where
//
//   struct my_arm : cca::hardware::robot<cca::robots::arm::description, cca::hardware::socket_can,
//                                        a1_drive, ..., a7_drive, flange_board> {};
//
// R: a description (cca/robots/description.hpp), whose rate is 200 Hz to 4 kHz, if its buses carry that
// (bus.overloaded). Bus: any CanBus. Drives: one joint (drives/joint.hpp) for each measured axis of R's body,
// in their order; then a board (boards/), if R has sensors. If its servos move some of the axes, the joints
// are those of the others, in any order. Ports, nodes and wires are those of every described
// robot (cca/robots/ports.hpp); the safety chain (safety_chain.hpp) stands between what the joints want and
// the drives, and the limits of the axes bound it.
//
// A drive with stiffness (MIT, moteus) follows all commands; one that takes torque alone (CiA 402 and ODrive
// in torque mode) too: the synchronizer makes its torque from the measured angle and velocity. One with gains
// of its own follows positions, or velocities: describe R with these commands alone.
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

#include <cca/hardware/robot/boards/board_facts.hpp>
#include <cca/hardware/robot/boards/load_board.hpp>
#include <cca/hardware/robot/boards/no_board.hpp>
#include <cca/hardware/robot/joints_of.hpp>
#include <cca/hardware/robot/robot_buses.hpp>
#include <cca/hardware/robot/robot_nodes.hpp>
#include <cca/hardware/robot/robot_synchronizer.hpp>
#include <cca/hardware/robot/safety_chain.hpp>
#include <cca/hardware/robot/shut_down.hpp>
#include <cca/robots/ports.hpp>

namespace cca::hardware {

namespace detail {

// Whether a drive, with the synchronizer's help, follows commands of a kind.
template <Drive D>
constexpr bool follows(robots::command_kind kind) {
  constexpr bool by_position = (D::uses & of_position) != 0, by_velocity = (D::uses & of_velocity) != 0;
  if ((D::uses & of_stiffness) != 0 || (!by_position && !by_velocity)) return true;
  return kind == robots::command_kind::velocity || (by_position && kind == robots::command_kind::position);
}

template <class D, class... Commands>
constexpr bool follows_all(robots::commands<Commands...>) {
  return ((Commands::is_hint || follows<D>(Commands::kind)) && ...);
}
template <class R, class Joints>
inline constexpr bool all_follow = false;
template <class R, class... J>
inline constexpr bool all_follow<R, joint_list<J...>> =
    (follows_all<typename J::drive>(robots::commands_of_joint<R, typename J::axis>()) && ...);

// Whether no drive stops by itself within a beat of so many ns.
template <class Joints>
inline constexpr auto outlast = nullptr;
template <class... J>
inline constexpr auto outlast<joint_list<J...>> = [](double beat) {
  constexpr auto one = [](drive_watchdog w, double ns) {
    return w.nanoseconds == 0 || static_cast<double>(w.nanoseconds) > ns;
  };
  return (one(J::drive::watchdog, beat) && ...);
};

// The axes that the servos of the board move, which is the last of all, if there is one.
template <class Last>
struct servos_of_last {
  using type = axes<>;
};
template <class Last>
  requires requires { typename Last::reading; }
struct servos_of_last<Last> {
  using type = servo_axes_of<Last>;
};

// Whether each axis has a drive or a servo.
template <class Joints, class Servos, class... Axes>
constexpr bool each_is_moved(axes<Axes...>) {
  return ((Joints::axes::template contains<Axes> || Servos::template contains<Axes>) && ...);
}

// Whether the servos take all commands of their axes.
template <class R, class... Servos>
constexpr bool servos_follow(axes<Servos...>) {
  [[maybe_unused]] constexpr auto one = []<class... Commands>(robots::commands<Commands...>) {
    return ((Commands::kind == robots::command_kind::position) && ...);
  };
  return (one(robots::commands_of_joint<R, Servos>()) && ...);
}

template <class... Drives>
using servos_of =
    typename servos_of_last<std::tuple_element_t<sizeof...(Drives), std::tuple<no_board, Drives...>>>::type;
template <class R, class... Drives>
constexpr auto drive_count =
    static_cast<std::size_t>(robots::measured_axes_of<R>::count - servos_of<Drives...>::count);

template <class R, class... Drives>
struct robot_drives {
  static constexpr std::size_t count = drive_count<R, Drives...>;
  using joints = first_joints<count, Drives...>;
  using board = std::tuple_element_t<count, std::tuple<Drives..., no_board>>;
  using sound = typename robot_buses<typename R::rate, board, joints>::sound;
};

// Only the first mistake is reported.
template <class R, class... Drives>
constexpr auto check_drives() {
  static_assert(robots::check_without_masses<R>());
  constexpr std::size_t count = drive_count<R, Drives...>;
  constexpr bool enough = sizeof...(Drives) == count || sizeof...(Drives) == count + 1;
  static_assert(enough,
                "robot.drives: this robot has more or fewer drives than its body has axes that are measured; "
                "after the bus, list one cca::hardware::joint for each, and then the board, if there is one");
  if constexpr (enough) {
    using joints = typename robot_drives<R, Drives...>::joints;
    using board = typename robot_drives<R, Drives...>::board;
    using servos = servos_of<Drives...>;
    constexpr bool moved = servos::count == 0 || each_is_moved<joints, servos>(robots::measured_axes_of<R>());
    constexpr bool in_order =
        moved && (servos::count != 0 || std::is_same_v<typename joints::axes, robots::measured_axes_of<R>>);
    constexpr double hz = cca::detail::hz_of<typename R::rate>;
    constexpr bool can_be_held = hz >= 200 && hz <= 4000 && outlast<joints>(1e9 / hz);
    constexpr bool senses = has_sensors<board>(robots::sensors_of<R>());
    constexpr bool follows = all_follow<R, joints> && servos_follow<R>(servos());
    static_assert(
        moved,
        "robot.drives: an axis of this robot has no drive, and no servo of its board moves it; after "
        "the bus, list one cca::hardware::joint for each of the other axes, in any order");
    static_assert(in_order || !moved,
                  "robot.drives: the joints of this robot are not in the order of its body's axes; list them "
                  "in the order of cca::axes_of<body>");
    if constexpr (in_order)
      static_assert(
          can_be_held,
          "robot.drives: the rate of this robot is below 200 Hz or above 4 kHz, or a drive stops by "
          "itself before the next beat (its `timeout`); write for example `using rate = "
          "cca::rate<1000>`, and let slower nodes be cca::timed<N>");
    if constexpr (in_order && can_be_held)
      static_assert(senses,
                    "robot.drives: this robot has sensors, but no board that reads as many; after the joints "
                    "add a cca::hardware::robot_board with the number of its force sensors and of the places "
                    "where it has inertial ones");
    if constexpr (in_order && can_be_held && senses)
      static_assert(follows,
                    "robot.drives: a drive of this robot has gains of its own, so it follows positions or "
                    "velocities (a servo of its board: positions), but the description has other `commands` "
                    "of its joint; leave those out, or use a drive that takes torque");
    return std::bool_constant<in_order && can_be_held && senses && follows>{};
  } else {
    return std::false_type{};
  }
}

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
template <bool Fits, class R, class Bus, class... Drives>
struct robot_that_fits {
  using type = graph<>;
  struct parts {};
};
template <class R, class Bus, class... Drives>
struct robot_that_fits<true, R, Bus, Drives...> {
  // For virtual_hardware.hpp.
  struct parts {
    using description = R;
    using joints = typename robot_drives<R, Drives...>::joints;
    using board = typename robot_drives<R, Drives...>::board;
  };
  using type = robot_on_drives<R,
                               Bus,
                               typename robot_drives<R, Drives...>::board,
                               typename robot_drives<R, Drives...>::joints>;
};

}  // namespace detail

template <class R, class Bus, class... Drives>
struct robot
    : detail::robot_that_fits<decltype(detail::check_drives<R, Drives...>())::value, R, Bus, Drives...>::type,
      detail::robot_that_fits<decltype(detail::check_drives<R, Drives...>())::value, R, Bus, Drives...>::
          parts {};

}  // namespace cca::hardware
