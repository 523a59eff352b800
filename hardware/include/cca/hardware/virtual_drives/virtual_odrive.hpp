// A virtual ODrive: it reacts to frames as the firmware of a real one (odrive.hpp).
//
//   virtual_odrive<odrive<3, odrive_mode::position>, 50'000'000> v;   // enable_watchdog, watchdog_timeout:
//                                                                     50 ms
//
// It sends by itself: a heartbeat each `Heartbeat`, its estimates and torques with the periods that the
// drive's type states. It moves only in closed loop, by the mode that was set: position (from where it is,
// with the gains `Gains`), velocity, torque. Unfed for `Timeout` it goes idle with the error of its watchdog.
// An error keeps it from closed loop until it is cleared; then closed loop must be requested again. 0.6 is
// fed by set points and state requests; 0.5 by each frame to its node, and its watchdog also runs out while
// it is idle. NaN and infinity: it goes idle with an error (0.6 missing input, 0.5 controller failed); what
// the real one does is not published. A reboot forgets mode and inputs. Not modelled: the integrator, limits
// of its own. Source: odriverobotics/ODrive, Firmware/communication/can/can_simple.cpp,
// Firmware/MotorControl/{axis,controller}.cpp (0.5); for 0.6 its documentation alone.
#pragma once

#include <cstdint>

#include <cca/hardware/drives/odrive.hpp>
#include <cca/hardware/virtual_drives/virtual_drive.hpp>

namespace cca::hardware {

template <class Drive,
          std::int64_t Timeout = 100'000'000,
          virtual_gains Gains = virtual_gains{},
          std::int64_t Heartbeat = 100'000'000>
class virtual_odrive : public virtual_troubles {
public:
  using drive = Drive;
  static constexpr std::int64_t timeout = Timeout;
  static constexpr bool latches = true, waits = true;

  bool hear(const can_frame& f, std::int64_t now) {
    const can_id first = Drive::id(odrive_command{});
    if (f.fd || f.remote || f.id.extended != first.extended || f.id.number >> 5 != first.number >> 5)
      return false;
    advance_to(now);
    if (booting()) return true;
    if (!Drive::is_0_6) fed = now;
    if (f == Drive::estop()) error(Drive::is_0_6 ? 0x02000000 : 0x4000);
    if (f == Drive::clear_errors()) code = 0;
    if (f.id == Drive::id(odrive_command::set_axis_state) && f.length >= 4)
      fed = now, request_state(detail::got<std::uint32_t>(f.payload(), 0));
    if (f.id == Drive::id(odrive_command::set_controller_mode) && f.length == 8)
      mode = static_cast<odrive_mode>(detail::got<std::uint32_t>(f.payload(), 0));
    drive_command c;
    if (by<odrive_mode::position>::hear(f, c)) set_input(c);
    if (by<odrive_mode::velocity>::hear(f, c))
      set_input({.position = input.position, .velocity = c.velocity, .torque = c.torque});
    if (by<odrive_mode::torque>::hear(f, c))
      set_input({.position = input.position, .velocity = input.velocity, .torque = c.torque});
    return true;
  }

  drive_command law(std::int64_t now) {
    advance_to(now);
    if (!closed) return {};
    switch (mode) {
      case odrive_mode::torque:
        return {.torque = input.torque};
      case odrive_mode::velocity:
        return {.velocity = input.velocity, .torque = input.torque, .damping = Gains.damping};
      case odrive_mode::position:
        return {input.position, input.velocity, input.torque, Gains.stiffness, Gains.damping};
    }
    return {};
  }

  drive_frames answer(const drive_motion& m) {
    drive_frames all;
    last = m;
    if (mute()) return all;
    if (due(heartbeat, Heartbeat)) all.add(Drive::heartbeat(closed ? 8 : 1, code));
    if (due(estimates, Drive::report_period)) all.add(Drive::estimates(m.position, m.velocity));
    if constexpr (requires { Drive::torque_period; })
      if (due(torques, Drive::torque_period)) all.add(Drive::torques(m.torque));
    return all;
  }

  bool enabled() const { return closed; }

  void fail(std::uint32_t errors) { error(errors); }
  void clear() { silent = false, code = 0; }
  void reboot(std::int64_t now, std::int64_t duration) {
    boot(now, duration);
    closed = false, code = 0, input = {}, mode = odrive_mode::position;
    fed = back, heartbeat = estimates = torques = never;
  }

private:
  template <odrive_mode Mode>
  using by = odrive<Drive::node, Mode, Drive::firmware>;
  static constexpr std::int64_t never = -1'000'000'000'000;
  static constexpr std::uint32_t unfed_too_long = Drive::is_0_6 ? 0x01000000 : 0x800,
                                 no_number = Drive::is_0_6 ? 0x40 : 0x200;

  void advance_to(std::int64_t now) {
    clock = now;
    if ((closed || !Drive::is_0_6) && now - fed > Timeout) error(unfed_too_long);
  }
  void error(std::uint32_t errors) { code |= errors, closed = false; }
  void request_state(std::uint32_t state) {
    const bool known = mode >= odrive_mode::torque && mode <= odrive_mode::position;
    const bool was = closed;
    closed = state == 8 && code == 0 && known;
    if (!closed || was) return;
    fed = clock;
    input.position = last.position;  // position control begins where the drive is
  }
  void set_input(const drive_command& c) {
    fed = clock;
    if (!detail::is_finite(c.position) || !detail::is_finite(c.velocity) || !detail::is_finite(c.torque))
      return error(no_number);
    input = c;
  }
  bool due(std::int64_t& at, std::int64_t period) const {
    if (clock - at < period) return false;
    at = clock;
    return true;
  }

  drive_command input{};
  drive_motion last{};
  std::int64_t fed = 0, heartbeat = never, estimates = never, torques = never;
  std::uint32_t code = 0;
  odrive_mode mode = odrive_mode::position;
  bool closed = false;
};

}  // namespace cca::hardware
