// What a robot is, in one type: the simulator builds its world from it, and its ports follow from it.
//
//   struct description {
//     using body = arm_body;                 // cca::body; the simulator needs the masses of its links
//     using rate = cca::rate<1000>;          // of all ports; a beat
//     using commands = cca::robots::commands<cca::robots::torque_command>;   // what its drives take
//     static constexpr std::array<cca::robots::joint_drive, 7> drives{...};  // over axes_of<body>
//
//     // optional
//     static constexpr std::array shapes{...};                               // shape.hpp
//     static constexpr std::array line_springs{...};                         // line_spring.hpp
//     using sensors = cca::robots::sensors<cca::robots::force_sensor<"flange_load", "arm">>;  // sensors.hpp
//     static constexpr bool floats = true;   // nothing holds the base; it needs body::base
//     static constexpr std::array<double, 7> start{...};                     // coordinates, rad
//     using readings = ...;                  // ports over some of the joints: groups.hpp
//   };
//
// The limits stand at the axes of the body: those of `angle` are also the stops of the joints, unless a drive
// says `stops = false`. What a command needs a limit of is in commands.hpp. Errors: robot.description.
// Example: robots/arm; docs/robots.md.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/robot/body_pose.hpp>
#include <cca/robots/cable_drive.hpp>
#include <cca/robots/commands.hpp>
#include <cca/robots/crossing.hpp>
#include <cca/robots/groups.hpp>
#include <cca/robots/line_spring.hpp>
#include <cca/robots/motor_line.hpp>
#include <cca/robots/sensors.hpp>
#include <cca/robots/shape.hpp>

namespace cca::robots {

// The drive of a joint and what acts in it besides. Units of a prismatic joint: N, N/m, N s/m, m.
struct joint_drive {
  motor_line motor{};      // without one the joint is passive
  double stiffness = 0;    // N m/rad, of the servo that follows positions and velocities
  double damping = 0;      // N m s/rad, of that servo
  double friction = 0;     // N m s/rad
  double spring = 0;       // N m/rad, of a spring in the joint
  double spring_rest = 0;  // rad, where that spring is slack
  cable_drive cable{};     // with a stiffness: the motor winds it, and acts by it alone
  bool measured = true;    // false: a passive joint that has no port
  bool stops = true;       // false: the limits of its angle bound targets, nothing stops the joint there
  bool holds = false;      // true: before its first command the servo holds the joint where it is

  // Of what a position command pulls with.
  constexpr double position_stiffness() const { return cable.stiffness > 0 ? cable.stiffness : stiffness; }
};

template <class Type> concept Described = Body<typename Type::body> && requires {
  typename Type::rate;
  typename Type::commands;
  Type::drives.size();
};

template <class R>
using axes_of_robot = axes_of<typename R::body>;

namespace detail {

template <class R>
constexpr bool is_measured(std::size_t axis) {
  return axis >= R::drives.size() || R::drives[axis].measured;
}

template <class R,
          class Axes = axes_of_robot<R>,
          class Index = std::make_index_sequence<static_cast<std::size_t>(Axes::count)>>
struct measured_axes;
template <class R, class... Axes, std::size_t... I>
struct measured_axes<R, axes<Axes...>, std::index_sequence<I...>>
    : cca::detail::joined_axes<axes<>, std::conditional_t<is_measured<R>(I), axes<Axes>, axes<>>...> {};

template <class R>
constexpr bool motors_are_measured = [] {
  for (const auto& d : R::drives)
    if (!d.measured && d.motor.torque != 0) return false;
  return true;
}();

}  // namespace detail

// Those that its ports have, in their order.
template <class R>
using measured_axes_of = typename detail::measured_axes<R>::type;

template <class R>
constexpr bool floats = false;
template <class R>
  requires requires { R::floats; }
constexpr bool floats<R> = R::floats;

namespace detail {

template <class R>
struct sensors_of {
  using type = sensors<>;
};
template <class R>
  requires requires { typename R::sensors; }
struct sensors_of<R> {
  using type = typename R::sensors;
};

template <class Body>
constexpr bool moves_mass = [] {
  const auto& links = cca::detail::body_tree_of<Body>.links;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!(links[i].inertia.mass > 0) && crossing_after(links, i) < 0) return false;
  return true;
}();

template <class Body, class Parts>
struct joints_by_part;
template <class Body, class... Parts>
struct joints_by_part<Body, std::tuple<Parts...>> {
  static constexpr std::array<int, sizeof...(Parts)> count{static_cast<int>(Parts::chain::joints.size())...};
};

template <class Body>
constexpr bool place_exists(std::string_view part_name, int link) {
  if (link == shape_on::base) return true;
  const int part = part_index<Body>(part_name);
  if (part < 0 || link < shape_on::tip) return false;
  using joints = joints_by_part<Body, typename Body::parts>;
  return link < joints::count[static_cast<std::size_t>(part)];
}

template <class R>
constexpr bool shapes_exist = [] {
  if constexpr (requires { R::shapes.size(); })
    for (const shape_on& s : R::shapes)
      if (!place_exists<typename R::body>(s.part, s.link)) return false;
  return true;
}();

template <class R>
constexpr bool springs_exist = [] {
  if constexpr (requires { R::line_springs.size(); })
    for (const line_spring& s : R::line_springs)
      for (const point_of_robot& p : {s.from, s.to})
        if (!place_exists<typename R::body>(p.part, p.link)) return false;
  return true;
}();

template <class Body, class Sensor>
constexpr bool parts_exist() {
  for (const std::string_view part : Sensor::parts)
    if (part_index<Body>(part) < 0 && !(is_inertial<Sensor> && part.empty())) return false;
  return true;
}
template <class Body, class... Sensors>
constexpr bool all_parts_exist(sensors<Sensors...>) {
  return (parts_exist<Body, Sensors>() && ...);
}

template <class R>
constexpr bool readings_exist() {
  if constexpr (requires { typename R::readings; })
    return groups_exist<measured_axes_of<R>>(typename R::readings());
  else return true;
}

}  // namespace detail

template <class R>
using sensors_of = typename detail::sensors_of<R>::type;

namespace detail {

template <class R>
constexpr void check_masses() {
  using body = typename R::body;
  static_assert(moves_mass<body>,
                "robot.description: a link of this body has no mass, so no torque could move it; give each "
                "link an inertia, in `links` of its chain; only a link between two hinges that cross at "
                "right angles needs none");
  static_assert(!floats<R> || cca::detail::base_inertia_of<body>().mass > 0,
                "robot.description: this robot floats, but the base of its body has no mass; add "
                "`static constexpr cca::link_inertia base{...};` to the body");
}

template <class R>
constexpr void check_places() {
  using body = typename R::body;
  static_assert(shapes_exist<R>,
                "robot.description: a shape is on a part or on a link that the body doesn't have; correct "
                "the name of the part, or the number of the link, which counts from 0 in each part");
  static_assert(springs_exist<R>,
                "robot.description: a spring or cable ends on a part or on a link that the body doesn't "
                "have; correct the name of the part, or the number of the link, which counts from 0 in each "
                "part");
  static_assert(all_parts_exist<body>(robots::sensors_of<R>()),
                "robot.description: a sensor is at the end of a part that the body doesn't have; correct the "
                "name of the part, the second one in cca::robots::force_sensor<name, part>");
}

template <class R, bool HasMasses>
constexpr bool check() {
  static_assert(Described<R>,
                "robot.description: this description of a robot lacks a `body`, a `rate`, `commands` or "
                "`drives`; state all four, as in cca/robots/description.hpp");
  if constexpr (Described<R>) {
    constexpr bool drives = R::drives.size() == static_cast<std::size_t>(axes_of_robot<R>::count);
    static_assert(drives,
                  "robot.description: `drives` has more or fewer entries than the body has axes; give one "
                  "for each axis, in the order of cca::axes_of<body>, also for a passive joint");
    if constexpr (drives) {
      constexpr bool measured = motors_are_measured<R>;
      static_assert(measured,
                    "robot.description: a joint of this robot has a motor and is not measured, so nobody "
                    "could command it; leave out `measured = false`, or the motor");
      if constexpr (measured) {
        static_assert(
            groups_exist<measured_axes_of<R>>(typename R::commands()) && readings_exist<R>(),
            "robot.description: a port of this robot is over an axis that its body doesn't have, or "
            "that is not measured; take it out of the space of that group, in `commands` or "
            "`readings`");
        static_assert(command_once(typename R::commands()),
                      "robot.description: a joint of this robot is in two groups with the same kind of "
                      "command; take it out of the space of one of them, in `commands`");
        if constexpr (HasMasses) check_masses<R>();
        check_places<R>();
      }
    }
  }
  return true;
}

}  // namespace detail

// Functions that any user of a description calls first. Only the first mistake is reported.
template <class R>
constexpr bool check_description() {
  return detail::check<R, true>();
}

// The same for what needs no masses: ports and drives.
template <class R>
constexpr bool check_without_masses() {
  return detail::check<R, false>();
}

}  // namespace cca::robots
