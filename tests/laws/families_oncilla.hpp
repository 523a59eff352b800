// An Oncilla whose joints have drives of all families, in all their modes. A new family takes
// `left_hind_knee`: the other MIT drive stays, and other robots of the tests are on AKs alone. What is tested
// of a single joint (families.cpp) are hips, and knees of bus 2.
#pragma once

#include <cstdint>
#include <string_view>

#include <cca/hardware/oncilla.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>

namespace families {

namespace hw = cca::hardware;
namespace oncilla = cca::robots::oncilla;

struct n1 {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.02;
};
struct epos {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 65536, torque = 2;
};
inline constexpr hw::joint_servo servo{.stiffness = 20, .damping = 0.5};
inline constexpr hw::mounting straight{}, turned{.gear = 2, .sign = -1, .offset = 0.3};

// `Fault`: a code for the drive's `fail`.
template <class Axis, class Drive, std::size_t Bus, std::uint32_t Fault, hw::mounting Mounting = straight>
struct on_bus : hw::joint<Axis, Drive, Mounting, servo, Bus> {
  static constexpr std::uint32_t fault = Fault;
};
template <std::uint32_t Node, hw::odrive_mode Mode>
using odrive = hw::odrive<Node, Mode, hw::odrive_firmware::v0_6, 1'000'000>;
template <std::uint8_t Node, hw::cia402_mode Mode>
using canopen = hw::cia402<epos, Node, Mode>;
using ak = hw::mit_drive<hw::ak60_6, 1>;
using damiao = hw::mit_drive<hw::ak60_6, 2, 0, hw::mit_firmware::damiao>;

struct left_front_hip : on_bus<oncilla::left_front_hip, hw::moteus<n1, 1>, 0, 38, turned> {};
struct right_front_hip : on_bus<oncilla::right_front_hip, hw::robstride<hw::rs01, 1>, 5, 4> {};
struct left_hind_hip : on_bus<oncilla::left_hind_hip, odrive<1, hw::odrive_mode::position>, 1, 0x1000> {};
struct right_hind_hip
    : on_bus<oncilla::right_hind_hip, odrive<2, hw::odrive_mode::torque>, 1, 0x1000, turned> {};
struct left_front_knee : on_bus<oncilla::left_front_knee, canopen<1, hw::cia402_mode::position>, 2, 0x2310> {
};
struct right_front_knee : on_bus<oncilla::right_front_knee, canopen<2, hw::cia402_mode::torque>, 2, 0x2310> {
};
struct left_hind_knee : on_bus<oncilla::left_hind_knee, ak, 3, 2> {};
struct right_hind_knee : on_bus<oncilla::right_hind_knee, damiao, 3, 0xB> {};
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
struct robot : hw::oncilla<Bus, joints, board> {};

}  // namespace families
