// A virtual moteus: it reacts to frames as the firmware of a real one (moteus.hpp).
//
//   virtual_moteus<moteus<hip_motor, 3>, moteus_timeout::brake> v;      // its servo.timeout_mode
//
// It answers each frame that it understands. When it is stopped, as after a reboot, a set point alone makes
// it move. Position mode follows the command, whose position moves on with its velocity up to the stop
// position; NaN as position means that it stays where it is. The command holds for its own timeout (0: that
// of the drive's type; NaN: for ever). Then comes mode 11, which does what `Then` says:
//   stop            nothing
//   hold            its target slows down from the command's speed to 0 by `Slowing`, in rad/s^2
//                   (servo.default_accel_limit; infinity, as delivered, where none is set: at once), and
//                   stays there, with all of kp and kd. It does not give way: a joint that is held goes on
//                   holding, up to the drive's limit of current
//   zero_velocity   damps
//   brake           shorts its windings, modelled as the same damping
// From there, and from a fault, it does nothing but stop, which clears both. For other numbers that are NaN
// or infinite nothing is documented; here the command is not taken. Not modelled: the modes on the way to
// position mode, limits of torque (servo.timeout_max_torque_Nm among them) and velocity.
// Source: mjbots/moteus, docs/protocol/registers.md, docs/reference/configuration.md (servo.timeout_mode),
// docs/troubleshooting/timeout-mode-11.md; for the target at the timeout: fw/bldc_servo_control.h and
// bldc_servo_position.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <cca/hardware/drives/moteus.hpp>
#include <cca/hardware/virtual_drives/virtual_drive.hpp>

namespace cca::hardware {

enum class moteus_timeout : std::uint8_t { stop = 0, hold = 10, zero_velocity = 12, brake = 15 };

template <class Drive,
          moteus_timeout Then = moteus_timeout::zero_velocity,
          double Slowing = std::numeric_limits<double>::infinity()>
class virtual_moteus : public virtual_troubles {
public:
  using drive = Drive;
  static constexpr std::int64_t timeout = Drive::watchdog.nanoseconds;
  static constexpr bool latches = true, waits = false;

  bool hear(const can_frame& f, std::int64_t now) {
    if (f.id != Drive::request_id) return false;
    advance_to(now);
    typename Drive::request q;
    if (booting() || !Drive::hear(f, q)) return true;
    ++asked;
    if (q.mode == stopped) mode = stopped, code = 0;
    else if (mode == faulted || mode == timed_out) return true;
    else if (q.mode == braking) mode = braking;
    else if (q.mode == positioning) follow(q);
    return true;
  }

  drive_command law(std::int64_t now) {
    advance_to(now);
    switch (mode) {
      case positioning:
        return moved_on(static_cast<double>(now - fed) * 1e-9);
      case braking:
        return {.damping = Drive::motor::damping};
      case timed_out:
        if constexpr (Then == moteus_timeout::hold)
          return held(static_cast<double>(now - fed - holds) * 1e-9);
        return {.damping = Then == moteus_timeout::stop ? 0.0 : Drive::motor::damping};
      default:
        return {};
    }
  }

  drive_frames answer(const drive_motion& m) {
    drive_frames all;
    last = m;
    for (; asked > 0; --asked)
      if (all.size() < 8)
        all.add(Drive::reply(static_cast<std::uint8_t>(mode), m.position, m.velocity, m.torque,
                             static_cast<std::uint8_t>(code)));
    return mute() ? drive_frames() : all;
  }

  bool enabled() const { return mode == positioning; }

  void fail(std::uint32_t fault) { mode = faulted, code = fault; }
  void clear() { silent = false; }  // a fault stays until the drive is stopped
  void reboot(std::int64_t now, std::int64_t duration) {
    boot(now, duration);
    mode = stopped, code = 0, asked = 0, command = {};
  }

private:
  static constexpr int stopped = 0, faulted = 1, positioning = 10, timed_out = 11, braking = 15;
  static constexpr std::int64_t for_ever = std::numeric_limits<std::int64_t>::max();

  void advance_to(std::int64_t now) {
    clock = now;
    if (mode == positioning && now - fed > holds) mode = timed_out;
  }
  // The command this many seconds later: its position moves on with its velocity, and ends at the stop.
  drive_command moved_on(double seconds) const {
    drive_command c = command;
    c.position += c.velocity * seconds;
    if (!(c.velocity > 0 ? c.position >= stop : c.velocity < 0 && c.position <= stop)) return c;
    c.position = stop;
    c.velocity = 0;
    return c;
  }
  // The law of `hold`, this many seconds after the timeout.
  drive_command held(double seconds) const {
    const drive_command last_one = moved_on(static_cast<double>(holds) * 1e-9);
    const double v = last_one.velocity, until_still = std::fabs(v) / Slowing,
                 t = std::min(seconds, until_still);
    drive_command c{.stiffness = Drive::motor::stiffness, .damping = Drive::motor::damping};
    c.position = last_one.position + (t > 0 ? (v - std::copysign(0.5 * Slowing * t, v)) * t : 0);
    c.velocity = t < until_still ? v - std::copysign(Slowing * t, v) : 0;
    return c;
  }
  void follow(const typename Drive::request& q) {
    drive_command c = q.command;
    if (c.position != c.position) c.position = last.position;
    if (c.velocity != c.velocity) c.velocity = 0;
    for (const double number : {c.position, c.velocity, c.torque, c.stiffness, c.damping})
      if (!detail::is_finite(number)) return;
    const double part = std::clamp(c.stiffness, 0.0, 1.0);
    c.stiffness = part * Drive::motor::stiffness;
    c.damping = std::clamp(c.damping, 0.0, part) * Drive::motor::damping;
    command = c;
    stop = q.stop_position;
    mode = positioning;
    fed = clock;
    const double seconds = q.timeout;
    holds = seconds != seconds             ? for_ever
            : seconds > 0 && seconds < 1e6 ? static_cast<std::int64_t>(seconds * 1e9)
                                           : timeout;
  }

  drive_command command{};
  drive_motion last{};
  double stop = std::numeric_limits<double>::quiet_NaN();
  std::int64_t fed = 0, holds = timeout;
  std::uint32_t code = 0;
  int mode = stopped, asked = 0;
};

}  // namespace cca::hardware
