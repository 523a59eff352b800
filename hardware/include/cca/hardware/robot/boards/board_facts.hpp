// What a board reads and moves, from the type of its readings. A reading has what its board has:
//
//   loads         an array: torque and force of each force sensor
//   inertial      an array of robots::inertial_reading; or the reading has its members
//   foot_load     an array: N, of each foot; then also contacts(), 1 where a foot touches
//   servo_axes    the axes that the board's servos move. Then it has their angles, `abduction` (rad), and
//                 Board::abduct(targets) makes the frame for them; a target that is not a number changes
//                 nothing
//
// What is not a number has not been sent yet. Boards: robot_board.hpp, robot_fd_board.hpp,
// oncilla/sensor_board.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include <cca/robots/ports.hpp>

namespace cca::hardware::detail {

template <class Board>
using servo_axes_of = typename robots::detail::servo_axes_of<typename Board::reading>::type;

template <class Array>
constexpr std::size_t size_of_array = std::tuple_size_v<std::remove_cvref_t<Array>>;

template <class Reading>
constexpr std::size_t loads_of = 0;
template <class Reading>
  requires requires(Reading r) { r.loads; }
constexpr std::size_t loads_of<Reading> = size_of_array<decltype(Reading::loads)>;

template <class Reading>
constexpr std::size_t units_of = requires(Reading r) { r.specific_force; } ? 1 : 0;
template <class Reading>
  requires requires(Reading r) { r.inertial; }
constexpr std::size_t units_of<Reading> = size_of_array<decltype(Reading::inertial)>;

template <class Reading>
constexpr std::size_t feet_of = 0;
template <class Reading>
  requires requires(Reading r) { r.foot_load; }
constexpr std::size_t feet_of<Reading> = size_of_array<decltype(Reading::foot_load)>;

// Whether a board has all force sensors and feet, and an inertial unit where each of the others sits.
template <class Board, class... Sensors>
constexpr bool has_sensors(robots::sensors<Sensors...> all) {
  using reading = typename Board::reading;
  constexpr auto reads = [](std::size_t has, std::size_t needs) { return needs == 0 || has == needs; };
  return reads(loads_of<reading>, robots::detail::load_count(all)) &&
         reads(units_of<reading>, robots::detail::unit_count(all)) &&
         reads(feet_of<reading>, robots::detail::feet_count(all));
}

// The numbers of a sensor of `All`.
template <class Sensor, class All, class Reading>
constexpr decltype(auto) numbers_of(const Reading& now) {
  using enum robots::sensor_kind;
  if constexpr (Sensor::kind == load) return (now.loads[robots::detail::place_among_loads<Sensor>(All())]);
  else if constexpr (Sensor::kind == foot_load) return (now.foot_load);
  else if constexpr (Sensor::kind == foot_contact) return now.contacts();
  else if constexpr (requires { now.inertial; })
    return robots::detail::share_of<Sensor>(now.inertial[robots::detail::unit_of<Sensor>(All())]);
  else return robots::detail::share_of<Sensor>(now);
}

}  // namespace cca::hardware::detail
