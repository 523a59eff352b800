#pragma once
// The Oncilla on eight Damiao DM8006 drives, which use the MIT protocol: the drive, bus and mounting of each
// joint. For another robot, write another file like this one.
//
// The watchdog of these drives latches a fault, so a delayed set-point moves nothing. They answer under ids
// above those of the set-points: frames are sent once, without retries, so an answer that wins arbitration
// against a set-point would destroy it.
//
// Four classic buses of 1 Mbit/s, one per leg, for 1 kHz: a bus has room for two such drives and no more. The
// sensor board is on a fifth bus.
#include <cca/hardware/mit.hpp>
#include <cca/hardware/oncilla.hpp>
#include <cca/hardware/virtual_mit.hpp>
#include <cca/hardware/virtual_robot.hpp>

namespace hil {

namespace hw = cca::hardware;
namespace robots = cca::robots;

// The servo gains are those of the simulator. Left hips are mounted the other way round; all have offsets.
inline constexpr hw::joint_servo hip_servo{
    .stiffness = 30, .damping = 0.375, .safe_damping = 1, .most_stiff = robots::oncilla::body.stiffest_hip};
inline constexpr hw::joint_servo knee_servo{
    .stiffness = 80, .damping = 0.4, .safe_damping = 0.4, .most_stiff = 100};
inline constexpr hw::mounting left_hip{.sign = -1, .offset = 0.1}, right_hip{.offset = -0.1},
    knee{.offset = 1.0};

// [joints]
struct dm8006 {  // the ranges that are set in the drives' registers
  static constexpr std::string_view name = "DM8006";
  static constexpr auto limits =
      cca::limits{cca::angle{-12.5, 12.5}, cca::velocity{-45, 45}, cca::torque{-20, 20},
                  cca::stiffness{0, 500}, cca::damping{0, 5}};
};
constexpr std::uint32_t answers = 0x10;  // their master id: above all set-points
template <class Axis, std::uint32_t Number, hw::mounting Mounting, hw::joint_servo Servo, std::size_t Bus>
using leg_joint =
    hw::joint<Axis, hw::mit_drive<dm8006, Number, answers, hw::mit_firmware::damiao>, Mounting, Servo, Bus>;

struct left_front_hip : leg_joint<robots::oncilla::left_front_hip, 1, left_hip, hip_servo, 0> {};
struct right_front_hip : leg_joint<robots::oncilla::right_front_hip, 2, right_hip, hip_servo, 1> {};
struct left_hind_hip : leg_joint<robots::oncilla::left_hind_hip, 3, left_hip, hip_servo, 2> {};
struct right_hind_hip : leg_joint<robots::oncilla::right_hind_hip, 4, right_hip, hip_servo, 3> {};
struct left_front_knee : leg_joint<robots::oncilla::left_front_knee, 5, knee, knee_servo, 0> {};
struct right_front_knee : leg_joint<robots::oncilla::right_front_knee, 6, knee, knee_servo, 1> {};
struct left_hind_knee : leg_joint<robots::oncilla::left_hind_knee, 7, knee, knee_servo, 2> {};
struct right_hind_knee : leg_joint<robots::oncilla::right_hind_knee, 8, knee, knee_servo, 3> {};
struct board : hw::sensor_board<0x40, 4> {};  // ids 0x40 to 0x45, on bus 4
// [joints end]

// The robot on a kind of bus. [robot]
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
// [robot end]
inline constexpr std::size_t buses = 5;

// The virtual drives: their firmware stops after 4 ms without a set-point.
template <class Drive>
struct virtual_damiao : hw::virtual_mit<Drive, 4'000'000> {};
template <class Bus>
using far_side = hw::virtual_robot<Bus, virtual_damiao, board, joints>;

}  // namespace hil
