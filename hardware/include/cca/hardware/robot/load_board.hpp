// A board with the force sensors of a robot on its bus: our own protocol, classic frames, little-endian. Two
// frames for each sensor, in each beat.
//
//   id              bytes
//   base + 2 k      0-5 force of sensor k, x y z, along its axes: i16, 10 mN;        6 status, 0: fine; 7
//   counter base + 2 k + 1  0-5 torque about its origin, x y z, along its axes: i16, 1 mN m; 7 counter
//
//   using flange_board = cca::hardware::load_board<0x40, 1, 3>;   // one sensor, on bus 3
//
// Force and torque are taken together, once both have come with the same counter: so a load never mixes two
// measurements, and a lost frame makes it old. `frames` counts the loads of the sensor that has sent the
// fewest, so a board of which one sensor is silent is silent. A number out of range is clamped. Cost: some
// dozen instructions a frame. docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include <cca/hardware/drives/drive.hpp>
#include <cca/hardware/drives/wire_number.hpp>

namespace cca::hardware {

template <std::size_t Sensors>
struct load_reading {
  // Torque (N m), then force (N) of each sensor, as in wrench<At, In>. Not a number: not sent yet.
  std::array<std::array<double, 6>, Sensors> loads{};
  std::uint8_t status = 0;
  std::uint64_t frames = 0;

  // Forces that wait for their torques.
  struct half {
    std::array<double, 3> force{};
    std::uint8_t counter = 0;
    bool waits = false;
  };
  std::array<half, Sensors> halves{};
  std::array<std::uint64_t, Sensors> complete{};

  static constexpr load_reading untold() {
    load_reading r;
    for (auto& load : r.loads) load.fill(std::numeric_limits<double>::quiet_NaN());
    return r;
  }
};

template <std::uint32_t Base, std::size_t Sensors, std::size_t Bus = 0, bit_rates Rates = bit_rates{}>
struct load_board {
  static_assert(
      Sensors >= 1 && Base + 2 * Sensors - 1 <= 0x7FF,
      "cca::hardware::load_board: at least one sensor; its ids are base to base + 2 sensors - 1, of "
      "11 bits");
  using reading = load_reading<Sensors>;
  static constexpr std::size_t sensors = Sensors, bus = Bus;
  static constexpr std::string_view name = "load board";
  static constexpr bit_rates rates = Rates;
  static constexpr std::array<frame_traffic, 1> traffic{{{.shape = {.length = 8}, .a_cycle = 2 * Sensors}}};
  static constexpr std::array<can_filter, 0> requests{};
  static constexpr auto replies = [] {
    std::array<can_filter, 2 * Sensors> all;
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = {standard(Base + i)};
    return all;
  }();
  static constexpr double force_step = 1e-2, torque_step = 1e-3;

  static constexpr bool decode(const can_frame& f, reading& r) noexcept {
    if (f.id.extended || f.fd || f.remote || f.length != 8 || f.id.number < Base ||
        f.id.number >= Base + 2 * Sensors)
      return false;
    const std::size_t k = (f.id.number - Base) / 2;
    const auto number = [&](std::size_t i) {
      return static_cast<double>(static_cast<std::int16_t>(detail::got<std::uint16_t>(f.payload(), 2 * i)));
    };
    auto& half = r.halves[k];
    if ((f.id.number - Base) % 2 == 0) {
      for (std::size_t i = 0; i < 3; ++i) half.force[i] = number(i) * force_step;
      half.counter = f.data[7], half.waits = true;
      r.status = f.data[6];
    } else if (half.waits && half.counter == f.data[7]) {
      half.waits = false;
      for (std::size_t i = 0; i < 3; ++i)
        r.loads[k][i] = number(i) * torque_step, r.loads[k][3 + i] = half.force[i];
      ++r.complete[k];
      r.frames = *std::ranges::min_element(r.complete);
    }
    return true;
  }

  // The board's side: its frames, in the order of their ids. A number that isn't finite is sent as 0.
  static constexpr std::array<can_frame, 2 * Sensors> frames(const reading& r,
                                                             std::uint8_t counter) noexcept {
    std::array<can_frame, 2 * Sensors> all;
    for (std::size_t k = 0; k < Sensors; ++k)
      for (std::size_t part = 0; part < 2; ++part) {
        can_frame& f = all[2 * k + part];
        f = {.id = standard(static_cast<std::uint32_t>(Base + 2 * k + part)), .length = 8};
        for (std::size_t i = 0; i < 3; ++i) {
          const double x = r.loads[k][part == 0 ? 3 + i : i] / (part == 0 ? force_step : torque_step);
          bool cut = false;
          detail::put(
              f.data, 2 * i,
              static_cast<std::uint16_t>(detail::nearest_integer(detail::is_finite(x) ? x : 0, 16, cut)));
        }
        if (part == 0) f.data[6] = r.status;
        f.data[7] = counter;
      }
    return all;
  }
};

}  // namespace cca::hardware
