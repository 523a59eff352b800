// A board with the force sensors and inertial units of a robot on its bus: our own protocol, classic frames,
// little-endian. Two frames for each force sensor and three for each inertial unit, in each beat.
//
//   id             bytes
//   base + 2 k     force of sensor k, x y z, along its axes: i16, 10 mN; status; counter
//   base + 2 k + 1   torque about its origin, x y z, along its axes: i16, 1 mN m; -; counter
//   units + 3 k    orientation of unit k in the world: x y z w, i16, 1/32767 each
//   units + 3 k + 1  angular velocity, x y z, along its axes: i16, 1 mrad/s; -; counter
//   units + 3 k + 2  specific force, x y z, along its axes: i16, 5 mm/s^2; status; counter
//
// where units = base + 2 * Loads. Bytes 0-5 are the three numbers, 6 the status (0: fine), 7 the counter.
//
//   using board = cca::hardware::robot_board<0x40, 1, 1, 3>;   // one load and one inertial unit, on bus 3
//
// A bus of 1 Mbit/s carries six such frames in each beat of a millisecond: bus.overloaded.
//
// The two frames of a load, and the last two of a unit, are taken together, once both have come with the same
// counter: so no reading mixes two measurements, and a lost frame makes it old. An orientation that is not of
// unit length (within 2 %) is refused. `frames` counts the readings of the sensor that has sent the fewest,
// so a board of which one sensor is silent is silent. A number out of range is clamped. Cost: some dozen
// instructions a frame. docs/robots.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include <cca/hardware/robot/boards/ids_of_board.hpp>
#include <cca/hardware/drives/board_numbers.hpp>
#include <cca/hardware/drives/drive.hpp>
#include <cca/robots/inertial.hpp>

namespace cca::hardware {

template <std::size_t Loads, std::size_t Units>
struct robot_board_reading {
  // Torque (N m), then force (N) of each sensor, as in wrench<At, In>. Not a number: not sent yet.
  std::array<std::array<double, 6>, Loads> loads{};
  std::array<robots::inertial_reading, Units> inertial{};
  std::uint8_t status = 0;
  std::uint64_t frames = 0;

  // Three numbers that wait for the other half of their measurement.
  struct half {
    std::array<double, 3> first{};
    std::uint8_t counter = 0;
    bool waits = false;
  };
  std::array<half, Loads + Units> halves{};
  std::array<std::uint64_t, Loads + Units> complete{};

  static constexpr robot_board_reading untold() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    robot_board_reading r;
    for (auto& load : r.loads) load.fill(none);
    for (auto& unit : r.inertial)
      unit.orientation.fill(none), unit.angular_velocity.fill(none), unit.specific_force.fill(none);
    return r;
  }
};

namespace detail {

// What the boards of a robot have in common, whatever their frames.
template <std::uint32_t Base,
          std::size_t FrameCount,
          std::size_t Loads,
          std::size_t Units,
          std::size_t Bus,
          bit_rates Rates>
struct board_of_robot {
  static constexpr std::size_t frame_count = FrameCount;
  using reading = robot_board_reading<Loads, Units>;
  static constexpr std::size_t sensors = Loads, inertial_units = Units, bus = Bus;
  static constexpr std::string_view name = "robot board";
  static constexpr bit_rates rates = Rates;
  static constexpr std::array<can_filter, 0> requests{};
  static constexpr auto replies = [] {
    std::array<can_filter, frame_count> all;
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = {standard(Base + i)};
    return all;
  }();
  static constexpr double force_step = 1e-2, torque_step = 1e-3, speed_step = 1e-3, acceleration_step = 5e-3;

protected:
  static constexpr bool has_id(const can_frame& f) {
    return !f.id.extended && f.id.number >= Base && f.id.number < Base + frame_count;
  }
  static constexpr void count(reading& r, std::size_t sensor) {
    ++r.complete[sensor];
    r.frames = *std::ranges::min_element(r.complete);
  }
};

}  // namespace detail

template <std::uint32_t Base,
          std::size_t Loads,
          std::size_t Units,
          std::size_t Bus = 0,
          bit_rates Rates = bit_rates{}>
struct robot_board : detail::board_of_robot<Base, 2 * Loads + 3 * Units, Loads, Units, Bus, Rates> {
private:
  using base = detail::board_of_robot<Base, 2 * Loads + 3 * Units, Loads, Units, Bus, Rates>;

public:
  using base::frame_count, base::force_step, base::torque_step, base::speed_step, base::acceleration_step;
  using typename base::reading;
  static_assert(cca::detail::holds_or_tells<(frame_count >= 1 && Base + frame_count - 1 <= 0x7FF),
                                            detail::ids_of_board<Base, frame_count>>::value);
  static constexpr std::array<frame_traffic, 1> traffic{
      {{.shape = {.length = 8}, .a_cycle = static_cast<int>(frame_count)}}};

  static constexpr bool decode(const can_frame& f, reading& r) noexcept {
    if (!base::has_id(f) || f.fd || f.remote || f.length != 8) return false;
    const std::size_t at = f.id.number - Base;
    if (at < first_of_units) {
      if (at % 2 == 0) return keep(f, force_step, r.halves[at / 2]), take_status(f, r);
      const auto& half = r.halves[at / 2];
      auto& load = r.loads[at / 2];
      if (completes(f, r, at / 2))
        for (std::size_t i = 0; i < 3; ++i)
          load[i] = detail::board_number(f, i, torque_step), load[3 + i] = half.first[i];
      return true;
    }
    const std::size_t unit = (at - first_of_units) / 3;
    robots::inertial_reading& now = r.inertial[unit];
    switch ((at - first_of_units) % 3) {
      case 0:
        return detail::take_board_orientation(f, now.orientation);
      case 1:
        keep(f, speed_step, r.halves[Loads + unit]);
        return true;
      default:
        if (completes(f, r, Loads + unit)) {
          now.angular_velocity = r.halves[Loads + unit].first;
          for (std::size_t i = 0; i < 3; ++i)
            now.specific_force[i] = detail::board_number(f, i, acceleration_step);
        }
        return take_status(f, r);
    }
  }

  // The board's side: its frames, in the order of their ids. A number that isn't finite is sent as 0.
  static constexpr std::array<can_frame, frame_count> frames(const reading& r,
                                                             std::uint8_t counter) noexcept {
    std::array<can_frame, frame_count> all;
    for (std::size_t at = 0; at < frame_count; ++at)
      all[at] = {.id = standard(static_cast<std::uint32_t>(Base + at)), .length = 8};
    const auto three = [&](std::size_t at, const double* numbers, double step) {
      can_frame& f = all[at];
      for (std::size_t i = 0; i < 3; ++i) detail::put_board_number(f, i, numbers[i], step);
      f.data[7] = counter;
    };
    for (std::size_t k = 0; k < Loads; ++k) {
      three(2 * k, r.loads[k].data() + 3, force_step);
      three(2 * k + 1, r.loads[k].data(), torque_step);
      all[2 * k].data[6] = r.status;
    }
    for (std::size_t k = 0; k < Units; ++k) {
      const std::size_t at = first_of_units + 3 * k;
      for (std::size_t i = 0; i < 4; ++i)
        detail::put_board_number(all[at], i, r.inertial[k].orientation[i], detail::orientation_step);
      three(at + 1, r.inertial[k].angular_velocity.data(), speed_step);
      three(at + 2, r.inertial[k].specific_force.data(), acceleration_step);
      all[at + 2].data[6] = r.status;
    }
    return all;
  }

private:
  static constexpr std::size_t first_of_units = 2 * Loads;

  static constexpr void keep(const can_frame& f, double step, typename reading::half& half) {
    for (std::size_t i = 0; i < 3; ++i) half.first[i] = detail::board_number(f, i, step);
    half.counter = f.data[7], half.waits = true;
  }
  // Whether this frame is the other half of the measurement that waits; then it is one more.
  static constexpr bool completes(const can_frame& f, reading& r, std::size_t sensor) {
    auto& half = r.halves[sensor];
    if (!half.waits || half.counter != f.data[7]) return false;
    half.waits = false;
    base::count(r, sensor);
    return true;
  }
  static constexpr bool take_status(const can_frame& f, reading& r) {
    r.status = f.data[6];
    return true;
  }
};

}  // namespace cca::hardware
