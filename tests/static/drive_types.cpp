// The types that describe a motor to its family of drives, and the numbers of those that are there, as
// docs/drives.md shows them.
#include <string_view>

#include <cca/cca.hpp>
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/odrive.hpp>
#include <cca/hardware/robstride.hpp>

namespace {

namespace hw = cca::hardware;

template <class Ranges>
constexpr bool has_ranges(
    double position, double speed, double torque, double most_stiffness, double most_damping) {
  constexpr auto all = Ranges::limits;
  const auto both = [](auto range, double end) { return range.lower == -end && range.upper == end; };
  const auto from_zero = [](auto range, double end) { return range.lower == 0 && range.upper == end; };
  return both(all.template of<cca::angle>(), position) && both(all.template of<cca::velocity>(), speed) &&
         both(all.template of<cca::torque>(), torque) &&
         from_zero(all.template of<cca::stiffness>(), most_stiffness) &&
         from_zero(all.template of<cca::damping>(), most_damping);
}

// [ranges]
// position +-rad, velocity +-rad/s, torque +-N m, stiffness N m/rad, damping N m s/rad
static_assert(has_ranges<hw::ak10_9>(12.5, 50, 65, 500, 5));
static_assert(has_ranges<hw::ak60_6>(12.5, 45, 15, 500, 5));
static_assert(has_ranges<hw::ak70_10>(12.5, 50, 25, 500, 5));
static_assert(has_ranges<hw::ak80_6>(12.5, 76, 12, 500, 5));
static_assert(has_ranges<hw::ak80_9>(12.5, 50, 18, 500, 5));
static_assert(has_ranges<hw::ak80_64>(12.5, 8, 144, 500, 5));
static_assert(has_ranges<hw::rs01>(12.5, 44, 17, 500, 5));
static_assert(has_ranges<hw::rs04>(12.57, 15, 120, 5000, 100));
static_assert(has_ranges<hw::cybergear>(4 * cca::pi, 30, 12, 500, 5));
// [ranges end]

// [own]
struct ak80_9_with_1_1 {  // MIT, RobStride: the ranges of its firmware
  static constexpr std::string_view name = "AK80-9, firmware 1.1";
  static constexpr auto limits =
      cca::limits{cca::angle{-12.5, 12.5}, cca::velocity{-22.5, 22.5}, cca::torque{-18, 18},
                  cca::stiffness{0, 500}, cca::damping{0, 5}};
};
struct hip_motor {  // moteus: its settings, with kp = 500 and kd = 12.5 for each turn
  static constexpr std::string_view name = "hip motor";
  static constexpr double stiffness = 500 / (2 * cca::pi),  // N m/rad: servo.pid_position.kp
      damping = 12.5 / (2 * cca::pi),                       // N m s/rad: servo.pid_position.kd
      torque = 12,                                          // N m, the most that it may use
      timeout = 0.02;                                       // s, that a command holds
};
struct knee_motor {  // CiA 402
  static constexpr std::string_view name = "knee motor";
  static constexpr double counts = 4096,  // a turn of its shaft
      torque = 0.8;                       // N m, rated: object 6076h
};

using number_1 = hw::mit_drive<ak80_9_with_1_1, 1>;                                  // T-Motor AK
using number_2 = hw::mit_drive<ak80_9_with_1_1, 2, 0x10, hw::mit_firmware::damiao>;  // answers under id 0x10
using number_3 = hw::robstride<hw::rs04, 3>;
using number_4 = hw::moteus<hip_motor, 4>;
using number_5 = hw::cia402<knee_motor, 5, hw::cia402_mode::torque>;
using number_6 = hw::odrive<6, hw::odrive_mode::torque>;  // firmware 0.6; it needs no type of a motor
// [own end]

static_assert(number_1::reply_id == hw::standard(0) && number_2::reply_id == hw::standard(0x10));
static_assert(hw::Drive<number_1> && hw::Drive<number_2> && hw::Drive<number_3> && hw::Drive<number_4> &&
              hw::Drive<number_5> && hw::Drive<number_6>);
static_assert(number_1::name == ak80_9_with_1_1::name && number_4::name == hip_motor::name &&
              number_5::name == knee_motor::name);
static_assert(number_4::watchdog.nanoseconds == 20'000'000 && number_5::least_torque == 0.8 / 1000);

}  // namespace
