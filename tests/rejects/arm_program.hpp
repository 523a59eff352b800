// A program that runs the arm on drives, as a user writes it.
#pragma once

#include <cca/cca.hpp>
#include <cca/hardware/robot/shut_down.hpp>
#include <cca/main.hpp>

#include "arm_on_drives.hpp"

struct arm : described_arm {};
using arm_torques = cca::robots::commanded<arm, cca::robots::torque_command>;

struct pull {
  auto process(cca::beat) -> cca::out<"torques", arm_torques> { return arm_torques::vector_type{1, 0}; }
};

template <class Robot>
struct pulled : cca::graph<cca::node<"pull", pull>,
                           cca::node<"limits", cca::limiter<arm_torques>>,
                           cca::node<"robot", Robot>,
                           cca::wire<"pull.torques", "limits.command">,
                           cca::wire<"limits.safe", "robot.torque">> {};

template <class Architecture>
struct arm_program : cca::robot_program<Architecture> {
  using controller_type = typename cca::robot_program<Architecture>::controller_type;

  arm_program() { this->purpose = "pulls the arm up"; }
  void prepare(controller_type& c) override { c.template get<"robot.synchronizer">().connect(near); }
  bool between(controller_type& c) override {
    return c.template get<"robot.synchronizer">().phase() != cca::hardware::motion_phase::stopped &&
           !c.template get<"robot.emergency_stop">().cause();
  }
  void stop(controller_type& c) override { cca::hardware::shut_down(c); }

  cca::hardware::memory_bus<3, 16> wire{};
  bus near = wire.end(0);
};
