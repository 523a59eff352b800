// Virtual drives: they stand for real ones on the other end of the bus, in tests and where there is no robot.
//
// A virtual drive does what a drive's firmware does between bus and motor:
//   v.hear(frame, now)       takes a frame; true: it was for this drive
//   v.law(now)               what its motor loop follows now, at its output (drive_command): no stiffness and
//                            no torque if it is not enabled, faulted, or unfed for longer than `timeout`
//   v.answer(motion)         the frames that it sends now: answers to what it heard since the last call, and
//                            those that it sends by itself
//   v.enabled()              whether it would follow a set point
//   V::timeout, V::latches   its watchdog; true: when that has run out, the drive must be enabled again
//   V::waits                 true: it must be enabled first; false: a set point is enough where it is off, as
//                            after a reboot
//   v.go_silent(true), v.fail(code), v.reboot(now, duration), v.clear()   faults on demand, and their end
// Models: virtual_mit.hpp, virtual_odrive.hpp, virtual_moteus.hpp, virtual_robstride.hpp, virtual_cia402.hpp.
// Laws: tests/laws/virtual_drive_laws.hpp. Times are in ns. Nothing is allocated; a copy is a snapshot.
// docs/drives.md.
//
// virtual_motor: one motor and its load, where no simulator moves the joint.
// virtual_gains: the servo of a drive whose set points have no gains.
// virtual_troubles: the faults that all of them can have.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>

#include <cca/base/math/roots.hpp>
#include <cca/hardware/drives/drive.hpp>

namespace cca::hardware {

struct drive_motion {
  double position = 0, velocity = 0, torque = 0;  // at the drive's output: rad, rad/s, N m
};

template <class Type> concept VirtualDrive =
    std::copyable<Type> && requires(Type& v, const can_frame& f, std::int64_t now, const drive_motion& m) {
      typename Type::drive;
      { v.hear(f, now) } -> std::same_as<bool>;
      { v.law(now) } -> std::same_as<drive_command>;
      { v.answer(m) } -> std::same_as<drive_frames>;
      { v.enabled() } -> std::same_as<bool>;
      { Type::timeout } -> std::convertible_to<std::int64_t>;
      { Type::latches } -> std::convertible_to<bool>;
      { Type::waits } -> std::convertible_to<bool>;
      v.go_silent(true);
      v.fail(std::uint32_t{1});
      v.reboot(now, now);
      v.clear();
    };

struct virtual_gains {
  double stiffness = 20, damping = 0.8;  // N m/rad, N m s/rad
};

// Silent: it works on, and sends nothing. Booting: it neither hears nor sends anything.
class virtual_troubles {
public:
  void go_silent(bool yes) { silent = yes; }

protected:
  bool booting() const { return clock < back; }
  bool mute() const { return silent || booting(); }
  void boot(std::int64_t now, std::int64_t duration) { clock = now, back = now + duration; }

  std::int64_t clock = 0, back = 0;  // the last known time, and the end of the last reboot
  bool silent = false;
};

// inertia a + friction v = torque, which is limited; semi-implicit Euler steps of at most 0.1 ms.
class virtual_motor {
public:
  double inertia = 0.01, friction = 0.02, most_torque = 18;  // kg m^2, N m s/rad, N m
  drive_motion now{};

  void advance(const drive_command& law, double load, double seconds) {
    const int steps = static_cast<int>(math::ceil(seconds / 1e-4));
    const double dt = seconds / steps;
    for (int i = 0; i < steps; ++i) {
      const double wanted = law.stiffness * (law.position - now.position) +
                            law.damping * (law.velocity - now.velocity) + law.torque;
      now.torque = wanted < -most_torque ? -most_torque : wanted > most_torque ? most_torque : wanted;
      now.velocity += dt * (now.torque + load - friction * now.velocity) / inertia;
      now.position += dt * now.velocity;
    }
  }
};

}  // namespace cca::hardware
