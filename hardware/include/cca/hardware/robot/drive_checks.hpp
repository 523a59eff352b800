// Whether the drives and the board of a robot fit its description, and the sentences that name what does not.
// Cost: constants; a sentence is compiled only where something does not fit.
// Errors: robot.description, robot.drives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/robot/boards/board_facts.hpp>
#include <cca/hardware/robot/boards/no_board.hpp>
#include <cca/hardware/robot/joints_of.hpp>
#include <cca/hardware/robot/robot_buses.hpp>
#include <cca/robots/ports.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::hardware::detail {

using cca::detail::axes_in_words;
using cca::detail::axis_in_words;
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

// The first axis that nothing moves; its number is that of `All`, or -1.
template <class Joints, class Servos, class... All>
constexpr int unmoved_axis(axes<All...>) {
  int first = -1, i = 0;
  ((first = first < 0 && !Joints::template contains<All> && !Servos::template contains<All> ? i : first, ++i),
   ...);
  return first;
}
// The axes of what is a joint.
template <class... Drives>
struct axes_of_drives {
  template <class Drive, class Axis>
  static constexpr bool moves() {
    if constexpr (requires { typename Drive::axis; }) return std::is_same_v<typename Drive::axis, Axis>;
    else return false;
  }
  template <class Axis>
  static constexpr bool contains = (moves<Drives, Axis>() || ...);
};

template <class R, class... Drives>
struct wrong_drive_number {
  static constexpr void tell(auto& m) {
    using all = robots::measured_axes_of<R>;
    using servos = servos_of<Drives...>;
    constexpr int unmoved = unmoved_axis<axes_of_drives<Drives...>, servos>(all());
    m << "robot.drives: the body of " << type_name<R>() << " has " << all::count
      << (all::count == 1 ? " axis that is measured (" : " axes that are measured (") << axes_in_words<all>()
      << ")";
    if (servos::count > 0) m << ", " << servos::count << " of them moved by servos of its board";
    m << ", and " << static_cast<std::int64_t>(sizeof...(Drives))
      << (sizeof...(Drives) == 1 ? " drive or board follows" : " drives and boards follow") << " the bus";
    if (unmoved >= 0) m << ", none for `" << axis_in_words(all(), unmoved) << "`";
    m << ": after the bus, list one cca::hardware::joint for each, and then the board, if there is one";
  }
};

template <class R, class Joints, class Servos>
struct axis_not_moved {
  static constexpr void tell(auto& m) {
    using all = robots::measured_axes_of<R>;
    m << "robot.drives: the axis `" << axis_in_words(all(), unmoved_axis<Joints, Servos>(all())) << "` of "
      << type_name<R>()
      << " has no drive, and no servo of its board moves it; after the bus, list one cca::hardware::joint "
         "for each of the other axes, in any order";
  }
};

template <class R, class Joints>
struct drives_in_other_order;
template <class R, class... J>
struct drives_in_other_order<R, joint_list<J...>> {
  static constexpr void tell(auto& m) {
    using all = robots::measured_axes_of<R>;
    int place = -1, i = 0;
    ((place = place < 0 && type_name<typename J::axis>() != axis_in_words(all(), i) ? i : place, ++i), ...);
    if (place < 0) place = 0;  // types of one name
    m << "robot.drives: the joints of " << type_name<R>()
      << " are not in the order of the axes of its body: drive " << place + 1 << " after the bus is that of `"
      << axis_in_words(axes<typename J::axis...>(), place) << "`, and that axis of the body is `"
      << axis_in_words(all(), place) << "`; list them in the order of cca::axes_of<body>";
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

// Only the first mistake is reported.
template <class R, class... Drives>
constexpr auto check_drives() {
  using cca::detail::holds_or_tells;
  static_assert(robots::check_without_masses<R>());
  constexpr std::size_t count = drive_count<R, Drives...>;
  constexpr bool enough = sizeof...(Drives) == count || sizeof...(Drives) == count + 1;
  static_assert(holds_or_tells<enough, wrong_drive_number<R, Drives...>>::value);
  if constexpr (enough) {
    using joints = typename robot_drives<R, Drives...>::joints;
    using board = typename robot_drives<R, Drives...>::board;
    using servos = servos_of<Drives...>;
    using all = robots::measured_axes_of<R>;
    constexpr bool moved = servos::count == 0 || unmoved_axis<typename joints::axes, servos>(all()) < 0;
    constexpr bool in_order = moved && (servos::count != 0 || std::is_same_v<typename joints::axes, all>);
    constexpr bool can_be_held = held_drives<R, joints>::all;
    constexpr bool senses = has_sensors<board>(robots::sensors_of<R>());
    constexpr bool follows = followers<R, joints, servos>::all;
    static_assert(holds_or_tells<moved, axis_not_moved<R, typename joints::axes, servos>>::value);
    static_assert(holds_or_tells<(in_order || !moved), drives_in_other_order<R, joints>>::value);
    static_assert(holds_or_tells<(can_be_held || !in_order), held_drives<R, joints>>::value);
    static_assert(holds_or_tells<(senses || !can_be_held || !in_order), sensors_not_read<R, board>>::value);
    static_assert(holds_or_tells<(follows || !senses || !can_be_held || !in_order),
                                 followers<R, joints, servos>>::value);
    return std::bool_constant<in_order && can_be_held && senses && follows>{};
  } else {
    return std::false_type{};
  }
}

}  // namespace cca::hardware::detail
