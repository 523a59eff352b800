// A board with inertial unit, foot and abduction sensors on the robot's bus: our own protocol, classic
// frames, little-endian.
//
//   id      bytes                                                          to the board, before all that
//   comes from it base    0-7 target of each abduction: i16, 0.1 mrad; -32768: as it is id      bytes from
//   the board, each once a beat base+1  0-7 orientation of the trunk in the world: x y z w, i16, 1/32767 each
//   base+2  0-5 angular velocity, axes of the trunk: i16, 1 mrad/s; 6 contacts: bit per foot; 7 counter
//   base+3  0-5 specific force, axes of the trunk: i16, 5 mm/s^2;       6 status, 0: fine;        7 counter
//   base+4  0-7 load of each foot, upwards: i16, 10 mN
//   base+5  0-7 angle of each abduction: i16, 0.1 mrad
// Feet and legs: left front, right front, left hind, right hind. Beyond its range a number is its end. A
// quaternion that is not of unit length (within 2 %) is refused. Cost: some dozen instructions a frame.
// docs/hardware.md.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <cca/hardware/drives/drive.hpp>
#include <cca/hardware/drives/wire_number.hpp>

namespace cca::hardware {

struct board_reading {
  std::array<double, 4> orientation{0, 0, 0, 1};  // x y z w
  std::array<double, 3> angular_velocity{};       // rad/s
  std::array<double, 3> specific_force{};         // m/s^2
  std::array<double, 4> foot_load{};              // N
  std::array<bool, 4> contact{};
  std::array<double, 4> abduction{};  // rad
  std::uint8_t status = 0;
  std::uint64_t frames = 0;

  // Before anything has been told: no numbers.
  static constexpr board_reading untold() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    board_reading r;
    r.orientation.fill(none), r.angular_velocity.fill(none), r.specific_force.fill(none),
        r.foot_load.fill(none), r.abduction.fill(none);
    return r;
  }
};

template <std::uint32_t Base, std::size_t Bus = 0, bit_rates Rates = bit_rates{}>
struct sensor_board {
  static constexpr std::string_view name = "sensor board";
  static constexpr bit_rates rates = Rates;
  static constexpr std::array<frame_traffic, 1> traffic{{{.shape = {.length = 8}, .a_cycle = 6}}};

  static_assert(Base + 5 <= 0x7FF, "cca::hardware::sensor_board: its ids are base to base + 5, of 11 bits");
  static constexpr std::size_t bus = Bus;
  static constexpr std::array<can_filter, 5> replies{{{standard(Base + 1)},
                                                      {standard(Base + 2)},
                                                      {standard(Base + 3)},
                                                      {standard(Base + 4)},
                                                      {standard(Base + 5)}}};
  static constexpr std::array<can_filter, 1> requests{{{standard(Base)}}};
  static constexpr double angle_step = 1e-4, speed_step = 1e-3, force_step = 5e-3, load_step = 1e-2,
                          part = 1.0 / 32767;

  static constexpr bool decode(const can_frame& f, board_reading& r) noexcept {
    if (f.id.extended || f.fd || f.remote || f.length != 8 || f.id.number <= Base || f.id.number > Base + 5)
      return false;
    const auto number = [&](std::size_t i) {
      return static_cast<double>(static_cast<std::int16_t>(detail::got<std::uint16_t>(f.payload(), 2 * i)));
    };
    switch (f.id.number - Base) {
      case 1: {
        double square = 0;
        for (std::size_t i = 0; i < 4; ++i) square += number(i) * part * number(i) * part;
        if (!(square > 0.96 && square < 1.04)) return false;
        const double length = std::sqrt(square);
        for (std::size_t i = 0; i < 4; ++i) r.orientation[i] = number(i) * part / length;
        break;
      }
      case 2:
        for (std::size_t i = 0; i < 3; ++i) r.angular_velocity[i] = number(i) * speed_step;
        for (std::size_t i = 0; i < 4; ++i) r.contact[i] = f.data[6] >> i & 1;
        break;
      case 3:
        for (std::size_t i = 0; i < 3; ++i) r.specific_force[i] = number(i) * force_step;
        r.status = f.data[6];
        break;
      case 4:
        for (std::size_t i = 0; i < 4; ++i) r.foot_load[i] = number(i) * load_step;
        break;
      default:
        for (std::size_t i = 0; i < 4; ++i) r.abduction[i] = number(i) * angle_step;
    }
    ++r.frames;
    return true;
  }

  // The board's side.
  static std::array<can_frame, 5> frames(const board_reading& r, std::uint8_t counter) noexcept {
    std::array<can_frame, 5> all;
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = {.id = standard(Base + 1 + i), .length = 8};
    for (std::size_t i = 0; i < 4; ++i) {
      put(all[0], i, r.orientation[i], part);
      put(all[3], i, r.foot_load[i], load_step);
      put(all[4], i, r.abduction[i], angle_step);
      all[1].data[6] = static_cast<std::uint8_t>(all[1].data[6] | r.contact[i] << i);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      put(all[1], i, r.angular_velocity[i], speed_step);
      put(all[2], i, r.specific_force[i], force_step);
    }
    all[2].data[6] = r.status;
    all[1].data[7] = all[2].data[7] = counter;
    return all;
  }

  // Targets that aren't finite leave the joint as it is.
  static can_frame abduct(const std::array<double, 4>& targets) noexcept {
    can_frame f{.id = standard(Base), .length = 8};
    for (std::size_t i = 0; i < 4; ++i) {
      if (detail::is_finite(targets[i])) put(f, i, targets[i], angle_step);
      else detail::put<std::uint16_t>(f.data, 2 * i, 0x8000);
    }
    return f;
  }
  // Takes what is told of; false: no such frame.
  static bool abducted(const can_frame& f, std::array<double, 4>& targets) noexcept {
    if (f.id != standard(Base) || f.fd || f.remote || f.length != 8) return false;
    for (std::size_t i = 0; i < 4; ++i)
      if (const auto n = detail::got<std::uint16_t>(f.payload(), 2 * i); n != 0x8000)
        targets[i] = static_cast<std::int16_t>(n) * angle_step;
    return true;
  }

private:
  static void put(can_frame& f, std::size_t at, double number, double step) {
    bool cut = false;
    const double steps = detail::is_finite(number) ? number / step : 0;
    detail::put(f.data, 2 * at, static_cast<std::uint16_t>(detail::nearest_integer(steps, 16, cut)));
  }
};

}  // namespace cca::hardware
