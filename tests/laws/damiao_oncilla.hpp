// An Oncilla on eight Damiao drives, two on each of four buses, whose watchdog runs out after 4 ms: the
// drives of examples/hardware_in_the_loop without its simulator.
#pragma once

#include <cca/hardware/mit.hpp>
#include <cca/hardware/oncilla.hpp>
#include <cca/hardware/virtual_mit.hpp>

namespace damiao {

namespace hw = cca::hardware;
namespace oncilla = cca::robots::oncilla;

struct motor {
  static constexpr std::string_view name = "DM8006";
  static constexpr auto limits =
      cca::limits{cca::angle{-12.5, 12.5}, cca::velocity{-45, 45}, cca::torque{-20, 20},
                  cca::stiffness{0, 500}, cca::damping{0, 5}};
};
inline constexpr hw::joint_servo hip_servo{
    .stiffness = 30, .damping = 0.375, .safe_damping = 1, .most_stiff = 100};
inline constexpr hw::joint_servo knee_servo{.stiffness = 20, .damping = 0.4, .safe_damping = 0.4};

template <class Axis, std::uint32_t Number, std::size_t Bus, hw::joint_servo Servo, hw::mounting Mounting>
using on_bus =
    hw::joint<Axis, hw::mit_drive<motor, Number, 0x10, hw::mit_firmware::damiao>, Mounting, Servo, Bus>;
inline constexpr hw::mounting left{.sign = -1, .offset = 0.1}, right{.offset = -0.1}, knee{.offset = 1};

struct left_front_hip : on_bus<oncilla::left_front_hip, 1, 0, hip_servo, left> {};
struct right_front_hip : on_bus<oncilla::right_front_hip, 2, 1, hip_servo, right> {};
struct left_hind_hip : on_bus<oncilla::left_hind_hip, 3, 2, hip_servo, left> {};
struct right_hind_hip : on_bus<oncilla::right_hind_hip, 4, 3, hip_servo, right> {};
struct left_front_knee : on_bus<oncilla::left_front_knee, 5, 0, knee_servo, knee> {};
struct right_front_knee : on_bus<oncilla::right_front_knee, 6, 1, knee_servo, knee> {};
struct left_hind_knee : on_bus<oncilla::left_hind_knee, 7, 2, knee_servo, knee> {};
struct right_hind_knee : on_bus<oncilla::right_hind_knee, 8, 3, knee_servo, knee> {};
struct board : hw::sensor_board<0x40, 4> {};

using joints = hw::joint_list<left_front_hip,
                              right_front_hip,
                              left_hind_hip,
                              right_hind_hip,
                              left_front_knee,
                              right_front_knee,
                              left_hind_knee,
                              right_hind_knee>;
template <class Bus>
struct robot : hw::oncilla<Bus,
                           left_front_hip,
                           right_front_hip,
                           left_hind_hip,
                           right_hind_hip,
                           left_front_knee,
                           right_front_knee,
                           left_hind_knee,
                           right_hind_knee,
                           board> {};
template <class Drive>
struct virtual_drive : hw::virtual_mit<Drive, 4'000'000> {};

}  // namespace damiao
