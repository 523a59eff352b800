// An ODrive axis that speaks CAN Simple, with firmware 0.5 (ODrive 3) or 0.6 (Pro, S1): the same ids, but
// some frames mean something else.
//
//   using hip = cca::hardware::odrive<3, cca::hardware::odrive_mode::torque>;   // node 3, firmware 0.6
//
// Ids are node << 5 | command; a node above 63 has 29-bit ids. Node 63 of 0.6 is refused: `not addressed`.
// Numbers are those of its encoder's shaft: turns there, rad here.
//   set_point   by mode. position: a float in turns; velocity and torque are added as thousandths in 16 bits,
//               so up to 205.9 rad/s and 32.767 N m. velocity: a float, and a torque that is added. torque: a
//               float. The gains are settings of the drive: stiffness and damping are not used. NaN and
//               infinity refuse the command
//   decode      heartbeat, encoder estimates, errors; of 0.6 also temperatures and torques. NaN means that
//               the drive does not have the number. A position does not wrap; it gets coarser, to steps of
//               1/16 turn at a million turns. `activity` is `enabled` in closed loop only
//   enabling    clears errors, sets the mode, waits for a measured position, commands that one, and asks for
//               closed loop
//   watchdog    a setting (axis.config.enable_watchdog, watchdog_timeout), off by default. Set points and
//               state requests feed it (0.5: each frame to its node). When it runs out: idle, and an error
// It does not ask by remote frames, since many adapters don't pass them: let the drive send cyclically
// (config.can.*_rate_ms). The last two arguments are the periods (ns) of its estimates and of its torques; 0:
// it sends no torques.
//
// Source: 0.6: odriverobotics/ros_odrive, odrive_base/include/can_simple_messages.hpp (made from the maker's
// own database); the error and state numbers of odriverobotics/ODriveArduino, src/ODriveEnums.h, and of
// odrive-cansimple 0.6.10; what feeds the watchdog: odriverobotics/ODriveResources, examples/can_simple.py.
// 0.5: odriverobotics/ODrive, docs/can-protocol.rst, and the errors of odrive-cansimple 0.5.6.
// Not verified: whether 0.6 takes frames longer than its own (we send none). docs/drives.md.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/drive.hpp>
#include <cca/hardware/drives/odrive_errors.hpp>
#include <cca/hardware/drives/wire_number.hpp>
#include <cca/space/quantity.hpp>

namespace cca::hardware {

enum class odrive_mode : std::uint8_t { torque = 1, velocity = 2, position = 3 };
enum class odrive_command : std::uint8_t {
  heartbeat = 0x01,
  estop = 0x02,
  error = 0x03,
  set_axis_state = 0x07,
  estimates = 0x09,
  set_controller_mode = 0x0B,
  set_input_pos = 0x0C,
  set_input_vel = 0x0D,
  set_input_torque = 0x0E,
  temperature = 0x15,
  clear_errors = 0x18,
  torques = 0x1C,
};

namespace detail {
template <std::uint32_t Node>
struct no_odrive_node {
  static constexpr void tell(auto& m) {
    if (Node > 0xFFFFFF)
      m << "drive.bad_number: the node of an ODrive is " << std::int64_t{Node}
        << ", and it is at most 0xFFFFFF";
    else
      m << "drive.bad_number: node 63 (0x3F) of an ODrive with firmware 0.6 means `not addressed`: it would "
           "hear nothing; use another";
  }
};
template <std::uint32_t Node>
struct no_odrive_torques {
  static constexpr void tell(auto& m) {
    m << "drive.bad_number: the ODrive of node " << std::int64_t{Node}
      << " has firmware 0.5, which sends no torques: leave out their period";
  }
};
}  // namespace detail

template <std::uint32_t Node,
          odrive_mode Mode,
          odrive_firmware Firmware = odrive_firmware::v0_6,
          std::int64_t EstimatesPeriod = 10'000'000,
          std::int64_t TorquesPeriod = 0>
struct odrive : detail::odrive_torques<TorquesPeriod> {
  static_assert(cca::detail::holds_or_tells<(Node <= 0xFFFFFF && detail::is_odrive_node(Node, Firmware)),
                                            detail::no_odrive_node<Node>>::value);
  static_assert(cca::detail::holds_or_tells<(TorquesPeriod == 0 || Firmware == odrive_firmware::v0_6),
                                            detail::no_odrive_torques<Node>>::value);
  static constexpr std::uint32_t node = Node;
  static constexpr odrive_firmware firmware = Firmware;
  static constexpr std::int64_t report_period = EstimatesPeriod;  // ns, between two encoder estimates
  static constexpr bool is_0_6 = Firmware == odrive_firmware::v0_6,
                        by_position = Mode == odrive_mode::position,
                        by_velocity = Mode == odrive_mode::velocity;
  static constexpr double thousandths = 32.767;  // the most that 16 bits of thousandths say

  static constexpr can_id id(odrive_command c) {
    return {Node << 5 | static_cast<std::uint32_t>(c), Node > 63};
  }

  static constexpr std::string_view name = is_0_6 ? "ODrive 0.6" : "ODrive 0.5";
  static constexpr auto limits =
      cca::limits{cca::velocity{-thousandths * detail::radians_in_turn, thousandths* detail::radians_in_turn},
                  cca::torque{-thousandths, thousandths}};
  static constexpr std::uint8_t uses = of_torque | (by_position   ? of_position | of_velocity
                                                    : by_velocity ? of_velocity
                                                                  : no_quantity);
  static constexpr odrive_command input = by_position   ? odrive_command::set_input_pos
                                          : by_velocity ? odrive_command::set_input_vel
                                                        : odrive_command::set_input_torque;
  static constexpr std::array<can_filter, 7> requests{{{id(odrive_command::estop)},
                                                       {id(odrive_command::set_axis_state)},
                                                       {id(odrive_command::set_controller_mode)},
                                                       {id(odrive_command::set_input_pos)},
                                                       {id(odrive_command::set_input_vel)},
                                                       {id(odrive_command::set_input_torque)},
                                                       {id(odrive_command::clear_errors)}}};
  static constexpr std::array<can_filter, 5> replies{{{id(odrive_command::heartbeat)},
                                                      {id(odrive_command::error)},
                                                      {id(odrive_command::estimates)},
                                                      {id(odrive_command::temperature)},
                                                      {id(odrive_command::torques)}}};
  // All its other commands: reboot, settings and so on.
  static constexpr std::array<can_filter, 1> occupies{{{{Node << 5, Node > 63}, 0x1FFFFFE0}}};
  static constexpr auto traffic = [] {
    constexpr frame_shape shape{.length = 8, .extended = Node > 63};
    std::array<frame_traffic, 3 + (TorquesPeriod > 0)> all{{{.shape = shape},
                                                            {.shape = shape, .period = EstimatesPeriod},
                                                            {.shape = shape, .period = 100'000'000}}};
    if constexpr (TorquesPeriod > 0) all[3] = {.shape = shape, .period = TorquesPeriod};
    return all;
  }();
  static constexpr drive_watchdog watchdog{0, "goes idle, with an error; off unless enable_watchdog is set"};

  static constexpr set_point_frames set_point(const drive_command& c) noexcept {
    set_point_frames s;
    s.finite = detail::is_finite(c.torque) && (!(uses & of_velocity) || detail::is_finite(c.velocity)) &&
               (!(uses & of_position) || detail::is_finite(c.position));
    if (!s.finite) return s;
    const auto as_float = [&s](double number, drive_quantity of) {
      bool beyond = false;
      const float f = detail::to_float(number, beyond);
      if (beyond) s.cut = static_cast<std::uint8_t>(s.cut | of);
      return f;
    };
    const auto as_thousandths = [&s](double number, drive_quantity of) {
      bool beyond = false;
      const auto n = detail::nearest_integer(number * 1000, 16, beyond);
      if (beyond) s.cut = static_cast<std::uint8_t>(s.cut | of);
      return static_cast<std::uint16_t>(n);
    };
    can_frame f = empty(input, 8);
    if constexpr (by_position) {
      detail::put_float(f.data, 0, as_float(c.position / detail::radians_in_turn, of_position));
      detail::put(f.data, 4, as_thousandths(c.velocity / detail::radians_in_turn, of_velocity));
      detail::put(f.data, 6, as_thousandths(c.torque, of_torque));
    } else if constexpr (by_velocity) {
      detail::put_float(f.data, 0, as_float(c.velocity / detail::radians_in_turn, of_velocity));
      detail::put_float(f.data, 4, as_float(c.torque, of_torque));
    } else {
      f.length = 4;
      detail::put_float(f.data, 0, as_float(c.torque, of_torque));
    }
    s.frames.add(f);
    return s;
  }

  static constexpr bool decode(const can_frame& f, drive_report& r) noexcept {
    if (f.fd || f.remote || f.length != 8) return false;
    const auto p = f.payload();
    const auto word = [&p](std::size_t at) { return detail::got<std::uint32_t>(p, at); };
    const auto number = [&p](std::size_t at) {
      return detail::number_or_nan(static_cast<double>(detail::got_float(p, at)));
    };
    if (f.id == id(odrive_command::heartbeat)) {
      r.state = p[4];
      r.code = word(0);
      r.fault = is_0_6 ? detail::fault_in(r.code, detail::odrive_0_6_faults)
                       : detail::fault_in(r.code, detail::odrive_0_5_faults);
      if (!is_0_6 && r.fault == drive_fault::none)
        r.fault = p[6] & 1            ? drive_fault::position_sensor
                  : (p[5] | p[7]) & 1 ? drive_fault::other
                                      : drive_fault::none;
      r.activity = r.fault != drive_fault::none ? drive_activity::faulted
                   : r.state == 8               ? drive_activity::enabled
                   : r.state <= 1               ? drive_activity::disabled
                                                : drive_activity::enabling;
      r.told = of_activity;
      ++r.states;
    } else if (f.id == id(odrive_command::estimates)) {
      r.position = number(0) * detail::radians_in_turn;
      r.velocity = number(4) * detail::radians_in_turn;
      r.told = of_position | of_velocity;
    } else if (f.id == id(odrive_command::error)) {
      // 0.5: 64 bits of the motor's errors. 0.6: the active errors, then why it was disarmed.
      const std::uint32_t active = is_0_6 ? word(0) : word(0) | word(4);
      r.code = active != 0 ? active : word(4);
      if (active != 0) {
        r.fault = is_0_6 ? detail::fault_in(active, detail::odrive_0_6_faults) : drive_fault::other;
        r.activity = drive_activity::faulted;
      }
      r.told = of_activity;
      r.states += active != 0;  // without an error it says nothing about the drive's state
    } else if (is_0_6 && f.id == id(odrive_command::temperature)) {
      r.temperature = number(0);
      r.told = of_temperature;
    } else if (is_0_6 && f.id == id(odrive_command::torques)) {
      r.torque = number(4);
      r.told = of_torque;
    } else {
      return false;
    }
    ++r.frames;
    return true;
  }

  static constexpr can_frame axis_state(std::uint32_t state) noexcept {
    can_frame f = empty(odrive_command::set_axis_state, 8);
    f.length = is_0_6 ? 8 : 4;
    detail::put(f.data, 0, state);
    return f;
  }
  static constexpr can_frame estop() noexcept { return empty(odrive_command::estop, 0); }
  static constexpr can_frame clear_errors() noexcept {
    return empty(odrive_command::clear_errors, is_0_6 ? 1 : 0);
  }
  static constexpr can_frame controller_mode() noexcept {
    can_frame f = empty(odrive_command::set_controller_mode, 8);
    detail::put(f.data, 0, static_cast<std::uint32_t>(Mode));
    detail::put(f.data, 4, std::uint32_t{1});  // input mode: passed through, without ramp or filter
    return f;
  }
  static constexpr drive_frames disable() noexcept { return {axis_state(1)}; }

  class enabling {
  public:
    constexpr enable_step next(const drive_report& r) noexcept {
      if (step == 0) {
        ++step;
        states = r.states;
        return {{clear_errors(), controller_mode()}, enable_progress::going};
      }
      if (r.activity == drive_activity::faulted && r.states >= states + 2)
        return {disable(), enable_progress::failed};
      if (!detail::is_finite(r.position)) return {};
      enable_step s{set_point({.position = r.position}).frames, enable_progress::going};
      if (r.activity == drive_activity::enabled && r.states > states) s.progress = enable_progress::done;
      else if (step++ == 1) s.frames.add(axis_state(8));
      return s;
    }

  private:
    int step = 0;
    std::uint64_t states = 0;
  };

  // The drive's side, for virtual drives.
  static constexpr bool hear(const can_frame& f, drive_command& c) noexcept {
    if (f.id != id(input) || f.fd || f.remote || f.length != (Mode == odrive_mode::torque ? 4 : 8))
      return false;
    const auto p = f.payload();
    const auto thousandth = [&p](std::size_t at) {
      return static_cast<std::int16_t>(detail::got<std::uint16_t>(p, at)) / 1000.0;
    };
    c = {};
    if constexpr (by_position) {
      c.position = static_cast<double>(detail::got_float(p, 0)) * detail::radians_in_turn;
      c.velocity = thousandth(4) * detail::radians_in_turn;
      c.torque = thousandth(6);
    } else if constexpr (by_velocity) {
      c.velocity = static_cast<double>(detail::got_float(p, 0)) * detail::radians_in_turn;
      c.torque = static_cast<double>(detail::got_float(p, 4));
    } else {
      c.torque = static_cast<double>(detail::got_float(p, 0));
    }
    return true;
  }
  static constexpr can_frame heartbeat(std::uint8_t state, std::uint32_t error = 0) noexcept {
    can_frame f = empty(odrive_command::heartbeat, 8);
    detail::put(f.data, 0, error);
    f.data[4] = state;
    return f;
  }
  static constexpr can_frame estimates(double position, double velocity) noexcept {
    can_frame f = empty(odrive_command::estimates, 8);
    bool cut = false;
    detail::put_float(f.data, 0, detail::to_float(position / detail::radians_in_turn, cut));
    detail::put_float(f.data, 4, detail::to_float(velocity / detail::radians_in_turn, cut));
    return f;
  }
  static constexpr can_frame torques(double torque) noexcept {
    can_frame f = empty(odrive_command::torques, 8);
    bool cut = false;
    detail::put_float(f.data, 4, detail::to_float(torque, cut));
    return f;
  }

private:
  static constexpr can_frame empty(odrive_command c, std::uint8_t length) {
    return {.id = id(c), .length = length};
  }
};

}  // namespace cca::hardware
