#pragma once
// The same robot with one drive of another family: the left hind knee has a CANopen drive in its position
// mode. It reports its velocity in a frame of its own, TPDO2, which can be missing while all else works.
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/virtual_cia402.hpp>

#include "campaign.hpp"

namespace hil::with_canopen {

struct servo_drive {
  static constexpr std::string_view name = "CANopen servo";
  static constexpr double counts = 65536, torque = 10;
};
struct left_hind_knee : hw::joint<robots::oncilla::left_hind_knee,
                                  hw::cia402<servo_drive, 1, hw::cia402_mode::position>,
                                  knee,
                                  knee_servo,
                                  2> {};

using joints = hw::joint_list<left_front_hip,
                              right_front_hip,
                              left_hind_hip,
                              right_hind_hip,
                              left_front_knee,
                              right_front_knee,
                              left_hind_knee,
                              right_hind_knee>;
template <class Bus>
struct oncilla : hw::oncilla<Bus, joints, board> {};

template <class Drive>
struct virtual_drive : hil::virtual_damiao<Drive> {};
template <>
struct virtual_drive<left_hind_knee::drive>
    : hw::virtual_cia402<left_hind_knee::drive,
                         20'000'000,
                         hw::cia402_lost::fault,
                         hw::virtual_gains{knee_servo.stiffness, knee_servo.damping}> {};

template <class Delay>
struct limited : sabotaged<cca::limiter<robots::oncilla::leg_angles>, Delay, oncilla<memory_end>> {};
template <class Delay>
using run_type = in_memory<limited<Delay>,
                           cca::controller<limited<Delay>>,
                           memory_buses_of<oncilla<memory_end>, virtual_drive>>;

}  // namespace hil::with_canopen
