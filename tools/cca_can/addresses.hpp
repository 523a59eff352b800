// Which frames a drive of each family sends and hears, and what may be asked of it: frames that can't move it.
//
// `to_real` gives a frame of number 1 the drive's number, `to_unit` takes it away again; false: not of this drive.
#pragma once

#include <cstdint>
#include <string_view>

#include <cca/hardware/cia402.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/odrive.hpp>

namespace cca_can {

namespace hw = cca::hardware;

struct unit_ranges {
  static constexpr std::string_view name = "MIT";
  static constexpr auto limits =
      cca::limits{cca::angle{-1, 1}, cca::velocity{-1, 1}, cca::torque{-1, 1}, cca::stiffness{0, 1}, cca::damping{0, 1}};
};
template <hw::mit_firmware Firmware>
using unit_mit = hw::mit_drive<unit_ranges, 1, 0, Firmware>;

// It answers each frame; that which leaves the motor mode takes the torque away, whatever it did before.
template <hw::mit_firmware Firmware>
struct mit_address {
  std::uint32_t number = 1, master = 0;
  static constexpr const char* family = Firmware == hw::mit_firmware::damiao     ? "MIT, Damiao firmware"
                                        : Firmware == hw::mit_firmware::original ? "MIT, original firmware"
                                                                                 : "MIT, AK firmware";
  static constexpr bool needs_fd = false, clocked = false;

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
  hw::drive_frames ask() const { return {hw::mit_special_frame(hw::standard(number), hw::mit_special::leave)}; }
  hw::drive_frames ask_state() const { return ask(); }
  template <class Drive>
  hw::set_point_frames set_point(const hw::drive_command& c, double) const {
    return Drive::set_point(c);
  }
};

// It tells by itself.
struct odrive_address {
  std::uint32_t number = 0;
  static constexpr const char* family = "ODrive";
  static constexpr bool needs_fd = false, clocked = false;

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

// Asked to read registers it answers and does nothing.
struct unit_moteus_motor {
  static constexpr std::string_view name = "moteus";
  static constexpr double stiffness = 1, damping = 1, torque = 1e-3, timeout = 0.1;  // a torque that moves nothing, until stated
};
using unit_moteus = hw::moteus<unit_moteus_motor, 1>;

struct moteus_address {
  std::uint32_t number = 1;
  static constexpr const char* family = "moteus";
  static constexpr bool needs_fd = true, clocked = false;

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
    for (std::size_t used = w.size(); used < f.length; ++used) f.data[used] = 0x50;  // nothing
    return {f};
  }
  hw::drive_frames ask_state() const { return ask(); }
  template <class Drive>
  hw::set_point_frames set_point(const hw::drive_command& c, double most_torque) const {
    return Drive::set_point(c, most_torque);
  }
};

// It tells on SYNC. Asked for the type of device (object 1000h) it answers, in any state.
struct unit_cia402_motor {
  static constexpr std::string_view name = "CiA 402";
  static constexpr double counts = hw::detail::radians_in_turn, torque = 1;  // so that 1 is a count, and the rated torque
};
using unit_cia402 = hw::cia402<unit_cia402_motor, 1, hw::cia402_mode::position>;

struct cia402_address {
  std::uint32_t number = 1;
  static constexpr const char* family = "CiA 402";
  static constexpr bool needs_fd = false, clocked = true;

  void to_real(hw::can_frame& f) const {
    if (f.id == hw::standard(0)) f.data[1] = static_cast<std::uint8_t>(number);  // NMT, for all: who is meant stands in it
    else f.id.number = (f.id.number & ~0x7Fu) | number;
  }
  bool to_unit(hw::can_frame& f) const {
    if (f.id.extended || (f.id.number & 0x7F) != number) return false;
    f.id.number = (f.id.number & ~0x7Fu) | 1;
    return true;
  }
  bool is_answer(const hw::can_frame& f) const { return f.id == hw::standard(0x580 + number) && f.length == 8; }
  hw::drive_frames ask() const {
    return {hw::can_frame{.id = hw::standard(0x600 + number), .length = 8, .data = {0x40, 0x00, 0x10, 0x00}}};
  }
  hw::drive_frames ask_state() const { return {hw::canopen_start(static_cast<std::uint8_t>(number)), hw::canopen_sync()}; }
  template <class Drive>
  hw::set_point_frames set_point(const hw::drive_command& c, double) const {
    return Drive::set_point(c);
  }
};

}  // namespace cca_can
