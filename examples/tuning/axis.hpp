#pragma once
// One axis on a virtual drive, with a PID controller that is to be tuned. docs/tuning.md
#include <cca/cca.hpp>
#include <cca/hardware/virtual_drives/virtual_drive.hpp>
#include <cca/motor.hpp>

namespace tuning {

// [axis]
struct arm : cca::dimension<"arm"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.5, 1.5}, cca::torque{-2, 2}};
};
struct arm_angle : cca::space<cca::joint_angles, cca::axes<arm>, cca::rate<1000>> {};
struct arm_torque : cca::space<cca::joint_torques, cca::axes<arm>, cca::rate<1000>> {};

// The motor of the library's virtual drives, inertia a + friction v = torque, in torque mode.
struct virtual_axis {
  auto sense() -> cca::out<"angle", arm_angle> { return motor.now.position; }
  void act(cca::in<"torque", arm_torque> wanted) { motor.advance({.torque = wanted[arm{}]}, 0, 1e-3); }
  cca::hardware::virtual_motor motor{};  // 0.01 kg m^2, 0.02 N m s/rad
};

struct rest {
  auto process() -> cca::out<"angle", arm_angle> { return 0.5; }
};

struct axis : cca::graph<cca::node<"plan", rest>,
                         cca::node<"servo", cca::pid<arm_angle, arm_torque>>,
                         cca::node<"limits", cca::limiter<arm_torque>>,
                         cca::node<"drive", virtual_axis>,
                         cca::wire<"plan.angle", "servo.reference">,
                         cca::wire<"drive.angle", "servo.measured">,
                         cca::wire<"servo.command", "limits.command">,
                         cca::wire<"limits.safe", "drive.torque">,
                         cca::test_input<"servo.reference", cca::up_to<0.2>>>,  // rad
              cca::recordable {};
// [axis end]

}  // namespace tuning
