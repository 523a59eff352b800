#pragma once
// The arm on two kinds of drives: which drive moves each joint, its bus, its mounting. For another arm, write
// another file like this one.
//
// Seven drives at 1 kHz need four buses: two on each of the first three, the last one and the flange's force
// sensor on the fourth. The force sensor comes by a board on that bus. Gears, offsets and signs are CHOSEN.
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>

#include "spaces.hpp"

namespace touch {

namespace hw = cca::hardware;

// After a stop a joint sinks against its `safe_damping`. Where the drive takes torque alone that is a loop
// over the bus, so the light joints of the wrist have little of it.
inline constexpr hw::joint_servo large_servo{
    .stiffness = 600, .damping = 50, .safe_damping = 40, .most_stiff = 3000, .most_damping = 250};
inline constexpr hw::joint_servo small_servo{
    .stiffness = 100, .damping = 2, .safe_damping = 1, .most_stiff = 300, .most_damping = 6};

// CANopen drives in cyclic synchronous torque, a gear of 100 behind each motor.
namespace on_canopen {

// [joints]
struct large {
  static constexpr std::string_view name = "CANopen drive, large";
  static constexpr double counts = 16384, torque = 0.3;  // of the motor: counts a turn, rated torque in N m
};
struct small {
  static constexpr std::string_view name = "CANopen drive, small";
  static constexpr double counts = 16384, torque = 0.05;
};
template <class Axis, class Motor, std::uint8_t Node, std::size_t Bus, int Sign, double Offset>
using on_bus = hw::joint<Axis,
                         hw::cia402<Motor, Node, hw::cia402_mode::torque>,
                         hw::mounting{.gear = 100, .sign = double(Sign), .offset = Offset},
                         std::is_same_v<Motor, large> ? large_servo : small_servo,
                         Bus>;

struct a1 : on_bus<arm::a1, large, 1, 0, 1, 0.0> {};
struct a2 : on_bus<arm::a2, large, 2, 0, -1, 0.1> {};
struct a3 : on_bus<arm::a3, large, 3, 1, 1, -0.2> {};
struct a4 : on_bus<arm::a4, large, 4, 1, -1, -1.5> {};
struct a5 : on_bus<arm::a5, small, 5, 2, 1, 0.0> {};
struct a6 : on_bus<arm::a6, small, 6, 2, -1, 1.8> {};
struct a7 : on_bus<arm::a7, small, 7, 3, 1, 0.3> {};
struct board : hw::load_board<0x40, 1, 3> {};  // ids 0x40 and 0x41, on bus 3

using joints = hw::joint_list<a1, a2, a3, a4, a5, a6, a7>;
template <class Bus>
struct robot : hw::robot<arm::description, Bus, joints, board> {};
// [joints end]

}  // namespace on_canopen

// moteus controllers, which also take stiffness and damping.
namespace on_moteus {

struct large {
  static constexpr std::string_view name = "moteus, large";
  static constexpr double stiffness = 3000, damping = 250, torque = 87, timeout = 0.02;
};
struct small {
  static constexpr std::string_view name = "moteus, small";
  static constexpr double stiffness = 300, damping = 6, torque = 12, timeout = 0.02;
};
template <class Axis, class Motor, std::uint8_t Servo, std::size_t Bus, int Sign, double Offset>
using on_bus = hw::joint<Axis,
                         hw::moteus<Motor, Servo>,
                         hw::mounting{.sign = double(Sign), .offset = Offset},
                         std::is_same_v<Motor, large> ? large_servo : small_servo,
                         Bus>;

struct a1 : on_bus<arm::a1, large, 1, 0, 1, 0.0> {};
struct a2 : on_bus<arm::a2, large, 2, 0, -1, 0.1> {};
struct a3 : on_bus<arm::a3, large, 3, 1, 1, -0.2> {};
struct a4 : on_bus<arm::a4, large, 4, 1, -1, -1.5> {};
struct a5 : on_bus<arm::a5, small, 5, 2, 1, 0.0> {};
struct a6 : on_bus<arm::a6, small, 6, 2, -1, 1.8> {};
struct a7 : on_bus<arm::a7, small, 7, 3, 1, 0.3> {};
struct board : hw::load_board<0x40, 1, 3> {};

using joints = hw::joint_list<a1, a2, a3, a4, a5, a6, a7>;
template <class Bus>
struct robot : hw::robot<arm::description, Bus, joints, board> {};

}  // namespace on_moteus

}  // namespace touch
