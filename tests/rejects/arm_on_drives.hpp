// The arm of arm.hpp as a robot, and the drives of its joints.
#pragma once

#include <cca/hardware/cia402.hpp>
#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/robot/robot.hpp>

#include "arm.hpp"

struct arm_body : cca::body<mount, cca::part<"arm", chain, cca::driven_by<"shoulder", "elbow">>> {};

struct described_arm {
  using body = arm_body;
  using rate = cca::rate<1000>;
  using commands = cca::robots::commands<cca::robots::torque_command>;
  static constexpr std::array<cca::robots::joint_drive, 2> drives{};
};

struct motor {
  static constexpr std::string_view name = "motor";
  static constexpr double counts = 4096, torque = 0.05;
};
template <class Axis, unsigned Node>
struct driven : cca::hardware::joint<Axis,
                                     cca::hardware::cia402<motor, Node, cca::hardware::cia402_mode::torque>,
                                     cca::hardware::mounting{.gear = 40},
                                     cca::hardware::joint_servo{.stiffness = 20}> {};
struct upper : driven<shoulder, 1> {};
struct lower : driven<elbow, 2> {};
using bus = cca::hardware::memory_bus<3, 16>::end_type;
