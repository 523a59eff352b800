// A virtual CANopen drive: it reacts to frames as the firmware of a real one (cia402.hpp).
//
//   virtual_cia402<cia402<knee_motor, 5, cia402_mode::position>, 20'000'000, cia402_lost::quick_stop> v;
//
// It boots pre-operational, and takes process data once NMT has started it. On SYNC it takes what has come
// since the last SYNC, and answers. It goes through the states of CiA 402 by control words, and follows
// targets only in operation enabled; in position mode its servo has the gains `Gains`.
// Without process data for `Timeout`, or without a SYNC to take them, it sends emergency 8250h and does what
// object 6007h says (`Then`): a fault; voltage off; or a quick stop, after which it is off (605Ah = 2). It
// does the same when NMT takes it out of operation. A fault is reported by an emergency and kept until the
// rising edge of bit 7. Every 100 ms it sends a heartbeat; after a reboot, the boot-up heartbeat. Not
// modelled: ramps, following errors, SDO.
// Source: CiA 402-2 as in drive manuals (see docs/drives.md); CiA 301 for NMT, SYNC, emergencies and the
// event timer of an RPDO.
#pragma once

#include <cmath>
#include <cstdint>

#include <cca/hardware/drives/cia402.hpp>
#include <cca/hardware/virtual_drives/virtual_drive.hpp>

namespace cca::hardware {

// The values of object 6007h.
enum class cia402_lost : std::uint8_t { fault = 1, disable_voltage = 2, quick_stop = 3 };

template <class Drive,
          std::int64_t Timeout = 20'000'000,
          cia402_lost Then = cia402_lost::fault,
          virtual_gains Gains = virtual_gains{}>
class virtual_cia402 : public virtual_troubles {
public:
  using drive = Drive;
  static constexpr std::int64_t timeout = Timeout;
  static constexpr bool latches = true, waits = true;

  bool hear(const can_frame& f, std::int64_t now) {
    const bool sync = f == canopen_sync();
    const bool nmt = f.id == standard(0) && f.length == 2 && !f.fd && !f.remote &&
                     (f.data[1] == Drive::node || f.data[1] == 0);
    if (!sync && !nmt && f.id != Drive::receives) return false;
    advance_to(now);
    if (booting()) return true;
    if (nmt) manage(f.data[0]);
    else if (!operational) return true;
    else if (!sync) fresh = Drive::hear(f, word, wanted) || fresh;
    else {
      asked = true;
      if (fresh) fed = now, follow_control_word();
      fresh = false;
    }
    return true;
  }

  drive_command law(std::int64_t now) {
    advance_to(now);
    if (state == cia402_state::quick_stop) return {.damping = Gains.damping};
    if (state != cia402_state::enabled) return {};
    if constexpr (Drive::by_position)
      return {.position = target.position, .stiffness = Gains.stiffness, .damping = Gains.damping};
    else return {.torque = target.torque};
  }

  drive_frames answer(const drive_motion& m) {
    drive_frames all;
    if (state == cia402_state::quick_stop && std::fabs(m.velocity) < 0.05)
      state = cia402_state::switch_on_disabled;
    if (mute()) return all;
    if (emergency != nothing) all.add(Drive::emergency_frame(static_cast<std::uint16_t>(emergency)));
    if (booted || clock - beaten >= 100'000'000) {
      all.add(Drive::heartbeat_frame(booted ? 0 : operational ? 0x05 : 0x7F));
      beaten = clock;
    }
    if (asked)
      all.add(Drive::reply(status(), m.position, m.torque)), all.add(Drive::velocity_frame(m.velocity));
    emergency = nothing, booted = asked = false;
    return all;
  }

  bool enabled() const { return state == cia402_state::enabled; }
  cia402_state now_in() const { return state; }

  void fail(std::uint32_t code) { state = cia402_state::fault, emergency = code; }
  void clear() {
    silent = false;
    if (state == cia402_state::fault) state = cia402_state::switch_on_disabled, emergency = 0;
  }
  void reboot(std::int64_t now, std::int64_t duration) {
    boot(now, duration);
    state = cia402_state::switch_on_disabled;
    operational = asked = fresh = false, booted = true;
    word = 0, former = 0, emergency = nothing;
  }

private:
  static constexpr std::uint32_t nothing = 0x10000, unfed_too_long = 0x8250;  // the emergency `RPDO timeout`

  void advance_to(std::int64_t now) {
    clock = now;
    if (state == cia402_state::enabled && now - fed > Timeout) lose();
  }
  void lose() {
    fail(unfed_too_long);
    if (Then == cia402_lost::disable_voltage) state = cia402_state::switch_on_disabled;
    if (Then == cia402_lost::quick_stop) state = cia402_state::quick_stop;
  }
  void manage(std::uint8_t what) {
    if (what == 0x81 || what == 0x82) return reboot(clock, 0);
    operational = what == 1 || (operational && what != 2 && what != 0x80);
    if (!operational && state == cia402_state::enabled) lose();
  }
  void follow_control_word() {
    const bool rises = (word & 0x80) != 0 && (former & 0x80) == 0;
    former = word;
    const auto is = [this](cia402_state s) { return state == s; };
    using enum cia402_state;
    if (is(fault)) {
      if (rises) state = switch_on_disabled, emergency = 0;
    } else if ((word & 0x80) == 0) {
      if ((word & 0x02) == 0) state = switch_on_disabled;
      else if ((word & 0x04) == 0) state = is(enabled) || is(quick_stop) ? quick_stop : switch_on_disabled;
      else if ((word & 0x01) == 0) state = is(quick_stop) ? quick_stop : ready;
      else if ((word & 0x08) == 0) state = is(ready) || is(enabled) ? switched_on : state;
      else state = is(switched_on) ? enabled : is(ready) ? switched_on : state;
    }
    if (is(enabled)) target = wanted;
  }
  std::uint16_t status() const {
    switch (state) {
      case cia402_state::ready:
        return 0x0231;
      case cia402_state::switched_on:
        return 0x0233;
      case cia402_state::enabled:
        return 0x1237;  // it follows the target
      case cia402_state::quick_stop:
        return 0x0217;
      case cia402_state::fault:
        return 0x0218;
      default:
        return 0x0250;
    }
  }

  drive_command wanted{}, target{};
  std::int64_t fed = 0, beaten = 0;
  std::uint32_t emergency = nothing;
  std::uint16_t word = 0, former = 0;
  cia402_state state = cia402_state::switch_on_disabled;
  bool operational = false, fresh = false, asked = false, booted = true;
};

}  // namespace cca::hardware
