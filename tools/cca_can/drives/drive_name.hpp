// The name of a drive on the command line: FAMILY[:RANGES]:NUMBER.
//
//   mit:ak80-9:3              T-Motor / CubeMars AK in MIT mode: ak10-9, ak60-6, ak70-10, ak80-6, ak80-9,
//                             ak80-64
//   mit:12.5/45/20:3          the same with ranges of position (rad), velocity (rad/s) and torque (N m);
//                             then, if they are not 500 and 5, of stiffness and damping
//   damiao:12.5/45/20:3       Damiao
//   mit-original:12.5/45/18:3 the original firmware
//   mit:ak80-9:3@16           an MIT drive that answers under the id 16 instead of 0
//   odrive:3  odrive-0.5:3    ODrive, firmware 0.6 or 0.5; position mode, jog uses torque
//   moteus:80/2:3             moteus, with servo.pid_position.kp and kd in N m/rad and N m s/rad: the drive's
//                             settings, which are for a turn, divided by 2 pi
//   robstride:rs04:3          RobStride, CyberGear: rs01, rs04, cybergear
//   robstride:12.57/20/60/5000/100:3
//                             the same with ranges of position, velocity, torque, stiffness and damping
//   robstride:rs04:3@0        a RobStride that answers to the host 0 instead of 253
//   cia402:4096/0.8:5         CANopen, with counts a turn and rated torque in N m; cyclic position
//   cia402-torque:4096/0.8:5  the same; cyclic torque
#pragma once

#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <vector>

#include <cca/hardware/virtual_cia402.hpp>
#include <cca/hardware/virtual_mit.hpp>
#include <cca/hardware/virtual_moteus.hpp>
#include <cca/hardware/virtual_odrive.hpp>
#include <cca/hardware/virtual_robstride.hpp>

#include "addresses.hpp"
#include "any_drive.hpp"
#include "../words.hpp"

namespace cca_can {

namespace detail {

inline constexpr const char* families =
    "mit:MODEL:NUMBER, damiao:P/V/T:NUMBER, mit-original:P/V/T:NUMBER, odrive:NUMBER, odrive-0.5:NUMBER, "
    "moteus:KP/KD:NUMBER, robstride:MODEL:NUMBER, "
    "cia402:COUNTS/TORQUE:NUMBER, cia402-torque:COUNTS/TORQUE:NUMBER";

template <class Ranges>
drive_scale scale_of() {
  const auto top = []<class Quantity>(Quantity) { return Ranges::limits.template of<Quantity>().upper; };
  return {top(cca::angle()), top(cca::velocity()), top(cca::torque()), top(cca::stiffness()),
          top(cca::damping())};
}

// At the end of its range such a drive stays or begins again, as its firmware does.
inline drive_scale stays_or_wraps(drive_scale s) {
  s.wraps = 2 * s.position;
  s.may_stay = true;
  return s;
}

struct drive_parts {
  std::string family, ranges;
  std::uint32_t number = 0, master = 0;  // master: the id of an MIT drive's answers, or a RobStride's host
};

[[noreturn]] inline void no_drive(const std::string& text, const std::string& why) {
  throw usage_error("`" + text + "` names no drive: " + why);
}

inline std::uint32_t drive_number(const std::string& all, const std::string& text, std::uint32_t most) {
  if (text.empty() || text.size() > 8 ||
      !std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c); }))
    no_drive(all, "`" + text + "` is no number; expected one of " + families);
  const auto n = static_cast<std::uint32_t>(std::stoul(text));
  if (n > most) no_drive(all, "its number is at most " + std::to_string(most));
  return n;
}

inline drive_parts parts_of(const std::string& text) {
  const auto words = split(text, ':');
  if (words.size() < 2 || words.size() > 3) no_drive(text, std::string("expected one of ") + families);
  drive_parts p{.family = words[0], .ranges = words.size() == 3 ? words[1] : ""};
  const auto number = split(words.back(), '@');
  const bool mit = p.family == "mit" || p.family == "mit-original" || p.family == "damiao";
  const bool robstride = p.family == "robstride";
  if (robstride) p.master = robstride_address::unit_host;
  if (number.size() > 2 || (number.size() == 2 && !mit && !robstride))
    no_drive(text, "only MIT drives and RobStrides answer under another id, `@ID`");
  p.number = drive_number(text, number[0], 99'999'999);
  if (number.size() == 2) p.master = drive_number(text, number[1], robstride ? 0xFF : 0x7FF);
  if (p.number != 0 && (mit || robstride) && p.master == p.number)
    no_drive(text, "it can't answer under the id that it listens to");
  return p;
}

// This many numbers, all positive.
inline std::vector<double> numbers_of(const std::string& text,
                                      const std::string& ranges,
                                      std::size_t least,
                                      std::size_t most,
                                      const char* what) {
  std::vector<double> all;
  for (const std::string& each : split(ranges, '/')) {
    const auto n = number_in(each);
    if (!n || !(*n > 0)) no_drive(text, "expected " + std::string(what) + ", got `" + ranges + "`");
    all.push_back(*n);
  }
  if (all.size() < least || all.size() > most)
    no_drive(text, "expected " + std::string(what) + ", got `" + ranges + "`");
  return all;
}

inline drive_scale mit_scale(const std::string& text, const std::string& ranges, bool ak) {
  struct known {
    const char* name;
    drive_scale scale;
  };
  const known models[] = {{"ak10-9", scale_of<hw::ak10_9>()},   {"ak60-6", scale_of<hw::ak60_6>()},
                          {"ak70-10", scale_of<hw::ak70_10>()}, {"ak80-6", scale_of<hw::ak80_6>()},
                          {"ak80-9", scale_of<hw::ak80_9>()},   {"ak80-64", scale_of<hw::ak80_64>()}};
  if (ak)
    for (const known& k : models)
      if (ranges == k.name) return k.scale;
  const auto n =
      numbers_of(text, ranges, 3, 5,
                 ak ? "a model (ak10-9, ak60-6, ak70-10, ak80-6, ak80-9, ak80-64) or ranges as `12.5/50/18`"
                    : "ranges of position, velocity and torque as `12.5/45/20`");
  return {n[0], n[1], n[2], n.size() > 3 ? n[3] : 500, n.size() > 4 ? n[4] : 5};
}

inline drive_scale robstride_scale(const std::string& text, const std::string& ranges) {
  if (ranges == "rs01") return scale_of<hw::rs01>();
  if (ranges == "rs04") return scale_of<hw::rs04>();
  if (ranges == "cybergear") return scale_of<hw::cybergear>();
  const auto n = numbers_of(text, ranges, 5, 5,
                            "a model (rs01, rs04, cybergear) or ranges of position, velocity, torque, "
                            "stiffness and damping as `12.57/20/60/5000/100`");
  return {n[0], n[1], n[2], n[3], n[4]};
}

template <class Address>
void check_number(const std::string& text, std::uint32_t number) {
  if (number < Address::least_number)
    no_drive(text, "its number is at least " + std::to_string(Address::least_number));
  if (number > Address::most_number)
    no_drive(text, "its number is at most " + std::to_string(Address::most_number));
}

// Calls f(type of drive, address, scale), with f.template operator()<Drive>(address, scale).
template <class F>
auto with_drive(const std::string& text, bool ranges_needed, bool by_torque, F&& f) {
  const drive_parts p = parts_of(text);
  const auto give = [&]<class Drive, class Address>(const Address& at, const drive_scale& s) {
    check_number<Address>(text, p.number);
    return f.template operator()<Drive>(at, s);
  };
  const auto ranges = [&](const char* what) {
    if (p.ranges.empty() && ranges_needed)
      no_drive(text, std::string("it needs ") + what + ", which no frame reports: " + p.family +
                         ":RANGES:" + std::to_string(p.number));
    return !p.ranges.empty();
  };
  const auto mit = [&]<hw::mit_firmware Firmware>() {
    const drive_scale s = ranges("the ranges of its firmware")
                              ? mit_scale(text, p.ranges, Firmware == hw::mit_firmware::ak)
                              : drive_scale{12.5};
    return give.template operator()<unit_mit<Firmware>>(mit_address<Firmware>{p.number, p.master},
                                                        stays_or_wraps(s));
  };
  if (p.family == "mit") return mit.template operator()<hw::mit_firmware::ak>();
  if (p.family == "mit-original") return mit.template operator()<hw::mit_firmware::original>();
  if (p.family == "damiao") return mit.template operator()<hw::mit_firmware::damiao>();
  if (p.family == "moteus") {
    drive_scale s;
    if (ranges("its kp and kd")) {
      const auto n = numbers_of(text, p.ranges, 2, 2, "kp and kd as `80/2`");
      s.stiffness = n[0], s.damping = n[1];
    }
    return give.template operator()<unit_moteus>(moteus_address{p.number}, s);
  }
  if (p.family == "robstride") {
    const drive_scale s =
        ranges("the ranges of its model") ? robstride_scale(text, p.ranges) : drive_scale{12.57};
    return give.template operator()<unit_robstride>(robstride_address{p.number, p.master}, stays_or_wraps(s));
  }
  if (p.family == "cia402" || p.family == "cia402-torque") {
    drive_scale s;
    if (ranges("its counts a turn and its rated torque")) {
      const auto n = numbers_of(text, p.ranges, 2, 2, "counts a turn and rated torque as `4096/0.8`");
      s.position = s.velocity = hw::detail::radians_in_turn / n[0], s.torque = n[1];
      s.wraps = 4294967296.0 * s.position;  // it counts in 32 bits
    }
    if (p.family == "cia402") return give.template operator()<unit_cia402>(cia402_address{p.number}, s);
    return give.template operator()<unit_cia402_torque>(cia402_address{p.number}, s);
  }
  if (!p.ranges.empty() && p.family.starts_with("odrive"))
    no_drive(text, "an ODrive has no ranges; write " + p.family + ":NUMBER");
  const auto odrive = [&]<hw::odrive_firmware Firmware>() {
    if (!hw::detail::is_odrive_node(p.number, Firmware))
      no_drive(text, "with firmware 0.6 node 63 means `not addressed`: such a drive takes no command");
    const odrive_address at{p.number};
    if (by_torque)
      return give.template operator()<hw::odrive<1, hw::odrive_mode::torque, Firmware>>(at, drive_scale{});
    return give.template operator()<hw::odrive<1, hw::odrive_mode::position, Firmware>>(at, drive_scale{});
  };
  if (p.family == "odrive") return odrive.template operator()<hw::odrive_firmware::v0_6>();
  if (p.family == "odrive-0.5") return odrive.template operator()<hw::odrive_firmware::v0_5>();
  no_drive(text, "there is no family `" + p.family + "`; expected one of " + families);
}

}  // namespace detail

// Without ranges it can only be asked whether it is there. `to_jog`: in torque mode, if the drive has one.
inline std::unique_ptr<any_drive> drive_named(const std::string& text,
                                              bool ranges_needed = true,
                                              bool to_jog = false) {
  auto drive = detail::with_drive(
      text, ranges_needed, to_jog, [&]<class Drive>(const auto& address, const drive_scale& s) {
        return std::unique_ptr<any_drive>(
            std::make_unique<drive_at<Drive, std::decay_t<decltype(address)>>>(address, s));
      });
  drive->text = text;
  drive->scaled = ranges_needed;
  return drive;
}

namespace detail {

inline constexpr std::int64_t watchdog =
    100'000'000;  // ns: what one should set; a moteus gets its timeout with each command

template <class Drive>
struct played;
template <hw::MitRanges Ranges, std::uint32_t Number, std::uint32_t Master, hw::mit_firmware Firmware>
struct played<hw::mit_drive<Ranges, Number, Master, Firmware>> {
  using type = hw::virtual_mit<hw::mit_drive<Ranges, Number, Master, Firmware>, watchdog>;
};
template <std::uint32_t Node, hw::odrive_mode Mode, hw::odrive_firmware Firmware, std::int64_t Period>
struct played<hw::odrive<Node, Mode, Firmware, Period>> {
  using type = hw::virtual_odrive<hw::odrive<Node, Mode, Firmware, Period>, watchdog>;
};
template <class Motor, std::uint8_t Servo, std::uint8_t Source, std::uint16_t Prefix>
struct played<hw::moteus<Motor, Servo, Source, Prefix>> {
  using type = hw::virtual_moteus<hw::moteus<Motor, Servo, Source, Prefix>>;
};
template <hw::MitRanges Ranges, std::uint8_t Number, std::uint8_t Host>
struct played<hw::robstride<Ranges, Number, Host>> {
  using type = hw::virtual_robstride<hw::robstride<Ranges, Number, Host>, watchdog>;
};
template <class Motor, std::uint8_t Node, hw::cia402_mode Mode>
struct played<hw::cia402<Motor, Node, Mode>> {
  using type = hw::virtual_cia402<hw::cia402<Motor, Node, Mode>, watchdog>;
};

}  // namespace detail

// A drive that is played, with its watchdog set.
inline std::unique_ptr<any_virtual> virtual_named(const std::string& text) {
  return detail::with_drive(text, true, false, [&]<class Drive>(const auto& address, const drive_scale& s) {
    using drive = typename detail::played<Drive>::type;
    return std::unique_ptr<any_virtual>(
        std::make_unique<virtual_at<drive, std::decay_t<decltype(address)>>>(address, s));
  });
}

}  // namespace cca_can
