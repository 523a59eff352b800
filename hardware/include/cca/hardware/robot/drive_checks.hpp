// Whether the drives and the board of a robot fit its description, and the sentences that name what does not;
// joints_of.hpp has those of the list of joints.
// Cost: constants; a sentence is compiled only where something does not fit.
// Errors: robot.description, robot.drives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/type_name.hpp>
#include <cca/hardware/bus/can_bus.hpp>
#include <cca/hardware/robot/boards/board_facts.hpp>
#include <cca/hardware/robot/boards/no_board.hpp>
#include <cca/hardware/robot/joints_of.hpp>
#include <cca/hardware/robot/robot_buses.hpp>
#include <cca/robots/ports.hpp>

namespace cca::hardware::detail {

using cca::detail::type_name;

// Whether a drive, with the synchronizer's help, follows commands of a kind.
template <Drive D>
constexpr bool follows(robots::command_kind kind) {
  constexpr bool by_position = (D::uses & of_position) != 0, by_velocity = (D::uses & of_velocity) != 0;
  if ((D::uses & of_stiffness) != 0 || (!by_position && !by_velocity)) return true;
  return kind == robots::command_kind::velocity || (by_position && kind == robots::command_kind::position);
}

// The first command of a joint that its drive does not follow; "": there is none.
template <class D, class... Commands>
constexpr std::string_view not_followed(robots::commands<Commands...>) {
  std::string_view first;
  (void)((Commands::is_hint || follows<D>(Commands::kind) || (first = Commands::name.view(), false)) && ...);
  return first;
}
template <class R, class J>
constexpr std::string_view not_followed_by =
    not_followed<typename J::drive>(robots::commands_of_joint<R, typename J::axis>());
// The same of a servo, which takes positions.
template <class... Commands>
constexpr std::string_view not_a_position(robots::commands<Commands...>) {
  std::string_view first;
  (void)((Commands::kind == robots::command_kind::position || (first = Commands::name.view(), false)) && ...);
  return first;
}

template <class R, class Joints, class Servos>
struct followers;
template <class R, class... J, class... Servos>
struct followers<R, joint_list<J...>, axes<Servos...>> {
  static constexpr bool all = (not_followed_by<R, J>.empty() && ...) &&
                              (not_a_position(robots::commands_of_joint<R, Servos>()).empty() && ...);

  static constexpr void tell(auto& m) {
    if (!(drive<J>(m) || ...)) (void)(servo<Servos>(m) || ...);
  }

private:
  template <class One>
  static constexpr bool drive(auto& m) {
    if (not_followed_by<R, One>.empty()) return false;
    m << "robot.drives: the drive of the joint `" << type_name<typename One::axis>() << "`, "
      << One::drive::name << ", has gains of its own, so it follows positions or velocities, but "
      << type_name<R>() << " has the command `"
      << not_followed_by<
             R,
             One> << "` of that joint in its `commands`; leave it out there, or use a drive that takes torque";
    return true;
  }
  template <class Axis>
  static constexpr bool servo(auto& m) {
    constexpr auto command = not_a_position(robots::commands_of_joint<R, Axis>());
    if (command.empty()) return false;
    m << "robot.drives: a servo of the board moves the joint `" << type_name<Axis>()
      << "`, so it follows positions, but " << type_name<R>() << " has the command `" << command
      << "` of that joint in its `commands`; leave it out there, or give the joint a drive";
    return true;
  }
};

// A beat, and the drives that stop by themselves before the next one.
template <class R, class Joints>
struct held_drives;
template <class R, class... J>
struct held_drives<R, joint_list<J...>> {
  static constexpr double hz = cca::detail::hz_of<typename R::rate>;

  template <class One>
  static constexpr bool stops = One::drive::watchdog.nanoseconds != 0 &&
                                static_cast<double>(One::drive::watchdog.nanoseconds) <= 1e9 / hz;
  static constexpr bool all = hz >= 200 && hz <= 4000 && !(stops<J> || ...);

  static constexpr void tell(auto& m) {
    if (hz < 200 || hz > 4000)
      m << "robot.drives: the rate of " << type_name<R>() << " is " << hz << " Hz, "
        << (hz < 200 ? "below 200 Hz" : "above 4 kHz");
    else (void)(one<J>(m) || ...);
    m << "; write for example `using rate = cca::rate<1000>`, and let slower nodes be cca::timed<N>";
  }

private:
  template <class One>
  static constexpr bool one(auto& m) {
    if (!stops<One>) return false;
    m << "robot.drives: the drive of the joint `" << type_name<typename One::axis>() << "`, "
      << One::drive::name << ", stops by itself after " << One::drive::watchdog.nanoseconds / 1000
      << " us without a command (its `timeout`), and a beat of " << type_name<R>() << " takes "
      << static_cast<std::int64_t>(1e6 / hz) << " us";
    return true;
  }
};

template <class R, class Board>
struct sensors_not_read {
  static constexpr void tell(auto& m) {
    using all = robots::sensors_of<R>;
    using reading = typename Board::reading;
    m << "robot.drives: " << type_name<R>() << " has ";
    numbers(m, robots::detail::load_count(all()), robots::detail::unit_count(all()),
            robots::detail::feet_count(all()));
    m << ", but ";
    if (std::is_same_v<Board, no_board>) m << "no board";
    else {
      m << "its board has ";
      numbers(m, loads_of<reading>, units_of<reading>, feet_of<reading>);
    }
    m << "; after the joints add a cca::hardware::robot_board with the number of its force sensors and of "
         "the places where it has inertial ones";
  }

private:
  static constexpr void numbers(auto& m, std::size_t loads, std::size_t units, std::size_t feet) {
    m << "force sensors: " << static_cast<std::int64_t>(loads)
      << ", inertial ones: " << static_cast<std::int64_t>(units)
      << ", feet: " << static_cast<std::int64_t>(feet);
  }
};

// The first mistake as the type of its sentence; void: none.
template <class R, class... Drives>
constexpr auto mistake_of_drives() {
  using of_list = decltype(mistake_of_list<R, Drives...>());
  if constexpr (!std::is_void_v<typename of_list::type>) return of_list();
  else {
    using joints = joints_before_board<Drives...>;
    using board = board_of<Drives...>;
    using held = held_drives<R, joints>;
    using follow = followers<R, joints, servo_axes_of<board>>;
    if constexpr (!held::all) return std::type_identity<held>();
    else if constexpr (!has_sensors<board>(robots::sensors_of<R>()))
      return std::type_identity<sensors_not_read<R, board>>();
    else if constexpr (!follow::all) return std::type_identity<follow>();
    else return std::type_identity<void>();
  }
}

// The type of the buses stands first.
template <class R, class Bus>
struct no_bus {
  static constexpr void tell(auto& m) {
    m << "robot.drives: " << type_name<Bus>() << ", which stands before the joints of " << type_name<R>()
      << ", is no CAN bus: write the type of its buses there, as in cca::hardware::robot<" << type_name<R>()
      << ", cca::hardware::socket_can, ...>";
  }
};

template <class R, class Bus, class... Drives>
constexpr auto mistake_of_robot() {
  using described = decltype(robots::detail::mistake_of_description<R, false>());
  if constexpr (!std::is_void_v<typename described::type>) return described();
  else if constexpr (!CanBus<Bus>) return std::type_identity<no_bus<R, Bus>>();
  else return mistake_of_drives<R, Drives...>();
}

template <class R, class Bus, class... Drives>
struct drives_of_robot {
  using joints = joints_before_board<Drives...>;
  using board = board_of<Drives...>;
  using mistake = typename decltype(mistake_of_robot<R, Bus, Drives...>())::type;
};
// The joints as one list.
template <class R, class Bus, class... J, class... Board>
struct drives_of_robot<R, Bus, joint_list<J...>, Board...> : drives_of_robot<R, Bus, J..., Board...> {};

}  // namespace cca::hardware::detail
