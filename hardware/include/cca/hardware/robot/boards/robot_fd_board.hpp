// A board with the force sensors and inertial units of a robot on its bus, as robot_board.hpp, in CAN FD
// frames: our own protocol, little-endian, at the data bit rate. One frame for each sensor, in each beat.
//
//   id          bytes
//   base + k    force sensor k, along its axes: 0-5 force x y z, i16, 10 mN; 6-11 torque about its origin,
//               i16, 1 mN m; 12 status; 16 in all
//   units + k   inertial unit k: 0-7 orientation in the world x y z w, i16, 1/32767 each; along its axes:
//               8-13 angular velocity, i16, 1 mrad/s; 14-19 specific force, i16, 5 mm/s^2; 20 status; 24 in
//               all
//
// where units = base + Loads. Status: 0 is fine.
//
//   using board = cca::hardware::robot_fd_board<0x40, 4, 1, 6>;   // four loads, one inertial unit, on bus 6
//
// A frame is one measurement, so no reading mixes two. A frame whose orientation is not of unit length
// (within 2 %) is refused. `frames` counts the readings of the sensor that has sent the fewest, so a board of
// which one sensor is silent is silent. A number out of range is clamped. Cost: some dozen instructions a
// frame. docs/robots.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <cca/hardware/robot/boards/ids_of_board.hpp>
#include <cca/hardware/robot/boards/robot_board.hpp>

namespace cca::hardware {

template <std::uint32_t Base,
          std::size_t Loads,
          std::size_t Units,
          std::size_t Bus = 0,
          bit_rates Rates = bit_rates{}>
struct robot_fd_board : detail::board_of_robot<Base, Loads + Units, Loads, Units, Bus, Rates> {
private:
  using base = detail::board_of_robot<Base, Loads + Units, Loads, Units, Bus, Rates>;

public:
  using base::frame_count, base::force_step, base::torque_step, base::speed_step, base::acceleration_step;
  using typename base::reading;
  static_assert(cca::detail::holds_or_tells<(frame_count >= 1 && Base + frame_count - 1 <= 0x7FF),
                                            detail::ids_of_board<Base, frame_count>>::value);
  static constexpr std::array<frame_traffic, 2> traffic{
      {{.shape = {.length = 16, .fd = true, .fast = true}, .a_cycle = static_cast<int>(Loads)},
       {.shape = {.length = 24, .fd = true, .fast = true}, .a_cycle = static_cast<int>(Units)}}};

  static constexpr bool decode(const can_frame& f, reading& r) noexcept {
    if (!base::has_id(f) || !f.fd || f.remote) return false;
    const std::size_t at = f.id.number - Base;
    if (at < Loads ? !take_load(f, r.loads[at], r.status) : !take_unit(f, r.inertial[at - Loads], r.status))
      return false;
    base::count(r, at);
    return true;
  }

  // The board's side: its frames, in the order of their ids. A number that isn't finite is sent as 0.
  static constexpr std::array<can_frame, frame_count> frames(const reading& r, std::uint8_t) noexcept {
    std::array<can_frame, frame_count> all;
    for (std::size_t at = 0; at < frame_count; ++at) {
      all[at] = {.id = standard(static_cast<std::uint32_t>(Base + at)), .fd = true, .fast = true};
      if (at < Loads) put_load(all[at], r.loads[at], r.status);
      else put_unit(all[at], r.inertial[at - Loads], r.status);
    }
    return all;
  }

private:
  // Places of numbers in a frame, and of the status after them.
  enum load_number : std::size_t { force = 0, torque = 3, load_status = 12, load_length = 16 };
  enum unit_number : std::size_t {
    turned = 0,
    turning = 4,
    accelerated = 7,
    unit_status = 20,
    unit_length = 24
  };

  static constexpr bool take_load(const can_frame& f, std::array<double, 6>& load, std::uint8_t& status) {
    if (f.length != load_length) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      load[i] = detail::board_number(f, torque + i, torque_step);
      load[3 + i] = detail::board_number(f, force + i, force_step);
    }
    return status = f.data[load_status], true;
  }
  static constexpr void put_load(can_frame& f, const std::array<double, 6>& load, std::uint8_t status) {
    f.length = load_length;
    for (std::size_t i = 0; i < 3; ++i) {
      detail::put_board_number(f, torque + i, load[i], torque_step);
      detail::put_board_number(f, force + i, load[3 + i], force_step);
    }
    f.data[load_status] = status;
  }

  static constexpr bool take_unit(const can_frame& f, robots::inertial_reading& unit, std::uint8_t& status) {
    if (f.length != unit_length || !detail::take_board_orientation(f, unit.orientation)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      unit.angular_velocity[i] = detail::board_number(f, turning + i, speed_step);
      unit.specific_force[i] = detail::board_number(f, accelerated + i, acceleration_step);
    }
    return status = f.data[unit_status], true;
  }
  static constexpr void put_unit(can_frame& f, const robots::inertial_reading& unit, std::uint8_t status) {
    f.length = unit_length;
    for (std::size_t i = 0; i < 4; ++i)
      detail::put_board_number(f, turned + i, unit.orientation[i], detail::orientation_step);
    for (std::size_t i = 0; i < 3; ++i) {
      detail::put_board_number(f, turning + i, unit.angular_velocity[i], speed_step);
      detail::put_board_number(f, accelerated + i, unit.specific_force[i], acceleration_step);
    }
    f.data[unit_status] = status;
  }
};

}  // namespace cca::hardware
