// A virtual drive of the MIT protocol: it reacts to frames as the firmware of a real one (mit.hpp).
//
//   virtual_mit<mit_drive<ak60_6, 3>, 20'000'000> v;      // its CAN_TIMEOUT: 20 ms
//
// It answers each frame that it gets, enabled or not. It moves only after `enter`, and then follows the last
// command, also one from before: so entering without a zero command makes it jerk. Commands feed it, special
// frames don't. Unfed for `Timeout` it goes to zero torque (motorcontrol zeroes its commands), and follows
// again as soon as it is fed. A fault is in its error byte and takes the torque away until it is cleared.
// After a reboot it is silent for a while, then not enabled. 8 bytes that are no special frame are a command;
// no other length is. Damiao differs: its answers say whether it is enabled, its watchdog is a fault (0xD),
// and a fault disables it. So a late set point moves nothing until the fault is cleared and the drive is
// enabled again.
// Source: bgkatz/motorcontrol, Core/Src/{fsm,foc,stm32f4xx_it}.c.
#pragma once

#include <cstdint>

#include <cca/hardware/drives/mit.hpp>
#include <cca/hardware/virtual_drives/virtual_drive.hpp>

namespace cca::hardware {

template <class Drive, std::int64_t Timeout = 20'000'000>
class virtual_mit : public virtual_troubles {
  // Whether its answers say that it is enabled: not with the original firmware and the AK's.
  static constexpr bool says_enabled = [] {
    drive_report r;
    return Drive::decode(Drive::reply(0, 0, 0, 25, 1), r) && r.activity == drive_activity::enabled;
  }();

public:
  using drive = Drive;
  static constexpr std::int64_t timeout = Timeout;
  static constexpr bool latches = says_enabled, waits = true;

  bool hear(const can_frame& f, std::int64_t now) {
    if (f.id != Drive::request_id || f.fd || f.remote || f.length != 8) return false;
    advance_to(now);
    if (booting()) return true;
    ++asked;
    for (const mit_special what :
         {mit_special::clear_fault, mit_special::enter, mit_special::leave, mit_special::set_zero})
      if (f == mit_special_frame(Drive::request_id, what)) return special(what), true;
    fed = now;
    command = Drive::wire::from_wire(Drive::wire::read(std::span<const std::uint8_t, 8>(f.data.data(), 8)));
    return true;
  }

  drive_command law(std::int64_t now) {
    advance_to(now);
    if (booting() || !entered || code != 0 || now - fed > Timeout) return {};
    drive_command c = command;
    c.position += zero;
    return c;
  }

  drive_frames answer(const drive_motion& m) {
    drive_frames all;
    last = m.position;
    for (; asked > 0; --asked)
      if (all.size() < 8) all.add(Drive::reply(m.position - zero, m.velocity, m.torque, 25, status()));
    return mute() ? drive_frames() : all;
  }

  bool enabled() const { return entered && code == 0; }
  bool unfed(std::int64_t now) const { return now - fed > Timeout; }

  void fail(std::uint32_t error) {
    code = error;
    if (says_enabled) entered = false;
  }
  void reboot(std::int64_t now, std::int64_t duration) {
    boot(now, duration);
    entered = false;
    code = 0;
    asked = 0;
    command = {};
  }
  void clear() { silent = false, code = 0; }

private:
  static constexpr std::uint32_t unfed_too_long = 0xD;

  void advance_to(std::int64_t now) {
    clock = now;
    if (says_enabled && entered && code == 0 && unfed(now)) fail(unfed_too_long);
  }
  std::uint32_t status() const { return says_enabled && code == 0 && entered ? 1 : code; }
  void special(mit_special what) {
    if (what == mit_special::enter) entered = code == 0 || !says_enabled;
    if (what == mit_special::leave) entered = false, command = {};
    if (what == mit_special::set_zero) zero = last;
    if (what == mit_special::clear_fault) code = 0;
  }

  drive_command command{};
  std::int64_t fed = 0;
  std::uint32_t code = 0;
  int asked = 0;
  bool entered = false;
  double zero = 0, last = 0;
};

}  // namespace cca::hardware
