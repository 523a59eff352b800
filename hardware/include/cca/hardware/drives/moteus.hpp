// A moteus, over CAN FD at 1 and 5 Mbit/s: one frame commands and asks, one answers.
//
//   struct hip_motor {
//     static constexpr std::string_view name = "n1";
//     static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.05;
//   };
//   using hip = cca::hardware::moteus<hip_motor, 3>;  // servo 3
//
// The motor's type states the drive's settings: servo.pid_position.kp and kd in N m/rad and N m s/rad (the
// drive has them for a turn: divide by 2 pi), the torque that it may use at most in N m, and how long a
// command holds in s. Numbers are those of its output shaft: turns there, rad here. The command has floats,
// the answer 32-bit integers.
//   set_point   stiffness and damping are parts of kp and kd, from 0 to 1. Damping can't be a larger part
//               than stiffness, since the firmware limits it so (`most_damping`). Without stiffness it does
//               not damp, use brake(); torque alone is then a torque mode. NaN is refused: in this protocol
//               it would mean `stay where you are`, for which there is stay(). A commanded velocity moves the
//               target on for 5 ms at most (`run_on` of the motor's type, in s; infinity: until the timeout),
//               so that nothing runs away when the controller dies: that is the register of the stop
//               position. A drive with servo.default_velocity_limit or default_accel_limit answers to it with
//               fault 45: leave those unset, or state infinity
//   decode      a number that the drive does not have is NaN. A position stays at 21474.83647 turns, the last
//               that 32 bits can say. Mode 11, no command in time, is a fault until disable(). Fault numbers
//               from 96 on are limits that the drive keeps, no faults: they are in `code` only
//   enabling    stop, which clears faults; then stay() until the drive reports that it holds
//   watchdog    `timeout` in each command. After that it does servo.timeout_mode (stop, hold, zero velocity
//               or brake) until disable()
// `Prefix` is the drive's setting can.prefix, the upper 13 bits of its ids.
// Source: moteus_registers.hpp; docs/reference/configuration.md, can.prefix. docs/drives.md.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/drive.hpp>
#include <cca/hardware/drives/moteus_frames.hpp>
#include <cca/space/quantity.hpp>

namespace cca::hardware {

template <class Type> concept MoteusMotor = requires {
  { Type::name } -> std::convertible_to<std::string_view>;
  requires Type::stiffness > 0 && Type::damping > 0 && Type::torque > 0 && Type::timeout > 0;
};

namespace detail {
template <class Motor, int Servo, int Source>
struct no_moteus_number {
  static constexpr void tell(auto& m) {
    m << "drive.bad_number: the number of " << Motor::name << " is " << Servo << ", and we send from "
      << Source
      << ": a moteus has a number from 1 to 127, and not the one that we send from, which is at most 127";
  }
};
template <class Motor, std::uint16_t Prefix>
struct no_prefix {
  static constexpr void tell(auto& m) {
    m << "drive.bad_number: the prefix of " << Motor::name << " is " << static_cast<std::int64_t>(Prefix)
      << ", and `can.prefix` of a moteus has 13 bits: write a number from 0 to 8191";
  }
};
}  // namespace detail

template <MoteusMotor Motor, std::uint8_t Servo, std::uint8_t Source = 0, std::uint16_t Prefix = 0>
struct moteus {
  static_assert(cca::detail::holds_or_tells<(Prefix <= 0x1FFF), detail::no_prefix<Motor, Prefix>>::value);
  static_assert(cca::detail::holds_or_tells<(Servo >= 1 && Servo <= 127 && Source <= 127 && Servo != Source),
                                            detail::no_moteus_number<Motor, Servo, Source>>::value);
  using motor = Motor;
  static constexpr double run_on = [] {
    if constexpr (requires { Motor::run_on; }) return static_cast<double>(Motor::run_on);
    else return 0.005;
  }();

  static constexpr std::string_view name = Motor::name;
  static constexpr auto limits =
      cca::limits{cca::torque{-Motor::torque, Motor::torque}, cca::stiffness{0, Motor::stiffness},
                  cca::damping{0, Motor::damping}};
  static constexpr std::uint8_t uses = of_position | of_velocity | of_torque | of_stiffness | of_damping;
  static constexpr can_id request_id = extended(Prefix << 16 | 0x8000u | Source << 8 | Servo);
  static constexpr std::uint32_t reply_number = std::uint32_t{Prefix} << 16 | Servo << 8 | Source;
  static constexpr std::array<can_filter, 1> requests{{{request_id}}};
  static constexpr std::array<can_filter, 2> replies{
      {{extended(reply_number)}, {reply_number <= 0x7FF ? standard(reply_number) : extended(reply_number)}}};
  // All frames to its number, from any source; it takes 11-bit and 29-bit ids.
  static constexpr std::array<can_filter, 2> occupies{
      {{extended(Prefix << 16 | Servo), 0x1FFF00FF},
       {Prefix == 0 ? standard(Servo) : extended(Prefix << 16 | Servo), 0x1FFF00FF}}};
  static constexpr std::array<frame_traffic, 2> traffic{
      {{.shape = {.length = 48, .extended = true, .fd = true, .fast = true}},
       {.shape = {.length = 24, .extended = reply_number > 0x7FF, .fd = true, .fast = true}}}};
  static constexpr drive_watchdog watchdog{
      static_cast<std::int64_t>(Motor::timeout * 1e9),
      "timeout mode: stops, holds, damps or brakes by servo.timeout_mode, until stopped"};

  // `most_torque`: what the drive may use for this command, in N m.
  static constexpr set_point_frames set_point(const drive_command& c,
                                              double most_torque = Motor::torque) noexcept {
    set_point_frames s;
    for (const double number : {c.position, c.velocity, c.torque, c.stiffness, c.damping, most_torque})
      s.finite &= detail::is_finite(number);
    if (!s.finite) return s;
    const auto within = [&s](double number, double lower, double upper, drive_quantity of) {
      if (number < lower || number > upper) s.cut = static_cast<std::uint8_t>(s.cut | of);
      return std::clamp(number, lower, upper);
    };
    constexpr double most = std::numeric_limits<float>::max();
    const double stiff = within(c.stiffness / Motor::stiffness, 0, 1, of_stiffness);
    const double turns = within(c.position / detail::radians_in_turn, -most, most, of_position),
                 speed = within(c.velocity / detail::radians_in_turn, -most, most, of_velocity);
    const double stop =
        speed == 0 || run_on > 1e6 ? no_stop : std::clamp(turns + speed * run_on, -most, most);
    s.frames.add(position_mode(turns, speed, within(c.torque, -most_torque, most_torque, of_torque), stiff,
                               within(c.damping / Motor::damping, 0, stiff, of_damping), most_torque, stop));
    return s;
  }

  static constexpr bool decode(const can_frame& f, drive_report& r) noexcept {
    if (f.remote || !f.valid() || (f.id != replies[0].id && f.id != replies[1].id)) return false;
    drive_report now = r;
    now.told = 0;
    double mode = -1, fault = -1;
    const bool sound = read_registers(f.payload(), [&](moteus_kind kind, std::uint32_t which, double value) {
      if (kind != moteus_kind::reply) return;
      const auto told = [&now](drive_quantity what) {
        now.told = static_cast<std::uint8_t>(now.told | what);
      };
      switch (static_cast<moteus_register>(which)) {
        case moteus_register::mode:
          mode = value, told(of_activity);
          break;
        case moteus_register::fault:
          fault = value, told(of_activity);
          break;
        case moteus_register::position:
          now.position = value * detail::radians_in_turn, told(of_position);
          break;
        case moteus_register::velocity:
          now.velocity = value * detail::radians_in_turn, told(of_velocity);
          break;
        case moteus_register::torque:
          now.torque = value, told(of_torque);
          break;
        case moteus_register::temperature:
          now.temperature = value, told(of_temperature);
          break;
        default:
          break;
      }
    });
    if (!sound || now.told == 0) return false;
    if (fault >= 0 && fault <= 255) now.code = static_cast<std::uint32_t>(fault);
    if (mode >= 0 && mode <= 255) {
      now.state = static_cast<std::uint32_t>(mode);
      now.activity = now.state == 0                      ? drive_activity::disabled
                     : now.state == 1 || now.state == 11 ? drive_activity::faulted
                     : now.state <= 4                    ? drive_activity::enabling
                                                         : drive_activity::enabled;
    }
    now.fault = now.activity != drive_activity::faulted ? drive_fault::none
                : now.state == 11                       ? drive_fault::watchdog
                                                        : fault_of(now.code);
    now.states += mode >= 0 && mode <= 255;
    ++now.frames;
    r = now;
    return true;
  }

  // The firmware keeps the part of kd within the part of kp.
  static constexpr double most_damping(double stiffness) noexcept {
    return Motor::damping * std::clamp(stiffness / Motor::stiffness, 0.0, 1.0);
  }

  // Holds its position, with all of kp and kd.
  static constexpr can_frame stay() noexcept {
    return position_mode(std::numeric_limits<double>::quiet_NaN(), 0, 0, 1, 1, Motor::torque);
  }
  // Shorts the windings: damps without control.
  static constexpr can_frame brake() noexcept { return detail::moteus_mode_frame(request_id, 15); }
  static constexpr drive_frames damp() noexcept { return {brake()}; }
  static constexpr drive_frames disable() noexcept { return {detail::moteus_mode_frame(request_id, 0)}; }

  // A faulted one may still hold or brake, by its timeout mode: disable() leads to mode 0.
  static constexpr bool is_off(const drive_report& r) noexcept {
    return r.activity == drive_activity::disabled;
  }

  class enabling {
  public:
    constexpr enable_step next(const drive_report& r) noexcept {
      if (!stopped) {
        stopped = true;
        states = r.states;
        return {disable(), enable_progress::going};
      }
      if (r.states >= states + 2 && r.activity == drive_activity::faulted)
        return {disable(), enable_progress::failed};
      return {{stay()},
              r.states >= states + 2 && r.activity == drive_activity::enabled ? enable_progress::done
                                                                              : enable_progress::going};
    }

  private:
    bool stopped = false;
    std::uint64_t states = 0;
  };

  // The drive's side, for virtual drives.
  using request = moteus_request;
  static constexpr bool hear(const can_frame& f, request& q) noexcept {
    return f.id == request_id && !f.remote && f.valid() && detail::read_moteus_request(f, q);
  }
  static constexpr can_frame reply(std::uint8_t mode,
                                   double position,
                                   double velocity,
                                   double torque,
                                   std::uint8_t fault = 0,
                                   std::int8_t temperature = 25) noexcept {
    can_frame f = fd({reply_number, reply_number > 0x7FF}, {});
    register_writer w(f.data);
    w.head(moteus_kind::reply, moteus_value::int32, moteus_register::mode, 4);
    bool cut = false;
    const auto put = [&](double number, moteus_register which) {
      w.number(static_cast<std::int32_t>(detail::nearest_integer(
          number / detail::moteus_step(static_cast<std::uint32_t>(which), moteus_value::int32), 32, cut)));
    };
    w.number(std::int32_t{mode});
    put(position / detail::radians_in_turn, moteus_register::position);
    put(velocity / detail::radians_in_turn, moteus_register::velocity);
    put(torque, moteus_register::torque);
    w.head(moteus_kind::reply, moteus_value::int8, moteus_register::temperature, 2);
    w.byte(static_cast<std::uint8_t>(temperature));
    w.byte(fault);
    return detail::padded(f, w.size());
  }

private:
  static constexpr double no_stop = std::numeric_limits<double>::quiet_NaN();
  static constexpr can_frame position_mode(double turns,
                                           double turns_a_second,
                                           double torque,
                                           double stiffness_part,
                                           double damping_part,
                                           double most_torque,
                                           double stop = no_stop) {
    return detail::moteus_position_frame(request_id, {turns, turns_a_second, torque, stiffness_part,
                                                      damping_part, most_torque, stop, Motor::timeout});
  }
  static constexpr drive_fault fault_of(std::uint32_t code) {
    switch (code) {
      case 0:
        return drive_fault::other;
      case 32:
      case 36:
      case 41:
      case 45:
      case 47:
      case 48:
        return drive_fault::configuration;
      case 33:
      case 44:
        return drive_fault::power_stage;
      case 34:
        return drive_fault::over_voltage;
      case 35:
      case 42:
      case 43:
        return drive_fault::position_sensor;
      case 38:
        return drive_fault::over_temperature;
      case 39:
        return drive_fault::limit;
      case 40:
        return drive_fault::under_voltage;
      default:
        return drive_fault::other;
    }
  }
};

}  // namespace cca::hardware
