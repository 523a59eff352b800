// A virtual RobStride: it reacts to frames as the firmware of a real one (robstride.hpp).
//
//   virtual_robstride<robstride<rs04, 3>, 20'000'000> v;      // its CAN_TIMEOUT: 20 ms
//
// It answers each frame that it takes, in any mode. It moves in the motor mode, which a frame enables and
// which it leaves when it is stopped, and then follows the last command, also one from before: so enabling
// without a zero command makes it jerk. Commands count in operation control only (run_mode 0). Each frame
// that it takes feeds it. Unfed for `Timeout` it enters the reset mode: so a late set point moves nothing
// until the drive is enabled again. That is no fault. A fault does the same, and is in its answers until it
// is cleared. After a reboot it is silent for a while, then in the reset mode and in operation control.
// A frame for enabling has a payload of zeros here; what the firmware does with others is not documented.
// Source: robstride.hpp. docs/drives.md.
#pragma once

#include <algorithm>
#include <cstdint>

#include <cca/hardware/drives/robstride.hpp>
#include <cca/hardware/virtual_drives/virtual_drive.hpp>

namespace cca::hardware {

template <class Drive, std::int64_t Timeout = 20'000'000>
class virtual_robstride : public virtual_troubles {
public:
  using drive = Drive;
  static constexpr std::int64_t timeout = Timeout;
  static constexpr bool latches = true, waits = true;

  bool hear(const can_frame& f, std::int64_t now) {
    const auto& own = Drive::requests;
    if (std::none_of(own.begin(), own.end(), [&f](const can_filter& mine) { return mine.matches(f.id); }))
      return false;
    advance_to(now);
    if (booting() || !take(f)) return true;
    fed = now;
    ++asked;
    return true;
  }

  drive_command law(std::int64_t now) {
    advance_to(now);
    return booting() || !enabled() ? drive_command() : command;
  }

  drive_frames answer(const drive_motion& m) {
    drive_frames all;
    for (; asked > 0; --asked)
      if (all.size() < 8) all.add(Drive::reply(state, m.position, m.velocity, m.torque, 25, code));
    return mute() ? drive_frames() : all;
  }

  bool enabled() const { return state == robstride_state::motor && mode == operation_control; }

  void fail(std::uint32_t bits) { code = bits & 0x3F, state = robstride_state::reset; }
  void reboot(std::int64_t now, std::int64_t duration) {
    boot(now, duration);
    state = robstride_state::reset, mode = operation_control, code = 0, asked = 0, command = {};
  }
  void clear() { silent = false, code = 0; }

private:
  static constexpr std::uint8_t operation_control = 0;

  void advance_to(std::int64_t now) {
    clock = now;
    if (now - fed > Timeout) state = robstride_state::reset;
  }
  // False: the frame makes no sense.
  bool take(const can_frame& f) {
    if (Drive::hear(f, command)) return true;
    if (f.id == Drive::stop().id && f.length == 8 && !f.fd && !f.remote) {
      state = robstride_state::reset;
      if (f.data[0] == 1) code = 0;
    } else if (f == Drive::enable()) {
      if (code == 0) state = robstride_state::motor;
    } else if (f == Drive::run_mode(f.data[4])) {
      mode = f.data[4];
    } else {
      return false;
    }
    return true;
  }

  drive_command command{};
  std::int64_t fed = 0;
  std::uint32_t code = 0;
  int asked = 0;
  robstride_state state = robstride_state::reset;
  std::uint8_t mode = operation_control;
};

}  // namespace cca::hardware
