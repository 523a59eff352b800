// The joints and the board among what a robot is made of, `cca::hardware::robot<R, Bus, joint, ..., board>`.
// Checks that each axis has its joint, and has the sentences that name what is missing, too many or wrong.
// Cost: constants; a sentence is compiled only where something does not fit. Error: robot.drives.
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/base/type_name.hpp>
#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/robot/boards/board_facts.hpp>
#include <cca/hardware/robot/boards/no_board.hpp>
#include <cca/robots/ports.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::hardware::detail {

using cca::detail::axis_in_words;
using cca::detail::type_name;

template <class Type> concept ListedJoint = requires {
  typename Type::axis;
  typename Type::drive;
};
template <class Type> concept ListedBoard = requires { typename Type::reading; };

template <class Drives, class Index>
struct joints_of;
template <class Drives, std::size_t... I>
struct joints_of<Drives, std::index_sequence<I...>> {
  using type = joint_list<std::tuple_element_t<I, Drives>...>;
};

// A board is the last of all. What stands before it are the joints.
template <class... Drives>
using last_of = std::tuple_element_t<sizeof...(Drives), std::tuple<no_board, Drives...>>;
template <class... Drives>
constexpr bool ends_with_board = sizeof...(Drives) > 0 && ListedBoard<last_of<Drives...>>;
template <class... Drives>
using board_of = std::conditional_t<ends_with_board<Drives...>, last_of<Drives...>, no_board>;
template <class... Drives>
using joints_before_board =
    typename joints_of<std::tuple<Drives...>,
                       std::make_index_sequence<sizeof...(Drives) - ends_with_board<Drives...>>>::type;

// Something that is no joint stands among the joints.
template <class R, class Joints>
struct no_joint;
template <class R, class... J>
struct no_joint<R, joint_list<J...>> {
  static constexpr bool none = (ListedJoint<J> && ...);

  static constexpr void tell(auto& m) {
    int place = 0;
    (void)(one<J>(m, ++place) || ...);
  }

private:
  template <class One>
  static constexpr bool one(auto& m, int place) {
    if (ListedJoint<One>) return false;
    m << "robot.drives: " << type_name<One>() << ", which is number " << place << " after the bus of "
      << type_name<R>() << ", is no cca::hardware::joint: list all joints, or one cca::hardware::joint_list, "
      << "and then the board, if there is one";
    return true;
  }
};

// The axes that nothing moves: how many, and the first one, whose number is that of `All`.
struct unmoved_axes {
  int count = 0, first = 0;
};
template <class Joints, class Servos, class... All>
constexpr unmoved_axes unmoved(axes<All...>) {
  unmoved_axes u;
  int i = 0;
  const auto look = [&](bool moved) {
    if (!moved && u.count++ == 0) u.first = i;
    ++i;
  };
  (look(Joints::template contains<All> || Servos::template contains<All>), ...);
  return u;
}

template <class R, class Joints, class Servos>
struct axis_not_moved {
  using all = robots::measured_axes_of<R>;
  static constexpr unmoved_axes those = unmoved<Joints, Servos>(all());
  static constexpr bool none = those.count == 0;

  static constexpr void tell(auto& m) {
    m << "robot.drives: the axis `" << axis_in_words(all(), those.first) << "`";
    if (those.count > 1) m << " (and " << those.count - 1 << " more)";
    m << " of " << type_name<R>() << " has no drive";
    if (Servos::count > 0)
      m << ", and no servo of its board moves it; after the bus, list one cca::hardware::joint "
           "for each of the other axes, in any order";
    else
      m << "; after the bus, list one cca::hardware::joint for each measured axis, in the order of "
           "cca::axes_of<body>, and then the board, if there is one";
  }
};

// Nothing is missing, but something is too many.
template <class R, class Joints, class Servos>
struct joint_too_many;
template <class R, class... J, class... Servos>
struct joint_too_many<R, joint_list<J...>, axes<Servos...>> {
  using all = robots::measured_axes_of<R>;
  static constexpr bool none = sizeof...(J) + sizeof...(Servos) == all::count;

  static constexpr void tell(auto& m) {
    int place = 0;
    if (!(joint<typename J::axis>(m, ++place) || ...)) (void)(servo<Servos>(m) || ...);
  }

private:
  template <class Axis>
  static constexpr bool joint(auto& m, int place) {
    int i = 0, before = 0;
    ((before += ++i < place && std::is_same_v<typename J::axis, Axis>), ...);
    const bool of_servo = (std::is_same_v<Servos, Axis> || ...);
    if (all::template contains<Axis> && !of_servo && before == 0) return false;
    m << "robot.drives: the joint `" << type_name<Axis>() << "`, which is number " << place
      << " after the bus of " << type_name<R>() << ", is one too many: "
      << (before > 0 ? "a joint before it moves this axis"
          : of_servo ? "a servo of the board moves this axis"
                     : "its body does not measure this axis")
      << "; leave it out";
    return true;
  }
  template <class Axis>
  static constexpr bool servo(auto& m) {
    if (all::template contains<Axis>) return false;
    m << "robot.drives: a servo of the board of " << type_name<R>() << " moves `" << type_name<Axis>()
      << "`, an axis that its body does not measure; use a board whose servos move axes of this body";
    return true;
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

// The first mistake of the list as the type of its sentence; void: none.
template <class R, class... Drives>
constexpr auto mistake_of_list() {
  using joints = joints_before_board<Drives...>;
  using servos = servo_axes_of<board_of<Drives...>>;
  if constexpr (!no_joint<R, joints>::none) return std::type_identity<no_joint<R, joints>>();
  else {
    using missing = axis_not_moved<R, typename joints::axes, servos>;
    using extra = joint_too_many<R, joints, servos>;
    constexpr bool in_order =
        servos::count != 0 || std::is_same_v<typename joints::axes, robots::measured_axes_of<R>>;
    if constexpr (!missing::none) return std::type_identity<missing>();
    else if constexpr (!extra::none) return std::type_identity<extra>();
    else if constexpr (!in_order) return std::type_identity<drives_in_other_order<R, joints>>();
    else return std::type_identity<void>();
  }
}

}  // namespace cca::hardware::detail
