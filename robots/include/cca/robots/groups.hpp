// Ports over some joints of a robot: groups with names and spaces of their own, instead of one port over all.
//
//   struct description {
//     ...
//     using commands = cca::robots::commands<cca::robots::of_joints<"command", position_command, leg_angles>,
//                                            cca::robots::of_joints<"gripper", position_command, fingers>>;
//     using readings = cca::robots::readings<cca::robots::angles_of<"angles", leg_angles>,
//                                            cca::robots::angles_of<"opened", fingers>,
//                                            cca::robots::torques_of<"torques", leg_torques>>;
//   };
//
// The axes of a group's space say which joints it has, in its order; its rate and its domain are those of the
// robot. A joint takes the commands of the groups that it is in, and has no others; of two groups with one
// kind of command it may be in one. Without `readings` a robot has "angles", "velocities" and "torques" of
// all joints that are measured. Errors: robot.description. Example: robots/oncilla/as_built.hpp;
// docs/robots.md.
#pragma once

#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/robots/commands.hpp>
#include <cca/space/space.hpp>

namespace cca::robots {

template <fixed_string Name, class Command, Space Group>
struct of_joints : command<Name, typename Command::domain, Command::kind> {
  using space = Group;
};

// A command that drives with gains of their own may leave out.
template <class Command>
struct hint : Command {
  static constexpr bool is_hint = true;
};

// `of`: the output of each joint that is collected.
template <fixed_string Name, fixed_string Of, Space Group>
struct reading {
  static constexpr auto name = Name;
  static constexpr auto of = Of;
  using space = Group;
};
template <fixed_string Name, Space Group>
struct angles_of : reading<Name, "angle", Group> {};
template <fixed_string Name, Space Group>
struct velocities_of : reading<Name, "velocity", Group> {};
template <fixed_string Name, Space Group>
struct torques_of : reading<Name, "torque", Group> {};

template <class... Readings>
struct readings {};

namespace detail {

template <class Command> concept Grouped = requires { typename Command::space; };

// Whether each axis of a group is among `All`.
template <class All, class... Axes>
constexpr bool are_among(axes<Axes...>) {
  return (All::template contains<Axes> && ...);
}

// Whether no axis is in two groups of one kind of command.
template <class... Commands>
constexpr bool command_once(commands<Commands...>) {
  bool once = true;
  const auto compare = [&once]<class A, class... Axes>(std::type_identity<A>, axes<Axes...>) {
    const auto with = [&]<class B>(std::type_identity<B>) {
      if constexpr (!std::is_same_v<A, B>)
        if (A::kind == B::kind && (B::space::axes::template contains<Axes> || ...)) once = false;
    };
    const auto with_group = [&]<class B>(std::type_identity<B> b) {
      if constexpr (Grouped<B>) with(b);
    };
    (with_group(std::type_identity<Commands>()), ...);
  };
  const auto look = [&]<class A>(std::type_identity<A> a) {
    if constexpr (Grouped<A>) compare(a, typename A::space::axes());
  };
  (look(std::type_identity<Commands>()), ...);
  return once;
}

template <class All, class... Commands>
constexpr bool groups_exist(commands<Commands...>) {
  const auto one = []<class C>(std::type_identity<C>) {
    if constexpr (Grouped<C>) return are_among<All>(typename C::space::axes());
    else return true;
  };
  return (one(std::type_identity<Commands>()) && ...);
}
template <class All, class... Readings>
constexpr bool groups_exist(readings<Readings...>) {
  return (are_among<All>(typename Readings::space::axes()) && ...);
}

}  // namespace detail
}  // namespace cca::robots
