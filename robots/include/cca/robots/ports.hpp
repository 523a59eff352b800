// The spaces and the graph of a described robot, simulated or real: generated from the axes of its body,
// those whose joints are measured.
//
//   in   "position", "velocity", "torque", "stiffness", "damping"
//                      those in R::commands, each optional (commands.hpp)
//   out  "angles"      angles<R>       rad        "velocities"  velocities<R>   rad/s
//        "torques"     torques<R>      N m        and each sensor of R under its name
//   or, instead of these, the groups of joints that R names (groups.hpp)
//
//   struct my_robot : cca::robots::graph_of_robot<R, "simulator", device, "simulator", joint_node> {};
//
//   Device   the resource node that alone knows the simulator or the buses.
//              sense  out an output for each axis, under its name: measured_joint<R, Axis>; the sensors
//   Motors   the name of the node that takes what the joints want, of Device or of one of More.
//              act    in  an input for each axis, under its name: wanted_joint<R, Axis>; where Device states
//              `servo_axes`, it moves these itself, and takes what their joints want
//   Joint    a template over the axis. sense: in "measured"; out "angle", "velocity", "torque".
//            act: in one input for each command, under its name; out "wanted" (commanded_joint.hpp)
//   More     further lists of items (items.hpp)
//
// Prismatic joints have the units m, m/s and N. The spaces match any others of the same axes and rate.
// Source: the source document, section 6.1 and figure 6.1. Cost: nothing of it is left in the loop.
#pragma once

#include <tuple>

#include <cca/base/joined_names.hpp>
#include <cca/component/strategy.hpp>
#include <cca/robots/description.hpp>
#include <cca/robots/items.hpp>
#include <cca/robots/record.hpp>
#include <cca/skeleton/collector.hpp>
#include <cca/space/record.hpp>

namespace cca::robots {

template <class R>
struct angles : cca::space<joint_angles, measured_axes_of<R>, typename R::rate> {};
template <class R>
struct velocities : cca::space<joint_velocities, measured_axes_of<R>, typename R::rate> {};
template <class R>
struct torques : cca::space<joint_torques, measured_axes_of<R>, typename R::rate> {};
template <class R, class Command>
struct commanded : cca::space<typename Command::domain, measured_axes_of<R>, typename R::rate> {};

namespace detail {

template <class R, class Command>
struct command_space {
  using type = commanded<R, Command>;
};
template <class R, Grouped Command>
struct command_space<R, Command> {
  using type = typename Command::space;
};

template <class R>
struct readings_of {
  using type = readings<angles_of<"angles", angles<R>>,
                        velocities_of<"velocities", velocities<R>>,
                        torques_of<"torques", torques<R>>>;
};
template <class R>
  requires requires { typename R::readings; }
struct readings_of<R> {
  using type = typename R::readings;
};

template <class R, class Axis, class Taken, class Commands>
struct commands_of_joint;
template <class R, class Axis, class... Taken>
struct commands_of_joint<R, Axis, commands<Taken...>, commands<>> {
  using type = commands<Taken...>;
};
template <class R, class Axis, class... Taken, class First, class... Rest>
struct commands_of_joint<R, Axis, commands<Taken...>, commands<First, Rest...>>
    : commands_of_joint<R,
                        Axis,
                        std::conditional_t<command_space<R, First>::type::axes::template contains<Axis>,
                                           commands<Taken..., First>,
                                           commands<Taken...>>,
                        commands<Rest...>> {};

}  // namespace detail

template <class R, class Command>
using command_space = typename detail::command_space<R, Command>::type;
template <class R>
using readings_of = typename detail::readings_of<R>::type;
// Those that a joint takes.
template <class R, class Axis>
using commands_of_joint = typename detail::commands_of_joint<R, Axis, commands<>, typename R::commands>::type;

// One joint: what is read from it, and the numbers of joint_commands.
template <class R, class Axis>
struct joint_readings : record_of<field<"angle", sub_space<angles<R>, Axis>>,
                                  field<"velocity", sub_space<velocities<R>, Axis>>,
                                  field<"torque", sub_space<torques<R>, Axis>>> {};
struct raw_joint : cca::record<3> {};
struct raw_commands : cca::record<static_cast<int>(command_kinds)> {};
template <class R, class Axis>
struct measured_joint : cca::space<raw_joint, axes<Axis>, typename R::rate> {};
template <class R, class Axis>
struct wanted_joint : cca::space<raw_commands, axes<Axis>, typename R::rate> {};

// What a sensor reads.
template <class R, class Sensor>
struct sensed : cca::space<typename Sensor::template domain<typename R::body>,
                           typename Sensor::axes,
                           typename R::rate> {};
template <class R, class Sensor>
using sensed_load = sensed<R, Sensor>;

namespace detail {

using cca::detail::joined_name;

// A splitter whose input need not be wired: then none of its outputs publishes.
template <class Space, class Axes = typename Space::axes>
struct optional_splitter;
template <class Space, class... Axes>
struct optional_splitter<Space, axes<Axes...>> {
  static constexpr bool preserves_limits = true;

  // Otherwise a beat would call it: docs/compilers.md.
  [[gnu::always_inline]] auto process(optional_in<"whole", Space> whole)
      -> std::tuple<maybe<Axes::label, sub_space<Space, Axes>>...> {
    if (!whole || whole.origin() == never) return {};
    return {maybe<Axes::label, sub_space<Space, Axes>>(whole[Axes{}])...};
  }
};

template <class Command, class Axes>
struct command_wires;
template <class Command, class... Axes>
struct command_wires<Command, axes<Axes...>> {
  using type =
      items<wire<joined_name<Command::name, Axes::label>, joined_name<Axes::label, Command::name>>...>;
};

template <class Reading, class Axes>
struct reading_wires;
template <class Reading, class... Axes>
struct reading_wires<Reading, axes<Axes...>> {
  using type = items<wire<joined_name<Axes::label, Reading::of>, joined_name<Reading::name, Axes::label>>...>;
};

// The axes that a device moves itself.
template <class Device>
struct servo_axes_of {
  using type = axes<>;
};
template <class Device>
  requires requires { typename Device::servo_axes; }
struct servo_axes_of<Device> {
  using type = typename Device::servo_axes;
};

template <fixed_string Device, fixed_string Motors, bool IsServo>
inline constexpr auto mover = Motors;
template <fixed_string Device, fixed_string Motors>
inline constexpr auto mover<Device, Motors, true> = Device;

template <fixed_string Device, fixed_string Motors, class Servos, class Axes>
struct joint_items;
template <fixed_string Device, fixed_string Motors, class Servos, class... Axes>
struct joint_items<Device, Motors, Servos, axes<Axes...>> {
  template <template <class> class Joint>
  using nodes = items<node<Axes::label, Joint<Axes>>...>;
  using in = items<wire<joined_name<Device, Axes::label>, joined_name<Axes::label, "measured">>...>;
  using out =
      items<wire<joined_name<Axes::label, "wanted">,
                 joined_name<mover<Device, Motors, Servos::template contains<Axes>>, Axes::label>>...>;
};

template <class R,
          fixed_string Name,
          class Device,
          fixed_string Motors,
          template <class> class Joint,
          class Commands,
          class Readings,
          class Sensors,
          class... More>
struct robot_graph;
template <class R,
          fixed_string Name,
          class Device,
          fixed_string Motors,
          template <class> class Joint,
          class... Commands,
          class... Readings,
          class... Sensors,
          class... More>
struct robot_graph<R,
                   Name,
                   Device,
                   Motors,
                   Joint,
                   commands<Commands...>,
                   readings<Readings...>,
                   sensors<Sensors...>,
                   More...> {
  using joints = joint_items<Name, Motors, typename servo_axes_of<Device>::type, measured_axes_of<R>>;
  template <class Command>
  using taken = robots::command_space<R, Command>;
  using type =
      graph_of<items<typename R::rate, node<Name, Device>>,
               typename joints::template nodes<Joint>,
               items<node<Commands::name, optional_splitter<taken<Commands>>, full_speed>...,
                     node<Readings::name, collector<"whole", typename Readings::space>, moderate>...>,
               typename command_wires<Commands, typename taken<Commands>::axes>::type...,
               typename joints::in,
               typename reading_wires<Readings, typename Readings::space::axes>::type...,
               typename joints::out,
               More...,
               items<expose<joined_name<Commands::name, "whole">, Commands::name>...,
                     expose<joined_name<Readings::name, "whole">, Readings::name>...,
                     expose<joined_name<Name, Sensors::name>, Sensors::name>...>>;
};

}  // namespace detail

// A description with a mistake is reported first.
template <class R,
          fixed_string Name,
          class Device,
          fixed_string Motors,
          template <class> class Joint,
          class... More>
using graph_of_robot = typename detail::robot_graph<std::enable_if_t<check_without_masses<R>(), R>,
                                                    Name,
                                                    Device,
                                                    Motors,
                                                    Joint,
                                                    typename R::commands,
                                                    readings_of<R>,
                                                    sensors_of<R>,
                                                    More...>::type;

}  // namespace cca::robots
