// The other side of the bus: drives that are simulated, for tests and for a robot that isn't there.
//
// A virtual drive is what a drive's firmware is between bus and motor:
//   v.hear(frame, now)         takes a frame; true: it was for this drive
//   v.law(now)                 what its motor loop follows now, at its output (drive_command): zero if not enabled, faulted or
//                              unfed for longer than its watchdog allows
//   v.answer(motion)           the frames that it sends in return for what it heard since the last call, or by itself
//   v.go_silent(true), v.fail(code), v.reboot(now, duration), v.clear()   troubles on demand
// Models: virtual_mit.hpp. Times in ns. Nothing is allocated; a copy is a snapshot. docs/hardware.md.
//
// virtual_motor: the plain mechanics of one motor and its load, where no simulator gives them.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>

#include <cca/hardware/drive.hpp>

namespace cca::hardware {

struct drive_motion {
  double position = 0, velocity = 0, torque = 0;  // at the drive's output: rad, rad/s, N m
};

template <class Type>
concept VirtualDrive = std::copyable<Type> && requires(Type& v, const can_frame& f, std::int64_t now, const drive_motion& m) {
  typename Type::drive;
  { v.hear(f, now) } -> std::same_as<bool>;
  { v.law(now) } -> std::same_as<drive_command>;
  { v.answer(m) } -> std::same_as<drive_frames>;
  v.go_silent(true);
  v.fail(std::uint32_t{1});
  v.reboot(now, now);
  v.clear();
};

// inertia a + friction v = torque within its limit, by semi-implicit Euler steps of at most 0.1 ms.
class virtual_motor {
public:
  double inertia = 0.01, friction = 0.02, most_torque = 18;  // kg m^2, N m s/rad, N m
  drive_motion now{};

  void advance(const drive_command& law, double load, double seconds) {
    const int steps = static_cast<int>(std::ceil(seconds / 1e-4));
    const double dt = seconds / steps;
    for (int i = 0; i < steps; ++i) {
      const double wanted =
          law.stiffness * (law.position - now.position) + law.damping * (law.velocity - now.velocity) + law.torque;
      now.torque = wanted < -most_torque ? -most_torque : wanted > most_torque ? most_torque : wanted;
      now.velocity += dt * (now.torque + load - friction * now.velocity) / inertia;
      now.position += dt * now.velocity;
    }
  }
};

}  // namespace cca::hardware
