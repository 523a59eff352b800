// The frames of a moteus: what a controller sends, and what a request says to the drive.
//
// Each request also asks for mode, position, velocity, torque, temperature and fault. Source:
// moteus_registers.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <cca/hardware/drives/drive.hpp>
#include <cca/hardware/drives/moteus_registers.hpp>

namespace cca::hardware {

// What a request says: `mode` is -1 where it has none, and numbers are NaN where it says NaN.
struct moteus_request {
  int mode = -1;
  drive_command command{};  // stiffness and damping as parts of kp and kd
  double most_torque = std::numeric_limits<double>::quiet_NaN(), timeout = 0;
  double stop_position = std::numeric_limits<double>::quiet_NaN();  // rad; NaN: none
};

namespace detail {

constexpr can_frame padded(can_frame f, std::size_t used) {
  f.length = fd_length(used);
  for (; used < f.length; ++used) f.data[used] = 0x50;  // a subframe without contents
  return f;
}

constexpr void ask_for_report(register_writer& w) {
  w.head(moteus_kind::read, moteus_value::int32, moteus_register::mode, 4);
  w.head(moteus_kind::read, moteus_value::int8, moteus_register::temperature, 2);
}

constexpr can_frame moteus_mode_frame(can_id to, std::uint8_t mode) {
  can_frame f = fd(to, {});
  register_writer w(f.data);
  w.head(moteus_kind::write, moteus_value::int8, moteus_register::mode, 1);
  w.byte(mode);
  ask_for_report(w);
  return padded(f, w.size());
}

// Turns, turns/s, N m, parts of kp and kd, N m at most, turns where it stops, s: in the order of their
// registers. The mode stands first.
constexpr can_frame moteus_position_frame(can_id to, const std::array<double, 8>& numbers) {
  can_frame f = fd(to, {});
  register_writer w(f.data);
  w.head(moteus_kind::write, moteus_value::int8, moteus_register::mode, 1);
  w.byte(10);
  w.head(moteus_kind::write, moteus_value::float32, moteus_register::command_position, 8);
  for (const double number : numbers) w.number(static_cast<float>(number));
  ask_for_report(w);
  return padded(f, w.size());
}

constexpr bool read_moteus_request(const can_frame& f, moteus_request& into) {
  moteus_request now;
  now.command.stiffness = now.command.damping = 1;
  const auto note = [&now](moteus_kind kind, std::uint32_t which, double value) {
    if (kind != moteus_kind::write) return;
    switch (static_cast<moteus_register>(which)) {
      case moteus_register::mode:
        now.mode = value >= 0 && value <= 15 ? static_cast<int>(value) : -1;
        break;
      case moteus_register::command_position:
        now.command.position = value * radians_in_turn;
        break;
      case moteus_register::command_velocity:
        now.command.velocity = value * radians_in_turn;
        break;
      case moteus_register::command_torque:
        now.command.torque = value;
        break;
      case moteus_register::stiffness_scale:
        now.command.stiffness = value;
        break;
      case moteus_register::damping_scale:
        now.command.damping = value;
        break;
      case moteus_register::most_torque:
        now.most_torque = value;
        break;
      case moteus_register::stop_position:
        now.stop_position = value * radians_in_turn;
        break;
      case moteus_register::command_timeout:
        now.timeout = value;
        break;
      default:
        break;
    }
  };
  if (!read_registers(f.payload(), note)) return false;
  into = now;
  return true;
}

}  // namespace detail
}  // namespace cca::hardware
