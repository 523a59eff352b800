// A drive that speaks the MIT mini-cheetah protocol: T-Motor/CubeMars AK in MIT mode, the original firmware,
// Damiao.
//
//   using hip = cca::hardware::mit_drive<cca::hardware::ak80_9, 3>;  // id 3; all drives reply under id 0
//
// It answers each frame that it gets, and sends nothing else: the answer in the same cycle shows that it is
// there. All drives of a bus may answer under one id. The first byte names the drive, so its number is at
// most 255 (Damiao: 15).
//   set_point   NaN or infinity anywhere refuses the whole command: cut to the range, it would mean the full
//               position. Numbers are cut to the ranges. A zero velocity or torque is half a step off zero,
//               0.0022 N m of 18
//   decode      a position at the end of its range may be beyond it (`at_end`). For firmware that wraps
//               there, state the width of the range in the joint's mounting (`wraps`). The original firmware
//               answers with 6 bytes, later versions with 7 (bgkatz/motorcontrol 08bfade, Core/Src/can.c)
//   enabling    zero command, enter, zero command: so it enters without a jerk. Done with the first answer
//               after that
//   faults      the AK's error byte, Damiao's upper half of the first byte; other firmware reports none
//   watchdog    a setting of the firmware, CAN_TIMEOUT, in cycles of its loop. It is off by default: then the
//               drive follows the last command for ever. Set it
// Ranges of AK10-9, 60-6, 70-10, 80-6, 80-9 and 80-64 are from the manual. AK80 with firmware 1.1 has +-22.5
// rad/s: state your own.
//
// Cost: some dozen instructions a frame.
// Source: mit_frame.hpp. CubeMars AK series actuator driver manual 1.0.8, pp. 48 to 50, for frames and ranges
// (AK60-6: 45 rad/s there, 50 in neurobionics/TMotorCANControl). The error byte is from drivers that cite the
// later manual, 5.2.1: 6 is the power stage's temperature there, unbalanced phases in TMotorCANControl; 7 is
// a stall, `other` here. Damiao: DM-J4310 manual 1.0 and DM-S3519 manual 1.1, as drivers cite them.
// Not verified: the id under which an AK answers. The manual has `0x00 + drive ID`, which is read as 0 and as
// the drive's own: look first, and state `Master`. Nor the ranges of the AK's third generation: a driver
// cites manual 3.0.0 with 12.56 rad, and 28 rad/s and 54 N m for the AK10-9.
// docs/drives.md.
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/mit_frame.hpp>

namespace cca::hardware {

namespace detail {

constexpr auto mit_ranges(double speed, double most_torque) {
  return cca::limits{angle{-12.5, 12.5}, velocity{-speed, speed}, torque{-most_torque, most_torque},
                     stiffness{0, 500}, damping{0, 5}};
}

}  // namespace detail

struct ak10_9 {
  static constexpr std::string_view name = "AK10-9";
  static constexpr auto limits = detail::mit_ranges(50, 65);
};
struct ak60_6 {
  static constexpr std::string_view name = "AK60-6";
  static constexpr auto limits = detail::mit_ranges(45, 15);
};
struct ak70_10 {
  static constexpr std::string_view name = "AK70-10";
  static constexpr auto limits = detail::mit_ranges(50, 25);
};
struct ak80_6 {
  static constexpr std::string_view name = "AK80-6";
  static constexpr auto limits = detail::mit_ranges(76, 12);
};
struct ak80_9 {
  static constexpr std::string_view name = "AK80-9";
  static constexpr auto limits = detail::mit_ranges(50, 18);
};
struct ak80_64 {
  static constexpr std::string_view name = "AK80-64";
  static constexpr auto limits = detail::mit_ranges(8, 144);
};

// What a reply has beside the three numbers depends on the firmware.
enum class mit_firmware : std::uint8_t { original, ak, damiao };

namespace detail {
template <class Ranges, std::uint32_t Number, std::uint32_t Master, mit_firmware Firmware>
struct no_mit_number {
  static constexpr void tell(auto& m) {
    constexpr bool is_damiao = Firmware == mit_firmware::damiao;
    if (Master > 0x7FF)
      m << "drive.bad_number: the id of the replies of " << Ranges::name << " is " << std::int64_t{Master}
        << ", and Master is an 11-bit id, at most 2047";
    else
      m << "drive.bad_number: the number of " << Ranges::name << " is " << std::int64_t{Number}
        << ", and that of " << (is_damiao ? "a Damiao is at most 15" : "an MIT drive is at most 255")
        << ", since it stands in the first byte of its replies";
  }
};
}  // namespace detail

template <MitRanges Ranges,
          std::uint32_t Number,
          std::uint32_t Master = 0,
          mit_firmware Firmware = mit_firmware::ak>
struct mit_drive {
  static_assert(cca::detail::holds_or_tells<(Number <= (Firmware == mit_firmware::damiao ? 15 : 255) &&
                                             Master <= 0x7FF),
                                            detail::no_mit_number<Ranges, Number, Master, Firmware>>::value);
  using wire = mit_wire<Ranges>;

  static constexpr std::string_view name = Ranges::name;
  static constexpr auto limits = Ranges::limits;
  static constexpr std::uint8_t uses = of_position | of_velocity | of_torque | of_stiffness | of_damping;
  static constexpr std::uint8_t reply_length = Firmware == mit_firmware::original ? 6 : 8;
  // The original firmware's later versions add a byte, the supply's voltage.
  static constexpr std::uint8_t longest_reply = Firmware == mit_firmware::original ? 7 : 8;
  static constexpr can_id request_id = standard(Number), reply_id = standard(Master);
  static constexpr std::array<can_filter, 1> requests{{{request_id}}}, replies{{{reply_id}}};
  // All drives may answer under one id.
  static constexpr drive_mark reply_mark{Number, Firmware == mit_firmware::damiao ? 0x0F : 0xFF};
  static constexpr std::array<frame_traffic, 2> traffic{
      {{.shape = {.length = 8}}, {.shape = {.length = longest_reply}}}};
  static constexpr drive_watchdog watchdog{0, "torque to zero; off unless CAN_TIMEOUT is set"};

  static constexpr set_point_frames set_point(const drive_command& c) noexcept {
    set_point_frames result;
    for (const double number : {c.position, c.velocity, c.torque, c.stiffness, c.damping})
      result.finite &= detail::is_finite(number);
    if (result.finite) result.frames.add(wire::frame(request_id, wire::to_wire(c, result.cut)));
    return result;
  }

  static constexpr bool decode(const can_frame& f, drive_report& r) noexcept {
    if (f.id != reply_id || f.fd || f.remote || f.length < reply_length || f.length > longest_reply)
      return false;
    const auto& d = f.data;
    if ((Firmware == mit_firmware::damiao ? d[0] & 0xFu : d[0]) != Number) return false;
    const std::uint32_t position = std::uint32_t{d[1]} << 8 | d[2],
                        velocity = std::uint32_t{d[3]} << 4 | d[4] >> 4, torque = (d[4] & 0xFu) << 8 | d[5];
    r.position = wire::position.from_step(position);
    r.velocity = wire::velocity.from_step(velocity);
    r.torque = wire::torque.from_step(torque);
    r.at_end = static_cast<std::uint8_t>((wire::position.is_end(position) ? of_position : 0) |
                                         (wire::velocity.is_end(velocity) ? of_velocity : 0) |
                                         (wire::torque.is_end(torque) ? of_torque : 0));
    r.told = of_position | of_velocity | of_torque;
    if constexpr (Firmware != mit_firmware::original) {
      r.temperature = d[6];
      r.code = Firmware == mit_firmware::damiao ? d[0] >> 4 : d[7];
      r.fault = fault_of(r.code);
      r.activity = activity_of(r.code, r.fault);
      r.told = static_cast<std::uint8_t>(r.told | of_temperature | of_activity);
    }
    r.states += Firmware != mit_firmware::original;
    ++r.frames;
    return true;
  }

  // The drive's side, for virtual drives. Numbers beyond the range become its end.
  static constexpr can_frame reply(double position,
                                   double velocity,
                                   double torque,
                                   std::uint8_t temperature = 25,
                                   std::uint32_t code = 0) noexcept {
    bool cut = false;
    const std::uint32_t p = wire::position.to_step(position, cut), v = wire::velocity.to_step(velocity, cut),
                        t = wire::torque.to_step(torque, cut);
    const auto byte = [](std::uint32_t n) { return static_cast<std::uint8_t>(n); };
    can_frame f{
        .id = reply_id,
        .length = reply_length,
        .data = {byte(Number), byte(p >> 8), byte(p), byte(v >> 4), byte((v & 0xF) << 4 | t >> 8), byte(t)}};
    if constexpr (Firmware != mit_firmware::original) f.data[6] = temperature;
    if constexpr (Firmware == mit_firmware::ak) f.data[7] = byte(code);
    if constexpr (Firmware == mit_firmware::damiao) f.data[0] = byte(Number | code << 4);
    return f;
  }

  // All zero: no stiffness, no damping, no torque.
  static constexpr can_frame still() noexcept { return set_point({}).frames[0]; }
  static constexpr drive_frames disable() noexcept {
    return {still(), mit_special_frame(request_id, mit_special::leave)};
  }
  // Only Damiao drives say whether they are enabled; of the others an answer is all there is.
  static constexpr bool is_off(const drive_report& r) noexcept {
    return Firmware != mit_firmware::damiao || r.activity == drive_activity::disabled ||
           r.activity == drive_activity::faulted;
  }
  // For Damiao drives.
  static constexpr can_frame clear_fault() noexcept {
    return mit_special_frame(request_id, mit_special::clear_fault);
  }
  // The present position becomes 0.
  static constexpr can_frame set_zero() noexcept {
    return mit_special_frame(request_id, mit_special::set_zero);
  }

  class enabling {
  public:
    constexpr enable_step next(const drive_report& r) noexcept {
      if (!sent) {
        sent = true;
        before = r.frames;
        const can_frame enter = mit_special_frame(request_id, mit_special::enter);
        if constexpr (Firmware == mit_firmware::damiao)  // it keeps each fault until it is cleared
          return {{still(), clear_fault(), enter, still()}, enable_progress::going};
        return {{still(), enter, still()}, enable_progress::going};
      }
      if (r.frames == before) return {{still()}, enable_progress::going};
      return {{still()}, r.fault == drive_fault::none ? enable_progress::done : enable_progress::failed};
    }

  private:
    bool sent = false;
    std::uint64_t before = 0;
  };

private:
  static constexpr drive_fault fault_of(std::uint32_t code) {
    if constexpr (Firmware == mit_firmware::damiao) {
      switch (code) {
        case 0:
        case 1:
          return drive_fault::none;
        case 5:
          return drive_fault::position_sensor;
        case 6:
          return drive_fault::configuration;
        case 8:
          return drive_fault::over_voltage;
        case 9:
          return drive_fault::under_voltage;
        case 0xA:
          return drive_fault::over_current;
        case 0xB:
        case 0xC:
          return drive_fault::over_temperature;
        case 0xD:
          return drive_fault::watchdog;
        case 0xE:
          return drive_fault::limit;
        default:
          return drive_fault::other;
      }
    } else {
      constexpr drive_fault faults[] = {drive_fault::none,
                                        drive_fault::over_temperature,
                                        drive_fault::over_current,
                                        drive_fault::over_voltage,
                                        drive_fault::under_voltage,
                                        drive_fault::position_sensor,
                                        drive_fault::over_temperature};
      return code < std::size(faults) ? faults[code] : drive_fault::other;
    }
  }
  // Damiao reports whether it is enabled; an AK doesn't.
  static constexpr drive_activity activity_of(std::uint32_t code, drive_fault fault) {
    if (fault != drive_fault::none) return drive_activity::faulted;
    if constexpr (Firmware == mit_firmware::damiao)
      return code == 1 ? drive_activity::enabled : drive_activity::disabled;
    else return drive_activity::unknown;
  }
};

}  // namespace cca::hardware
