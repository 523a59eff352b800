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
//     static constexpr bool touches_itself = true;  // with its shapes, but for those of neighbours
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
  motor_line motor{};       // without one the joint is passive
  double stiffness = 0;     // N m/rad, of the servo that follows positions and velocities
  double damping = 0;       // N m s/rad, of that servo
  double friction = 0;      // N m s/rad
  double spring = 0;        // N m/rad, of a spring in the joint
  double spring_rest = 0;   // rad, where that spring is slack
  cable_drive cable{};      // with a stiffness: the motor winds it, and acts by it alone
  bool measured = true;     // false: a passive joint that has no port
  bool stops = true;        // false: the limits of its angle bound targets, nothing stops the joint there
  bool holds = false;       // true: before its first command the servo holds the joint where it is
  double dry_friction = 0;  // N m, Coulomb's: it holds the joint up to this torque, and brakes it with it

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

// Links are neighbours that have no third one with a shape between them.
template <class R>
constexpr bool touches_itself = false;
template <class R>
  requires requires { R::touches_itself; }
constexpr bool touches_itself<R> = R::touches_itself;

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

// The first mistake as the type of its sentence; void: none.
template <class R>
constexpr auto mistake_of_places() {
  using sensors = robots::sensors_of<R>;
  if constexpr (lost_shape<R> >= 0) return std::type_identity<shape_on_nothing<R>>();
  else if constexpr (lost_spring<R> >= 0) return std::type_identity<spring_on_nothing<R>>();
  else if constexpr (!all_parts_exist<typename R::body>(sensors()))
    return std::type_identity<sensor_on_nothing<R, sensors>>();
  else return std::type_identity<void>();
}
template <class R, bool HasMasses>
constexpr auto mistake_of_masses() {
  using body = typename R::body;
  if constexpr (!HasMasses) return mistake_of_places<R>();
  else if constexpr (massless_link<body> >= 0) return std::type_identity<link_without_mass<R>>();
  else if constexpr (floats<R> && !(cca::detail::base_inertia_of<body>().mass > 0))
    return std::type_identity<base_without_mass<R>>();
  else return mistake_of_places<R>();
}
template <class R, bool HasMasses>
constexpr auto mistake_of_description() {
  if constexpr (!Described<R>) return std::type_identity<lacking<R>>();
  else if constexpr (R::drives.size() != static_cast<std::size_t>(axes_of_robot<R>::count))
    return std::type_identity<wrong_drive_count<R>>();
  else if constexpr (unmeasured_motor<R> >= 0) return std::type_identity<motor_not_measured<R>>();
  else if constexpr (!groups_exist<measured_axes_of<R>>(typename R::commands()) || !readings_exist<R>())
    return std::type_identity<port_over_other_axis<R, measured_axes_of<R>>>();
  else if constexpr (!command_once(typename R::commands())) return std::type_identity<commanded_twice<R>>();
  else return mistake_of_masses<R, HasMasses>();
}
template <class R, bool HasMasses>
using description_mistake = typename decltype(mistake_of_description<R, HasMasses>())::type;

template <class R, bool HasMasses>
constexpr bool check() {
  using mistake = description_mistake<R, HasMasses>;
  static_assert(cca::detail::holds_or_tells<std::is_void_v<mistake>, mistake>::value);
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
