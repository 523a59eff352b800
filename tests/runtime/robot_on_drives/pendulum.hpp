#pragma once
// A pendulum on one CiA 402 drive in torque mode: its body, its joint and its bus.
#include <array>
#include <string_view>

#include <cca/cca.hpp>
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/joint.hpp>
#include <cca/hardware/memory_bus.hpp>
#include <cca/robot/body.hpp>

namespace pendulum_test {

namespace hw = cca::hardware;

struct swing : cca::dimension<"swing"> {
  static constexpr auto limits =
      cca::limits{cca::angle{-2, 2},  cca::velocity{-8, 8},        cca::acceleration{-200, 200},
                  cca::torque{-3, 3}, cca::torque_rate{-600, 600}, cca::stiffness{0, 50},
                  cca::damping{0, 2}};
};
struct stand : cca::frame<"stand"> {};
struct bob : cca::frame<"bob"> {};
struct chain : cca::serial_chain<stand, bob, cca::axes<swing>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0, -0.3);
  static constexpr std::array links{cca::link_inertia{0.5, {0, 0, -0.2}, {0.001, 0.001, 0.001, 0, 0, 0}}};
};
struct pendulum_body : cca::body<stand, cca::part<"rod", chain, cca::driven_by<"swing">>> {};

// [joint]
struct geared_motor {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 4096, torque = 0.05;  // rated, at the motor
};
struct swing_joint : hw::joint<swing,
                               hw::cia402<geared_motor, 1, hw::cia402_mode::torque>,
                               hw::mounting{.gear = 40, .sign = -1, .offset = 0.2},
                               hw::joint_servo{.stiffness = 20, .damping = 0.6, .safe_damping = 0.5}> {};
// [joint end]

using wire = hw::memory_bus<3, 16>;
using end_of_wire = wire::end_type;

}  // namespace pendulum_test
