// A RobStride in operation control, over CAN with 29-bit ids at 1 Mbit/s: a command and its answer have five
// and three numbers, each in 16 bits. Xiaomi's CyberGear speaks the same protocol.
//
//   using hip = cca::hardware::robstride<cca::hardware::rs04, 3>;  // drive 3, answers to host 0xFD
//
// An id has a type in its upper 5 bits, then 16 bits of data, then the number of the one that it is for. A
// drive answers each frame to it, and sends nothing else unless active reporting (type 24) is on. The
// commanded torque is in the id.
//   set_point   NaN or infinity anywhere refuses the whole command: cut to the range, it would mean the full
//               position. Numbers are cut to the ranges. A zero velocity or torque is half a step off zero,
//               0.26 mN m of 17
//   decode      a position at the end of its range may be beyond it (`at_end`); for firmware that wraps
//               there, state the width of the range in the joint's mounting (`wraps`). The fault bits and the
//               mode are in the id. Frames of type 21 have details of a fault, and are not taken
//   enabling    stop, which clears faults; operation control (run_mode 0), since another mode would take no
//               command; zero command, enable, zero command. Done when the drive reports the motor mode
//   faults      the lowest of the six bits that is set; `code` has all of them. A CyberGear calls bit 1
//               over-current and bit 4 the Hall sensors
//   watchdog    CAN_TIMEOUT (CyberGear: 200Ch), 20000 a second: then it enters the reset mode, without
//               torque. It is 0 by default: then the drive follows the last command for ever. Set it
// Ranges belong to the model, and no frame names them. State your own for models that are not listed.
//
// Cost: some dozen instructions a frame.
// Source: RobStride RS04 manual, driver protocol, types 1 to 4, 18 and 21 (as transcribed in
// zhangyan612/armController leg/canDoc.md); CyberGear manual 4.1 (belovictor/cybergear-docs); RobStride's
// own RobStride/SampleProgram RS/Robstride01.cpp, for the ranges of the RS01 and for host 0xFD; CAN_TIMEOUT:
// RS02 manual, pp. 31 and 47, as it is cited.
// Not verified: the host to which a command is answered, since its id names none; look first, and state
// `Host`. The end of the CyberGear's angle: 4 pi in its table, 12.5 in its example. What a command does
// before the drive is enabled, and what feeds CAN_TIMEOUT. docs/drives.md.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/mit_frame.hpp>

namespace cca::hardware {

namespace detail {

constexpr auto robstride_ranges(
    double position, double speed, double most_torque, double most_stiffness, double most_damping) {
  return cca::limits{angle{-position, position}, velocity{-speed, speed}, torque{-most_torque, most_torque},
                     stiffness{0, most_stiffness}, damping{0, most_damping}};
}

}  // namespace detail

struct rs01 {
  static constexpr std::string_view name = "RS01";
  static constexpr auto limits = detail::robstride_ranges(12.5, 44, 17, 500, 5);
};
struct rs04 {
  static constexpr std::string_view name = "RS04";
  static constexpr auto limits = detail::robstride_ranges(12.57, 15, 120, 5000, 100);
};
struct cybergear {
  static constexpr std::string_view name = "CyberGear";
  static constexpr auto limits = detail::robstride_ranges(2 * detail::radians_in_turn, 30, 12, 500, 5);
};

enum class robstride_frame : std::uint8_t { command = 1, report = 2, enable = 3, stop = 4, write = 18 };

// What a drive says that it does.
enum class robstride_state : std::uint8_t { reset = 0, calibration = 1, motor = 2 };

namespace detail {

template <class Ranges, int Number, int Host>
struct no_robstride_number {
  static constexpr void tell(auto& m) {
    m << "drive.bad_number: the number of " << Ranges::name << " is " << Number << ", and it answers to host "
      << Host << ": a RobStride has a number from 1 to 127, and its host another one";
  }
};

constexpr can_id robstride_id(robstride_frame type, std::uint32_t data, std::uint32_t to) {
  return extended(std::uint32_t{static_cast<std::uint8_t>(type)} << 24 | data << 8 | to);
}

}  // namespace detail

template <MitRanges Ranges, std::uint8_t Number, std::uint8_t Host = 0xFD>
struct robstride {
  static_assert(cca::detail::holds_or_tells<(Number >= 1 && Number <= 127 && Number != Host),
                                            detail::no_robstride_number<Ranges, Number, Host>>::value);

  template <class Quantity>
  static constexpr detail::steps range() {
    return {Ranges::limits.template of<Quantity>().lower, Ranges::limits.template of<Quantity>().upper, 16};
  }

  static constexpr std::string_view name = Ranges::name;
  static constexpr auto limits = Ranges::limits;
  static constexpr std::uint8_t uses = of_position | of_velocity | of_torque | of_stiffness | of_damping;
  // Of a command any torque; of the others those that we send.
  static constexpr std::array<can_filter, 4> requests{
      {{detail::robstride_id(robstride_frame::command, 0, Number), 0x1F0000FF},
       {detail::robstride_id(robstride_frame::enable, Host, Number)},
       {detail::robstride_id(robstride_frame::stop, Host, Number)},
       {detail::robstride_id(robstride_frame::write, Host, Number)}}};
  // Any faults and any mode.
  static constexpr std::array<can_filter, 1> replies{
      {{detail::robstride_id(robstride_frame::report, Number, Host), 0x1F00FFFF}}};
  // All frames to its number, from any host: one could give it another number or another zero.
  static constexpr std::array<can_filter, 1> occupies{{{extended(Number), 0xFF}}};
  static constexpr std::array<frame_traffic, 2> traffic{
      {{.shape = {.length = 8, .extended = true}}, {.shape = {.length = 8, .extended = true}}}};
  static constexpr drive_watchdog watchdog{0, "reset mode, without torque; off unless CAN_TIMEOUT is set"};

  static constexpr set_point_frames set_point(const drive_command& c) noexcept {
    set_point_frames s;
    for (const double number : {c.position, c.velocity, c.torque, c.stiffness, c.damping})
      s.finite &= detail::is_finite(number);
    if (!s.finite) return s;
    const auto step = [&s](const detail::steps& r, double number, drive_quantity of) {
      bool beyond = false;
      const std::uint32_t n = r.to_step(number, beyond);
      if (beyond) s.cut = static_cast<std::uint8_t>(s.cut | of);
      return n;
    };
    can_frame f{.id = detail::robstride_id(robstride_frame::command,
                                           step(range<cca::torque>(), c.torque, of_torque), Number),
                .length = 8};
    put_step(f, 0, step(range<angle>(), c.position, of_position));
    put_step(f, 2, step(range<velocity>(), c.velocity, of_velocity));
    put_step(f, 4, step(range<cca::stiffness>(), c.stiffness, of_stiffness));
    put_step(f, 6, step(range<cca::damping>(), c.damping, of_damping));
    s.frames.add(f);
    return s;
  }

  static constexpr bool decode(const can_frame& f, drive_report& r) noexcept {
    if (!replies[0].matches(f.id) || f.fd || f.remote || !f.valid() || f.length != 8) return false;
    const std::uint32_t position = got_step(f, 0), speed = got_step(f, 2), torque = got_step(f, 4);
    r.position = range<angle>().from_step(position);
    r.velocity = range<velocity>().from_step(speed);
    r.torque = range<cca::torque>().from_step(torque);
    r.temperature = got_step(f, 6) / 10.0;
    r.at_end = static_cast<std::uint8_t>((range<angle>().is_end(position) ? of_position : 0) |
                                         (range<velocity>().is_end(speed) ? of_velocity : 0) |
                                         (range<cca::torque>().is_end(torque) ? of_torque : 0));
    r.state = f.id.number >> 22 & 3;
    r.code = f.id.number >> 16 & 0x3F;
    r.fault = fault_of(r.code);
    r.activity = activity_of(static_cast<robstride_state>(r.state), r.fault);
    r.told = of_position | of_velocity | of_torque | of_temperature | of_activity;
    ++r.states;
    ++r.frames;
    return true;
  }

  // All zero: no stiffness, no damping, no torque.
  static constexpr can_frame still() noexcept { return set_point({}).frames[0]; }
  static constexpr can_frame enable() noexcept { return to_drive(robstride_frame::enable); }
  static constexpr can_frame stop() noexcept { return to_drive(robstride_frame::stop); }
  static constexpr can_frame clear_fault() noexcept {
    can_frame f = stop();
    f.data[0] = 1;
    return f;
  }
  // run_mode: 0 operation control, 1 position, 2 velocity, 3 current, 5 cyclic position.
  static constexpr can_frame run_mode(std::uint8_t mode) noexcept {
    can_frame f = to_drive(robstride_frame::write);
    detail::put(f.data, 0, std::uint16_t{0x7005});
    f.data[4] = mode;
    return f;
  }
  static constexpr drive_frames disable() noexcept { return {still(), stop()}; }

  class enabling {
  public:
    constexpr enable_step next(const drive_report& r) noexcept {
      if (!sent) {
        sent = true;
        before = r.states;
        return {{clear_fault(), run_mode(0), still(), enable(), still()}, enable_progress::going};
      }
      // The first answer may be one to a frame from before.
      if (r.states < before + 2) return {{still()}, enable_progress::going};
      if (r.activity == drive_activity::faulted) return {disable(), enable_progress::failed};
      if (r.activity == drive_activity::enabled) return {{still()}, enable_progress::done};
      return {{still(), enable(), still()}, enable_progress::going};
    }

  private:
    bool sent = false;
    std::uint64_t before = 0;
  };

  // The drive's side, for virtual drives. `hear`: whether the frame is a command, which is then in `c`.
  static constexpr bool hear(const can_frame& f, drive_command& c) noexcept {
    if (!requests[0].matches(f.id) || f.fd || f.remote || !f.valid() || f.length != 8) return false;
    c = {.position = range<angle>().from_step(got_step(f, 0)),
         .velocity = range<velocity>().from_step(got_step(f, 2)),
         .torque = range<cca::torque>().from_step(f.id.number >> 8 & 0xFFFF),
         .stiffness = range<cca::stiffness>().from_step(got_step(f, 4)),
         .damping = range<cca::damping>().from_step(got_step(f, 6))};
    return true;
  }
  // Numbers beyond the range become its end.
  static constexpr can_frame reply(robstride_state state,
                                   double position,
                                   double speed,
                                   double torque,
                                   double temperature = 25,
                                   std::uint32_t code = 0) noexcept {
    bool cut = false;
    const std::uint32_t data =
        std::uint32_t{static_cast<std::uint8_t>(state)} << 14 | (code & 0x3F) << 8 | Number;
    can_frame f{.id = detail::robstride_id(robstride_frame::report, data, Host), .length = 8};
    put_step(f, 0, range<angle>().to_step(position, cut));
    put_step(f, 2, range<velocity>().to_step(speed, cut));
    put_step(f, 4, range<cca::torque>().to_step(torque, cut));
    put_step(f, 6, detail::steps{0, 6553.5, 16}.to_step(temperature, cut));
    return f;
  }

private:
  static constexpr can_frame to_drive(robstride_frame type) {
    return {.id = detail::robstride_id(type, Host, Number), .length = 8};
  }
  // The upper byte first.
  static constexpr void put_step(can_frame& f, std::size_t at, std::uint32_t step) {
    f.data[at] = static_cast<std::uint8_t>(step >> 8);
    f.data[at + 1] = static_cast<std::uint8_t>(step);
  }
  static constexpr std::uint32_t got_step(const can_frame& f, std::size_t at) {
    return std::uint32_t{f.data[at]} << 8 | f.data[at + 1];
  }
  static constexpr drive_fault fault_of(std::uint32_t code) {
    constexpr drive_fault faults[] = {
        drive_fault::under_voltage,   drive_fault::power_stage, drive_fault::over_temperature,
        drive_fault::position_sensor,
        drive_fault::other,           // stalled, or overloaded
        drive_fault::configuration};  // not calibrated
    for (std::uint32_t bit = 0; bit < 6; ++bit)
      if (code >> bit & 1) return faults[bit];
    return drive_fault::none;
  }
  static constexpr drive_activity activity_of(robstride_state state, drive_fault fault) {
    if (fault != drive_fault::none) return drive_activity::faulted;
    switch (state) {
      case robstride_state::reset:
        return drive_activity::disabled;
      case robstride_state::calibration:
        return drive_activity::enabling;
      case robstride_state::motor:
        return drive_activity::enabled;
    }
    return drive_activity::unknown;
  }
};

}  // namespace cca::hardware
