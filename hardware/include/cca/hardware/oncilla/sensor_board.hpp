// A board with inertial unit, foot sensors and abduction servos on the robot's bus: our own protocol, classic
// frames, little-endian. robot/boards/board_facts.hpp says what a robot takes from its readings.
//
//   id      bytes                                                             to the board, before its frames
//   base    0-7 target of each abduction: i16, 0.1 mrad; -32768: unchanged
//   id      bytes                                                       from the board, each once per beat
//   base+1  0-7 orientation of the trunk in the world: x y z w, i16, 1/32767 each
//   base+2  0-5 angular velocity, axes of the trunk: i16, 1 mrad/s; 6 contacts: bit per foot; 7 counter
//   base+3  0-5 specific force, axes of the trunk: i16, 5 mm/s^2;       6 status, 0: fine;        7 counter
//   base+4  0-7 load of each foot, upwards: i16, 10 mN
//   base+5  0-7 angle of each abduction: i16, 0.1 mrad
// Feet and legs: left front, right front, left hind, right hind. A number out of range is clamped. A
// quaternion that is not of unit length (within 2 %) is refused. Cost: some dozen instructions a frame.
// docs/hardware.md.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <cca/hardware/robot/boards/ids_of_board.hpp>
#include <cca/hardware/drives/board_numbers.hpp>
#include <cca/hardware/drives/drive.hpp>
#include <cca/robots/oncilla/axes.hpp>

namespace cca::hardware {

struct board_reading {
  using servo_axes = robots::oncilla::abduction_axes;
  std::array<double, 4> orientation{0, 0, 0, 1};  // x y z w
  std::array<double, 3> angular_velocity{};       // rad/s
  std::array<double, 3> specific_force{};         // m/s^2
  std::array<double, 4> foot_load{};              // N
  std::array<bool, 4> contact{};
  std::array<double, 4> abduction{};  // rad
  std::uint8_t status = 0;
  std::uint64_t frames = 0;

  // Before the first frame: no numbers.
  static constexpr board_reading untold() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    board_reading r;
    r.orientation.fill(none), r.angular_velocity.fill(none), r.specific_force.fill(none),
        r.foot_load.fill(none), r.abduction.fill(none);
    return r;
  }

  // 1: the foot touches. They come in the frame of the angular velocity, so they are known when that is.
  constexpr std::array<double, 4> contacts() const {
    const double unknown = angular_velocity[0] * 0;  // 0, or not a number
    std::array<double, 4> all{};
    for (std::size_t leg = 0; leg < all.size(); ++leg) all[leg] = (contact[leg] ? 1 : 0) + unknown;
    return all;
  }
};

template <std::uint32_t Base, std::size_t Bus = 0, bit_rates Rates = bit_rates{}>
struct sensor_board {
  // The frames of the board, as offsets from Base; and their places in `frames`.
  enum frame : std::uint32_t { targets, orientation, motion, force, loads, angles };
  static constexpr std::size_t place_of(frame f) { return f - orientation; }

  using reading = board_reading;
  static constexpr std::string_view name = "sensor board";
  static constexpr bit_rates rates = Rates;
  static constexpr std::array<frame_traffic, 1> traffic{{{.shape = {.length = 8}, .a_cycle = 6}}};

  static_assert(
      cca::detail::holds_or_tells<(Base + angles <= 0x7FF), detail::ids_of_board<Base, angles + 1>>::value);
  static constexpr std::size_t bus = Bus;
  static constexpr std::array<can_filter, 5> replies{{{standard(Base + orientation)},
                                                      {standard(Base + motion)},
                                                      {standard(Base + force)},
                                                      {standard(Base + loads)},
                                                      {standard(Base + angles)}}};
  static constexpr std::array<can_filter, 1> requests{{{standard(Base + targets)}}};
  static constexpr double angle_step = 1e-4, speed_step = 1e-3, force_step = 5e-3, load_step = 1e-2;

  static constexpr bool decode(const can_frame& f, board_reading& r) noexcept {
    if (f.id.extended || f.fd || f.remote || f.length != 8 || f.id.number < Base + orientation ||
        f.id.number > Base + angles)
      return false;
    const auto number = [&](std::size_t i, double step) { return detail::board_number(f, i, step); };
    switch (f.id.number - Base) {
      case orientation:
        if (!detail::take_board_orientation(f, r.orientation)) return false;
        break;
      case motion:
        for (std::size_t i = 0; i < 3; ++i) r.angular_velocity[i] = number(i, speed_step);
        for (std::size_t i = 0; i < 4; ++i) r.contact[i] = f.data[6] >> i & 1;
        break;
      case force:
        for (std::size_t i = 0; i < 3; ++i) r.specific_force[i] = number(i, force_step);
        r.status = f.data[6];
        break;
      case loads:
        for (std::size_t i = 0; i < 4; ++i) r.foot_load[i] = number(i, load_step);
        break;
      default:
        for (std::size_t i = 0; i < 4; ++i) r.abduction[i] = number(i, angle_step);
    }
    ++r.frames;
    return true;
  }

  // The board's side: its frames, in the order of their ids.
  static std::array<can_frame, 5> frames(const board_reading& r, std::uint8_t counter) noexcept {
    std::array<can_frame, 5> all;
    for (std::uint32_t i = 0; i < all.size(); ++i)
      all[i] = {.id = standard(Base + orientation + i), .length = 8};
    can_frame &turning = all[place_of(motion)], &accelerating = all[place_of(force)];
    for (std::size_t i = 0; i < 4; ++i) {
      detail::put_board_number(all[place_of(orientation)], i, r.orientation[i], detail::orientation_step);
      detail::put_board_number(all[place_of(loads)], i, r.foot_load[i], load_step);
      detail::put_board_number(all[place_of(angles)], i, r.abduction[i], angle_step);
      turning.data[6] = static_cast<std::uint8_t>(turning.data[6] | r.contact[i] << i);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      detail::put_board_number(turning, i, r.angular_velocity[i], speed_step);
      detail::put_board_number(accelerating, i, r.specific_force[i], force_step);
    }
    accelerating.data[6] = r.status;
    turning.data[7] = accelerating.data[7] = counter;
    return all;
  }

  // A target that isn't finite leaves its joint unchanged.
  static can_frame abduct(const std::array<double, 4>& wanted) noexcept {
    can_frame f{.id = standard(Base + targets), .length = 8};
    for (std::size_t i = 0; i < 4; ++i) {
      if (detail::is_finite(wanted[i])) detail::put_board_number(f, i, wanted[i], angle_step);
      else detail::put<std::uint16_t>(f.data, 2 * i, 0x8000);
    }
    return f;
  }
  // Reads the targets that the frame changes; false: another frame.
  static bool abducted(const can_frame& f, std::array<double, 4>& wanted) noexcept {
    if (f.id != standard(Base + targets) || f.fd || f.remote || f.length != 8) return false;
    for (std::size_t i = 0; i < 4; ++i)
      if (const auto n = detail::got<std::uint16_t>(f.payload(), 2 * i); n != 0x8000)
        wanted[i] = static_cast<std::int16_t>(n) * angle_step;
    return true;
  }
};

}  // namespace cca::hardware
