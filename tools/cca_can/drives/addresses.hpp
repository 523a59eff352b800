// How the frames of a drive change with its number, for each family; and which frames may ask it something:
// those that can't move it.
//
// `to_real` gives a frame for number 1 the drive's number, `to_unit` takes it away again; false: the frame is
// not this drive's. `least_number` and `most_number`: which numbers such a drive can have.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <cca/hardware/cia402.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/odrive.hpp>
#include <cca/hardware/robstride.hpp>

#include "any_drive.hpp"
#include "canopen_objects.hpp"

namespace cca_can {

namespace hw = cca::hardware;

struct unit_ranges {
  static constexpr std::string_view name = "MIT";
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::velocity{-1, 1}, cca::torque{-1, 1},
                                             cca::stiffness{0, 1}, cca::damping{0, 1}};
};
template <hw::mit_firmware Firmware>
using unit_mit = hw::mit_drive<unit_ranges, 1, 0, Firmware>;

// It answers each frame. Asking takes its torque away: the question is the frame that leaves the motor mode.
template <hw::mit_firmware Firmware>
struct mit_address {
  std::uint32_t number = 1, master = 0;
  static constexpr const char* family = Firmware == hw::mit_firmware::damiao     ? "MIT, Damiao firmware"
                                        : Firmware == hw::mit_firmware::original ? "MIT, original firmware"
                                                                                 : "MIT, AK firmware";
  static constexpr bool needs_fd = false, clocked = false;
  static constexpr std::uint32_t least_number = 1,
                                 most_number = Firmware == hw::mit_firmware::damiao ? 15 : 255;

  void to_real(hw::can_frame& f) const {
    if (f.id == hw::standard(1)) {
      f.id = hw::standard(number);
    } else {
      f.id = hw::standard(master);
      f.data[0] = static_cast<std::uint8_t>(f.data[0] - 1 + number);
    }
  }
  bool to_unit(hw::can_frame& f) const {
    const bool damiao = Firmware == hw::mit_firmware::damiao;
    if (f.id == hw::standard(number)) {
      f.id = hw::standard(1);
    } else if (f.id == hw::standard(master) && (damiao ? f.data[0] & 0xFu : f.data[0]) == number) {
      f.id = hw::standard(0);
      f.data[0] = static_cast<std::uint8_t>(f.data[0] - number + 1);
    } else {
      return false;
    }
    return true;
  }
  bool is_answer(const hw::can_frame&) const { return false; }
  hw::drive_frames ask() const {
    return {hw::mit_special_frame(hw::standard(number), hw::mit_special::leave)};
  }
  hw::drive_frames ask_state() const { return ask(); }
  template <class Drive>
  hw::set_point_frames set_point(const hw::drive_command& c, double) const {
    return Drive::set_point(c);
  }
};

// It reports by itself.
struct odrive_address {
  std::uint32_t number = 0;
  static constexpr const char* family = "ODrive";
  static constexpr bool needs_fd = false, clocked = false;
  static constexpr std::uint32_t least_number = 0, most_number = 0xFFFFFF;

  void to_real(hw::can_frame& f) const { f.id = {number << 5 | (f.id.number & 31), number > 63}; }
  bool to_unit(hw::can_frame& f) const {
    if (f.id.number >> 5 != number || f.id.extended != (number > 63)) return false;
    f.id = hw::standard(1u << 5 | (f.id.number & 31));
    return true;
  }
  bool is_answer(const hw::can_frame&) const { return false; }
  hw::drive_frames ask() const { return {}; }
  hw::drive_frames ask_state() const { return ask(); }
  template <class Drive>
  hw::set_point_frames set_point(const hw::drive_command& c, double) const {
    return Drive::set_point(c);
  }
};

// When asked to read registers, it answers and does nothing else.
struct unit_moteus_motor {
  static constexpr std::string_view name = "moteus";
  static constexpr double stiffness = 1, damping = 1;
  static constexpr double torque = 1e-3, timeout = 0.1;  // until stated: a torque that moves nothing
  static constexpr double run_on = 0.01;                 // two cycles of `jog`
};
using unit_moteus = hw::moteus<unit_moteus_motor, 1>;

struct moteus_address {
  std::uint32_t number = 1;
  static constexpr const char* family = "moteus";
  static constexpr bool needs_fd = true, clocked = false;
  static constexpr std::uint32_t least_number = 1, most_number = 127;

  void to_real(hw::can_frame& f) const {
    if (f.id.number & 0x8000) f.id.number = 0x8000 | number;
    else f.id = {number << 8, number << 8 > 0x7FF};
  }
  bool to_unit(hw::can_frame& f) const {
    if (f.id == hw::extended(0x8000 | number)) f.id.number = 0x8001;
    else if (f.id.number == number << 8) f.id.number = 0x100;
    else return false;
    return true;
  }
  bool is_answer(const hw::can_frame&) const { return false; }
  hw::drive_frames ask() const {
    hw::can_frame f = hw::fd(hw::extended(0x8000 | number), {});
    hw::register_writer w(f.data);
    w.head(hw::moteus_kind::read, hw::moteus_value::int32, hw::moteus_register::mode, 4);
    w.head(hw::moteus_kind::read, hw::moteus_value::int8, hw::moteus_register::temperature, 2);
    f.length = hw::fd_length(w.size());
    for (std::size_t used = w.size(); used < f.length; ++used) f.data[used] = 0x50;  // empty subframes
    return {f};
  }
  hw::drive_frames ask_state() const { return ask(); }
  template <class Drive>
  hw::set_point_frames set_point(const hw::drive_command& c, double most_torque) const {
    return Drive::set_point(c, most_torque);
  }
};

// It answers each frame. Asking takes its torque away: the question is the frame that stops it.
using unit_robstride = hw::robstride<unit_ranges, 1>;

struct robstride_address {
  std::uint32_t number = 1, host = unit_host;
  static constexpr std::uint32_t unit_host = 0xFD;  // of `unit_robstride`
  static constexpr const char* family = "RobStride";
  static constexpr bool needs_fd = false, clocked = false;
  static constexpr std::uint32_t least_number = 1, most_number = 127;

  void to_real(hw::can_frame& f) const { move(f, 1, unit_host, number, host); }
  bool to_unit(hw::can_frame& f) const { return move(f, number, host, 1, unit_host); }
  bool is_answer(const hw::can_frame&) const { return false; }
  hw::drive_frames ask() const {
    hw::can_frame f = unit_robstride::stop();
    to_real(f);
    return {f};
  }
  hw::drive_frames ask_state() const { return ask(); }
  template <class Drive>
  hw::set_point_frames set_point(const hw::drive_command& c, double) const {
    return Drive::set_point(c);
  }

private:
  // A report says from which drive it comes, to which host; a command has its torque there.
  static bool move(hw::can_frame& f,
                   std::uint32_t from,
                   std::uint32_t from_host,
                   std::uint32_t to,
                   std::uint32_t to_host) {
    const std::uint32_t upper = f.id.number & 0xFFFF0000, data = f.id.number >> 8 & 0xFF,
                        address = f.id.number & 0xFF;
    const auto is = [&f](hw::robstride_frame type) {
      return f.id.number >> 24 == static_cast<std::uint32_t>(type);
    };
    if (!f.id.extended) return false;
    if (is(hw::robstride_frame::report)) {
      if (address != from_host || data != from) return false;
      f.id.number = upper | to << 8 | to_host;
    } else if (is(hw::robstride_frame::command)) {
      if (address != from) return false;
      f.id.number = upper | data << 8 | to;
    } else {
      if (address != from || data != from_host) return false;
      f.id.number = upper | to_host << 8 | to;
    }
    return true;
  }
};

// It reports on SYNC. When asked for its device type (object 1000h), it answers in any state.
struct unit_cia402_motor {
  static constexpr std::string_view name = "CiA 402";
  // So 1 is a count, and the rated torque.
  static constexpr double counts = hw::detail::radians_in_turn, torque = 1;
};
using unit_cia402 = hw::cia402<unit_cia402_motor, 1, hw::cia402_mode::position>;

using unit_cia402_torque = hw::cia402<unit_cia402_motor, 1, hw::cia402_mode::torque>;

// Its mode is a setting of the drive, and a set point for one mode means something else in the other one
// (position 0, torque 0). So we ask for it (6061h); in position mode also for its largest torque (6072h, in
// thousandths of the rated torque), which no frame limits.
struct cia402_address {
  std::uint32_t number = 1;
  static constexpr const char* family = "CiA 402";
  static constexpr bool needs_fd = false, clocked = true;
  static constexpr std::uint32_t least_number = 1, most_number = 127;

  void to_real(hw::can_frame& f) const {
    // NMT is for all nodes: the number stands in the data.
    if (f.id == hw::standard(0)) f.data[1] = static_cast<std::uint8_t>(number);
    else f.id.number = (f.id.number & ~0x7Fu) | number;
  }
  bool to_unit(hw::can_frame& f) const {
    if (f.id.extended || (f.id.number & 0x7F) != number) return false;
    f.id.number = (f.id.number & ~0x7Fu) | 1;
    return true;
  }
  // Frames for all nodes, and frames for this one.
  bool to_unit_request(hw::can_frame& f) const {
    if (f == hw::canopen_sync()) return true;
    if (f.id != hw::standard(0)) return to_unit(f);
    if (f.data[1] == number) f.data[1] = 1;
    else if (f.data[1] != 0) return false;
    return true;
  }
  bool is_answer(const hw::can_frame& f) const {
    return f.id == hw::standard(0x580 + number) && f.length == 8;
  }
  hw::drive_frames ask() const { return {ask_for(number, canopen_object::device_type)}; }
  template <class Drive>
  hw::drive_frames ask_settings(const drive_settings& s) const {
    if (!s.mode) return {ask_for(number, canopen_object::mode_of_operation)};
    if (Drive::by_position && !s.most_torque) return {ask_for(number, canopen_object::most_torque)};
    return {};
  }
  void hear_setting(const hw::can_frame& f, drive_settings& s) const {
    if (const auto mode = told_of(f, number, canopen_object::mode_of_operation)) s.mode = mode;
    if (const auto most = told_of(f, number, canopen_object::most_torque)) s.most_torque = most;
  }
  template <class Drive>
  std::string wrong_setting(const drive_settings& s, double torque, double rated) const {
    constexpr std::uint32_t wanted = Drive::by_position ? 8 : 10;
    if (s.mode && *s.mode != wanted)
      return "it is configured for mode " + std::to_string(*s.mode) + " (6061h), and its name says " +
             std::to_string(wanted) + ": cia402 is cyclic position, 8, cia402-torque is cyclic torque, 10";
    if (!Drive::by_position || torque == 0) return {};
    if (const double most = s.most_torque.value_or(0) * rated / 1000; most > torque)
      return "it is in position mode, and may use " + std::to_string(most) +
             " N m (6072h): set that to at most " + std::to_string(static_cast<int>(torque / rated * 1000)) +
             " thousandths of its rated torque first";
    return {};
  }
  // For a drive that is played.
  template <class Drive>
  std::optional<hw::can_frame> answer(const hw::can_frame& f) const {
    if (f == ask_for(number, canopen_object::device_type))
      return tell(number, canopen_object::device_type, 0x00020192, 4);
    if (f == ask_for(number, canopen_object::mode_of_operation))
      return tell(number, canopen_object::mode_of_operation, Drive::by_position ? 8 : 10, 1);
    if (f == ask_for(number, canopen_object::most_torque))
      return tell(number, canopen_object::most_torque, most_torque, 2);
    return {};
  }
  std::uint16_t most_torque = 1000;
  hw::drive_frames ask_state() const {
    return {hw::canopen_start(static_cast<std::uint8_t>(number)), hw::canopen_sync()};
  }
  template <class Drive>
  hw::set_point_frames set_point(const hw::drive_command& c, double) const {
    return Drive::set_point(c);
  }
};

}  // namespace cca_can
