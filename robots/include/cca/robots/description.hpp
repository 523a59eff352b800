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
#include <cca/robots/description_mistakes.hpp>
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

template <class R> concept HasBody = Body<typename R::body>;
template <class R>
using lacking = members_missing<R,
                                HasBody<R>,
                                requires { typename R::rate; },
                                requires { typename R::commands; },
                                requires { R::drives.size(); }>;

template <class R>
constexpr void check_masses() {
  using body = typename R::body;
  static_assert(cca::detail::holds_or_tells<(massless_link<body> < 0), link_without_mass<R>>::value);
  static_assert(cca::detail::holds_or_tells<(!floats<R> || (cca::detail::base_inertia_of<body>().mass > 0)),
                                            base_without_mass<R>>::value);
}

template <class R>
constexpr void check_places() {
  using body = typename R::body;
  using sensors = robots::sensors_of<R>;
  static_assert(cca::detail::holds_or_tells<(lost_shape<R> < 0), shape_on_nothing<R>>::value);
  static_assert(cca::detail::holds_or_tells<(lost_spring<R> < 0), spring_on_nothing<R>>::value);
  static_assert(
      cca::detail::holds_or_tells<all_parts_exist<body>(sensors()), sensor_on_nothing<R, sensors>>::value);
}

template <class R, bool HasMasses>
constexpr bool check() {
  static_assert(cca::detail::holds_or_tells<Described<R>, lacking<R>>::value);
  if constexpr (Described<R>) {
    constexpr bool drives = R::drives.size() == static_cast<std::size_t>(axes_of_robot<R>::count);
    static_assert(cca::detail::holds_or_tells<drives, wrong_drive_count<R>>::value);
    if constexpr (drives) {
      constexpr bool measured = unmeasured_motor<R> < 0;
      static_assert(cca::detail::holds_or_tells<measured, motor_not_measured<R>>::value);
      if constexpr (measured) {
        using all = measured_axes_of<R>;
        static_assert(
            cca::detail::holds_or_tells<(groups_exist<all>(typename R::commands()) && readings_exist<R>()),
                                        port_over_other_axis<R, all>>::value);
        static_assert(
            cca::detail::holds_or_tells<command_once(typename R::commands()), commanded_twice<R>>::value);
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
