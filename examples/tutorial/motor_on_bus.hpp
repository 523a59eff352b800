// Tutorial, step 9: a motor behind a CAN bus as a resource node. docs/tutorial/9_drives.md
#pragma once

#include <array>

#include <cca/hardware/can_bus.hpp>
#include <cca/hardware/mit.hpp>

#include "leg_spaces.hpp"

struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

// [node]
using hip_drive = cca::hardware::mit_drive<cca::hardware::ak80_9, 3>;  // an AK80-9 with id 3

// The hip's motor on any CAN bus.
//
//   out angle    hip_angle  rad; nothing until the drive has reported
//   in  command  hip_angle  rad
template <cca::hardware::CanBus Bus>
struct motor_on_bus {
  auto sense() -> cca::maybe<"angle", hip_angle> {
    std::array<cca::hardware::received_frame, 8> inbox;
    const std::size_t count = bus->receive(inbox);
    for (std::size_t i = 0; i < count; ++i) hip_drive::decode(inbox[i].frame, report);
    if (report.frames == 0) return {};
    return report.position;
  }

  void act(cca::in<"command", hip_angle> command) {
    if (!enabled) {
      const cca::hardware::enable_step step = enabling.next(report);
      bus->send(step.frames);
      enabled = step.progress == cca::hardware::enable_progress::done;
    } else {
      bus->send(hip_drive::set_point({.position = command[hip{}], .stiffness = 40, .damping = 1}).frames);
    }
  }

  void on_start() { enabled = false, enabling = {}, report = {}; }
  void on_stop() { bus->send(hip_drive::disable()); }
  void on_fault() { bus->send(hip_drive::disable()); }

  Bus* bus = nullptr;
  bool enabled = false;
  hip_drive::enabling enabling;
  cca::hardware::drive_report report;
};
// [node end]
