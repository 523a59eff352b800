// A virtual drive of the MIT protocol: what the firmware of mit.hpp's drives does with its frames.
//
//   virtual_mit<mit_drive<ak60_6, 3>, 20'000'000> v;      // its CAN_TIMEOUT: 20 ms
//
// Damiao: what it answers tells whether it is enabled, and its watchdog is a fault (0xD) that it keeps until cleared: a set-point
// that comes late moves nothing any more. The others as follows.
//
// It answers each frame that it gets, enabled or not, and moves only after `enter`. Not fed for Timeout it goes to zero torque
// (motorcontrol zeroes its commands), and follows again as soon as it is fed. A fault, told in its error byte, takes the torque
// away until it is cleared. A reboot: silent for so long, then not enabled. 8 bytes that are no special frame are a command;
// other lengths are none. Source: bgkatz/motorcontrol, Core/Src/{can,foc,main}.c.
#pragma once

#include <cstdint>

#include <cca/hardware/mit.hpp>
#include <cca/hardware/virtual_drive.hpp>

namespace cca::hardware {

template <class Drive, std::int64_t Timeout = 20'000'000>
class virtual_mit {
public:
  using drive = Drive;
  static constexpr std::int64_t timeout = Timeout;

  bool hear(const can_frame& f, std::int64_t now) {
    if (f.id != Drive::request_id || f.fd || f.remote || f.length != 8) return false;
    if (gone(now)) return true;
    look_at(now);
    ++asked;
    fed = now;
    for (const mit_special what : {mit_special::clear_fault, mit_special::enter, mit_special::leave, mit_special::set_zero})
      if (f == mit_special_frame(Drive::request_id, what)) return special(what), true;
    command = Drive::wire::from_wire(Drive::wire::read(std::span<const std::uint8_t, 8>(f.data.data(), 8)));
    return true;
  }

  drive_command law(std::int64_t now) {
    look_at(now);
    if (gone(now) || !entered || code != 0 || now - fed > Timeout) return {};
    drive_command c = command;
    c.position += zero;
    return c;
  }

  drive_frames answer(const drive_motion& m) {
    drive_frames all;
    last = m.position;
    for (; asked > 0; --asked)
      if (all.size() < 8) all.add(Drive::reply(m.position - zero, m.velocity, m.torque, 25, status()));
    return silent ? drive_frames() : all;
  }

  bool enabled() const { return entered; }
  bool unfed(std::int64_t now) const { return now - fed > Timeout; }

  void go_silent(bool yes) { silent = yes; }
  void fail(std::uint32_t error) { code = error; }
  void reboot(std::int64_t now, std::int64_t duration) {
    back = now + duration;
    entered = false;
    code = 0;
    asked = 0;
    command = {};
  }
  void clear() { silent = false, code = 0; }

private:
  // Whether its answers tell: of the original and the AK's firmware nothing does.
  static constexpr bool tells = [] {
    drive_report r;
    return Drive::decode(Drive::reply(0, 0, 0, 25, 1), r) && r.activity == drive_activity::enabled;
  }();
  static constexpr std::uint32_t unfed_too_long = 0xD;

  bool gone(std::int64_t now) const { return now < back; }
  void look_at(std::int64_t now) {
    if (tells && entered && code == 0 && unfed(now)) code = unfed_too_long;
  }
  std::uint32_t status() const { return tells && code == 0 && entered ? 1 : code; }
  void special(mit_special what) {
    if (what == mit_special::enter) entered = true, command = {};
    if (what == mit_special::leave) entered = false;
    if (what == mit_special::set_zero) zero = last;
    if (what == mit_special::clear_fault) code = 0;
  }

  drive_command command{};
  std::int64_t fed = 0, back = 0;
  std::uint32_t code = 0;
  int asked = 0;
  bool entered = false, silent = false;
  double zero = 0, last = 0;
};

}  // namespace cca::hardware
