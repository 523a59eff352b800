// Drives by name send and decode the same frames as the codecs with that number and those ranges.
#include <array>
#include <random>

#include <doctest/doctest.h>

#include <cca/hardware/mit.hpp>
#include <cca/hardware/robstride.hpp>

#include "rig.hpp"

namespace tool_test {

struct dm8006 {
  static constexpr std::string_view name = "DM8006";
  static constexpr auto limits =
      cca::limits{cca::angle{-12.5, 12.5}, cca::velocity{-45, 45}, cca::torque{-20, 20},
                  cca::stiffness{0, 500}, cca::damping{0, 5}};
};
struct epos {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 4096, torque = 0.8;
};
struct n1 {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.1, run_on = 0.01;
};

namespace {

// `reply(random)` is a frame of the drive. Clocked drives have a SYNC after it.
template <class Drive, class Reply>
void same_as_codec(const char* name, Reply reply, double most_torque = 0) {
  CAPTURE(name);
  const auto named = drive_named(name);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const hw::drive_command c{10 * some(random), 30 * some(random), 3 * some(random),
                              250 + 250 * some(random), 2 + 2 * some(random)};
    const hw::set_point_frames s = named->set_point(c, most_torque), t = Drive::set_point(c);
    REQUIRE(s.frames.size() == t.frames.size() + named->clocked);
    CHECK(s.frames[0] == t.frames[0]);
    CHECK(s.cut == t.cut);
    hw::drive_report a, b;
    const hw::can_frame f = reply(some, random);
    REQUIRE(Drive::decode(f, b));
    REQUIRE(named->decode(f, a));
    CHECK(a.told == b.told);
    CHECK(a.activity == b.activity);
    if (b.told & hw::of_position) CHECK(a.position == doctest::Approx(b.position).epsilon(1e-12));
    if (b.told & hw::of_velocity) CHECK(a.velocity == doctest::Approx(b.velocity).epsilon(1e-12));
    if (b.told & hw::of_torque) CHECK(a.torque == doctest::Approx(b.torque).epsilon(1e-12));
  }
  const hw::drive_frames off = named->disable(), expected = Drive::disable();
  REQUIRE(off.size() == expected.size() + named->clocked);
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(off[i] == expected[i]);
}

std::string complaint(const char* name) {
  try {
    drive_named(name);
  } catch (const usage_error& e) { return e.what(); }
  return "";
}

}  // namespace

TEST_SUITE("drives by name") {
  TEST_CASE("an MIT drive has the number and ranges of its name") {
    using ak = hw::mit_drive<hw::ak80_9, 3>;
    same_as_codec<ak>("mit:ak80-9:3", [](auto& some, auto& r) {
      return ak::reply(10 * some(r), 40 * some(r), 9 * some(r), 30, 1);
    });
    using dm = hw::mit_drive<dm8006, 7, 16, hw::mit_firmware::damiao>;
    same_as_codec<dm>("damiao:12.5/45/20:7@16", [](auto& some, auto& r) {
      return dm::reply(10 * some(r), 40 * some(r), 9 * some(r), 30, 1);
    });
    using plain = hw::mit_drive<hw::ak10_9, 255, 0, hw::mit_firmware::original>;
    same_as_codec<plain>("mit-original:12.5/50/65:255", [](auto& some, auto& r) {
      return plain::reply(10 * some(r), 40 * some(r), 9 * some(r));
    });
  }
  TEST_CASE("so are an ODrive, a moteus and a CANopen drive") {
    using o = hw::odrive<5, hw::odrive_mode::position>;
    same_as_codec<o>("odrive:5", [](auto& some, auto& r) { return o::estimates(10 * some(r), some(r)); });
    using wide = hw::odrive<70, hw::odrive_mode::position, hw::odrive_firmware::v0_5>;
    same_as_codec<wide>("odrive-0.5:70",
                        [](auto& some, auto& r) { return wide::estimates(10 * some(r), some(r)); });
    using c = hw::cia402<epos, 9, hw::cia402_mode::position>;
    same_as_codec<c>("cia402:4096/0.8:9",
                     [](auto& some, auto& r) { return c::reply(0x27, 10 * some(r), some(r)); });
    using t = hw::cia402<epos, 9, hw::cia402_mode::torque>;
    same_as_codec<t>("cia402-torque:4096/0.8:9",
                     [](auto& some, auto& r) { return t::reply(0x27, 10 * some(r), some(r)); });
    using m = hw::moteus<n1, 4>;
    same_as_codec<m>(
        "moteus:80/2:4", [](auto& some, auto& r) { return m::reply(10, some(r), some(r), some(r)); }, 12);
    using far = hw::moteus<n1, 127>;
    same_as_codec<far>(
        "moteus:80/2:127", [](auto& some, auto& r) { return far::reply(10, some(r), some(r), some(r)); }, 12);
  }
  TEST_CASE("so is a RobStride, with its host") {
    using four = hw::robstride<hw::rs04, 3>;
    same_as_codec<four>("robstride:rs04:3", [](auto& some, auto& r) {
      return four::reply(hw::robstride_state::motor, 10 * some(r), 9 * some(r), 99 * some(r));
    });
    using one = hw::robstride<hw::rs01, 127, 0>;
    same_as_codec<one>("robstride:12.5/44/17/500/5:127@0", [](auto& some, auto& r) {
      return one::reply(hw::robstride_state::reset, 10 * some(r), 9 * some(r), 9 * some(r), 30, 4);
    });
    const hw::drive_frames first = drive_named("robstride:rs01:127@0")->enable({}).frames;
    one::enabling way;
    const hw::drive_frames expected = way.next({}).frames;
    REQUIRE(first.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(first[i] == expected[i]);
  }
  TEST_CASE("enabling a CANopen drive begins by starting its own node") {
    const hw::drive_frames first = drive_named("cia402:4096/0.8:9")->enable({}).frames;
    hw::cia402<epos, 9, hw::cia402_mode::position>::enabling way;
    const hw::drive_frames expected = way.next({}).frames;
    REQUIRE(first.size() == expected.size() + 1);
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(first[i] == expected[i]);
    CHECK(first[0] == hw::canopen_start(9));
  }
  TEST_CASE("a moteus gets its largest torque with each command, and enabling uses none") {
    const auto drive = drive_named("moteus:80/2:4");
    hw::moteus<n1, 4>::request q;
    REQUIRE(hw::moteus<n1, 4>::hear(
        drive->set_point({.position = 1, .torque = 0.4, .stiffness = 5}, 0.3).frames[0], q));
    CHECK(q.most_torque == doctest::Approx(0.3));
    CHECK(q.command.torque == doctest::Approx(0.3));
    hw::drive_report r;
    for (int i = 0; i < 3; ++i)
      for (const hw::can_frame& f : drive->enable(r).frames)
        if (hw::moteus<n1, 4>::hear(f, q) && q.mode != 0) CHECK(q.most_torque < 0.002);
  }
  TEST_CASE("frames of another drive on the same bus are not taken") {
    const auto drive = drive_named("mit:ak80-9:3");
    hw::drive_report r;
    CHECK_FALSE(drive->decode(hw::mit_drive<hw::ak80_9, 4>::reply(0, 0, 0), r));
    CHECK_FALSE(drive_named("odrive:5")->decode(hw::odrive<6, hw::odrive_mode::position>::heartbeat(8), r));
    CHECK_FALSE(drive_named("cia402:4096/0.8:9")
                    ->decode(hw::cia402<epos, 10, hw::cia402_mode::position>::reply(0x27, 0, 0), r));
    CHECK_FALSE(drive_named("moteus:80/2:4")->decode(hw::moteus<n1, 5>::reply(10, 0, 0, 0), r));
    using other = hw::robstride<hw::rs04, 4>;
    using elsewhere = hw::robstride<hw::rs04, 3, 0>;
    const auto robstride = drive_named("robstride:rs04:3");
    CHECK_FALSE(robstride->decode(other::reply(hw::robstride_state::motor, 0, 0, 0), r));
    CHECK_FALSE(robstride->decode(elsewhere::reply(hw::robstride_state::motor, 0, 0, 0), r));
    CHECK(r.frames == 0);
  }
  TEST_CASE("questions to a drive can't move it") {
    const hw::drive_frames leave = drive_named("mit:ak80-9:3")->ask();
    REQUIRE(leave.size() == 1);
    CHECK(leave[0] == hw::mit_special_frame(hw::standard(3), hw::mit_special::leave));
    const hw::drive_frames registers = drive_named("moteus:80/2:4")->ask();
    REQUIRE(registers.size() == 1);
    bool writes = false;
    CHECK(hw::read_registers(registers[0].payload(), [&](hw::moteus_kind kind, std::uint32_t, double) {
      writes |= kind == hw::moteus_kind::write;
    }));
    CHECK_FALSE(writes);
    const hw::drive_frames stop = drive_named("robstride:rs04:3")->ask();
    REQUIRE(stop.size() == 1);
    CHECK(stop[0] == hw::robstride<hw::rs04, 3>::stop());
    CHECK(drive_named("odrive:5")->ask().empty());
    const hw::drive_frames object = drive_named("cia402:4096/0.8:9")->ask();
    REQUIRE(object.size() == 1);
    CHECK(object[0].id == hw::standard(0x609));
    CHECK(object[0].data[0] == 0x40);  // an upload: reads
  }
  TEST_CASE("a wrong name gives a message with the right form") {
    CHECK(complaint("mit") ==
          "`mit` names no drive: expected one of mit:MODEL:NUMBER, damiao:P/V/T:NUMBER, "
          "mit-original:P/V/T:NUMBER, odrive:NUMBER, odrive-0.5:NUMBER, moteus:KP/KD:NUMBER, "
          "robstride:MODEL:NUMBER, "
          "cia402:COUNTS/TORQUE:NUMBER, "
          "cia402-torque:COUNTS/TORQUE:NUMBER");
    CHECK(
        complaint("mit:3") ==
        "`mit:3` names no drive: it needs the ranges of its firmware, which no frame reports: mit:RANGES:3");
    CHECK(
        complaint("mit:ak99:3") ==
        "`mit:ak99:3` names no drive: expected a model (ak10-9, ak60-6, ak70-10, ak80-6, ak80-9, ak80-64) or "
        "ranges as `12.5/50/18`, got `ak99`");
    CHECK(complaint("mit:ak80-9:256") == "`mit:ak80-9:256` names no drive: its number is at most 255");
    CHECK(complaint("mit:ak80-9:0") == "`mit:ak80-9:0` names no drive: its number is at least 1");
    CHECK(complaint("mit:ak80-9:3@3") ==
          "`mit:ak80-9:3@3` names no drive: it can't answer under the id that it listens to");
    CHECK(complaint("odrive:12.5:3") ==
          "`odrive:12.5:3` names no drive: an ODrive has no ranges; write odrive:NUMBER");
    CHECK(complaint("moteus:80:3") == "`moteus:80:3` names no drive: expected kp and kd as `80/2`, got `80`");
    CHECK(complaint("robstride:3") ==
          "`robstride:3` names no drive: it needs the ranges of its model, which no frame reports: "
          "robstride:RANGES:3");
    CHECK(
        complaint("robstride:rs09:3") ==
        "`robstride:rs09:3` names no drive: expected a model (rs01, rs04, cybergear) or ranges of position, "
        "velocity, torque, stiffness and damping as `12.57/20/60/5000/100`, got `rs09`");
    CHECK(complaint("robstride:rs04:128") ==
          "`robstride:rs04:128` names no drive: its number is at most 127");
    CHECK(complaint("robstride:rs04:3@3") ==
          "`robstride:rs04:3@3` names no drive: it can't answer under the id that it listens to");
    CHECK(complaint("moteus:80/2:3@4") ==
          "`moteus:80/2:3@4` names no drive: only MIT drives and RobStrides answer under another id, `@ID`");
    CHECK(complaint("damiao:12.5/-45/20:7").ends_with("got `12.5/-45/20`"));
    CHECK(complaint("servo:3").find("there is no family `servo`") != std::string::npos);
    CHECK(complaint("odrive:3x").find("`3x` is no number") != std::string::npos);
  }
}

}  // namespace tool_test
