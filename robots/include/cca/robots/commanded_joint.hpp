// The resource node of one joint of a described robot, as far as it takes commands: the same for the
// simulator and for drives. What it publishes is theirs.
//
//   act   in one input for each command of the joint, under its name; out "wanted" wanted_joint<R, Axis>
//
// A command that has not come yet is NaN in "wanted", one that is not finite is infinite: a servo takes
// neither for a number, and the guards of real drives stop for the second. Used by cca/sim/robot.hpp and
// cca/hardware/robot/robot.hpp.
#pragma once

#include <cmath>
#include <limits>

#include <cca/component/port.hpp>
#include <cca/robots/ports.hpp>

namespace cca::robots {

template <class R, class Axis, class Commands = commands_of_joint<R, Axis>>
struct commanded_joint;

template <class R, class Axis, class... Commands>
struct commanded_joint<R, Axis, commands<Commands...>> {
  auto act(in<Commands::name, sub_space<command_space<R, Commands>, Axis>>... given)
      -> out<"wanted", wanted_joint<R, Axis>> {
    joint_commands c;
    ((c[Commands::kind] = given.origin() == never            ? joint_commands::none
                          : std::isfinite(given.vector()[0]) ? given.vector()[0]
                                                             : std::numeric_limits<double>::infinity()),
     ...);
    return
        typename wanted_joint<R, Axis>::vector_type(wanted_joint<R, Axis>::vector_type::Map(c.values.data()));
  }
};

// The commands in "wanted".
inline joint_commands commands_of(const Eigen::Matrix<double, command_kinds, 1>& v) {
  joint_commands c;
  for (std::size_t i = 0; i < command_kinds; ++i) c.values[i] = v[static_cast<Eigen::Index>(i)];
  return c;
}

}  // namespace cca::robots
