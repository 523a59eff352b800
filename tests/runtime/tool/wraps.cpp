// Drives whose position begins again: an encoder of one turn before a gear. What jog is told is the angle
// that goes on.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include <doctest/doctest.h>

#include "../../../tools/cca_can/commands/calibrate.hpp"
#include "../../../tools/cca_can/commands/jog.hpp"
#include "rig.hpp"

namespace tool_test {
namespace {

constexpr double gear = 6, end = std::numbers::pi / gear;  // rad at the output
constexpr drive_scale one_turn{
    .position = end, .velocity = 45, .torque = 20, .stiffness = 500, .damping = 5, .wraps = 2 * end};

template <class Unit, class Address>
struct wrapping_rig : rig {
  // `known`: what the tool knows of the drive; `real`: what it does.
  wrapping_rig(Address at, drive_scale known, drive_scale real) : drive(at, known) {
    drive.text = "wraps";
    using played = typename cca_can::detail::played<Unit>::type;
    drives.push_back(std::make_unique<virtual_at<played, Address>>(at, real));
    each = [this] { farthest = std::max(farthest, motor().now.position); };
  }
  hw::virtual_motor& motor() { return drives[0]->motor; }
  ending jogs() { return jog(bus, "can0", drive, order, *this, say); }

  drive_at<Unit, Address> drive;
  jog_order order{
      .limits = {.low = -1, .high = 1, .speed = 0.5, .torque = 0.5, .stiffness = 5, .damping = 0.2},
      .goal = 0.7,
      .relative = true};
  double farthest = -100;
};

using mit_unit = unit_mit<hw::mit_firmware::ak>;
using mit_at = mit_address<hw::mit_firmware::ak>;
struct mit_rig : wrapping_rig<mit_unit, mit_at> {
  explicit mit_rig(drive_scale s = one_turn) : wrapping_rig({3, 0}, s, s) {}
};
using torque_unit = hw::odrive<1, hw::odrive_mode::torque>;
struct torque_rig : wrapping_rig<torque_unit, odrive_address> {
  explicit torque_rig(double known = 2 * end) : wrapping_rig({3}, {.wraps = known}, {.wraps = 2 * end}) {
    motor().most_torque = 18;
  }
};

}  // namespace

TEST_SUITE("a position that wraps") {
  TEST_CASE("jog by torque follows it over the end, and disables it where it leaves the range") {
    torque_rig over;
    over.motor().now.position = 0.1;
    CHECK_MESSAGE(over.jogs() == done, over.error.str());
    CHECK(over.motor().now.position == doctest::Approx(0.8).epsilon(0.05));
    CHECK(over.printed("  0.7"));

    torque_rig back;
    back.motor().now.position = -0.3;
    back.order.goal = -0.5;
    CHECK_MESSAGE(back.jogs() == done, back.error.str());
    CHECK(back.motor().now.position == doctest::Approx(-0.8).epsilon(0.05));

    torque_rig pushed;  // no faster than its speed
    pushed.drives[0]->load = 3;
    pushed.motor().friction = 6;
    pushed.order.hold = 5;
    CHECK(pushed.jogs() == failed);
    CHECK_MESSAGE(pushed.printed("it left its range: 1.05"), pushed.error.str());
    CHECK(pushed.farthest < 1.2);

    torque_rig outside;
    outside.order.limits.high = 0.6;
    CHECK(outside.jogs() == failed);
    CHECK_MESSAGE(outside.printed("the goal, 0.7"), outside.error.str());
  }
  TEST_CASE(
      "a drive with a law of its own must be disabled before the end, and nothing moves where it can't") {
    drive_scale unknown = one_turn;
    unknown.may_stay = true;
    for (const drive_scale& s : {one_turn, unknown}) {
      for (const auto& [low, high] : {std::array{-1.0, 1.0}, {-0.3, 0.4}, {-0.4, 0.3}}) {
        mit_rig r(s);
        r.order.limits.low = low, r.order.limits.high = high;
        r.order.goal = 0.1;
        CHECK(r.jogs() == failed);
        CHECK_MESSAGE(
            r.printed("the positions that it reports end at -0.5236 and 0.5236 rad, where they stay or "
                      "begin again: at 0.500 rad/s state a range within -0.3236 to 0.3236 rad"),
            r.error.str());
        CHECK(r.seen.empty());
      }
      mit_rig told(s);  // the range that the message advises
      told.order.limits.low = -0.3236, told.order.limits.high = 0.3236;
      told.order.goal = 0.1;
      CHECK_MESSAGE(told.jogs() == 0, told.error.str());
      mit_rig pushed(s);
      pushed.order.limits.low = -0.32, pushed.order.limits.high = 0.32;
      pushed.order.goal = 0.3;
      pushed.order.hold = 5;
      pushed.drives[0]->load = 3;
      pushed.motor().friction = 6;
      CHECK(pushed.jogs() == failed);
      CHECK_MESSAGE(pushed.printed("it left its range: 0.37"), pushed.error.str());
      CHECK(pushed.farthest < end);
    }
  }
  TEST_CASE("where nobody stated that it wraps, the jump ends jog") {
    torque_rig r(0);
    r.motor().now.position = 0.1;
    CHECK(r.jogs() == failed);
    CHECK_MESSAGE(r.printed("its position jumped, from 0.52"), r.error.str());
    CHECK(r.farthest < 0.7);
  }
  TEST_CASE("jog refuses a speed at which half of the range passes while the drive may be silent") {
    torque_rig r;
    r.order.limits.speed = 2.5;
    CHECK(r.jogs() == failed);
    CHECK_MESSAGE(
        r.printed("its position begins again after 1.0472 rad, and it can turn by half of that in the "
                  "0.1 s that it may be silent: state less than 2.368 rad/s"),
        r.error.str());
    CHECK(r.seen.empty());
  }
  TEST_CASE("drives by name: MIT and RobStride may stay or wrap, CiA 402 counts in 32 bits, others go on") {
    const auto mit = drive_named("mit:12.5/45/20:3"),
               robstride = drive_named("robstride:12.57/20/60/5000/100:3"),
               cia402 = drive_named("cia402:4096/0.8:5"), odrive = drive_named("odrive:3"),
               moteus = drive_named("moteus:80/2:3");
    CHECK(mit->wraps == 25);
    CHECK(mit->may_stay);
    CHECK(robstride->wraps == doctest::Approx(25.14));
    CHECK(robstride->may_stay);
    CHECK(cia402->wraps == doctest::Approx(std::exp2(32) / 4096 * 2 * std::numbers::pi));
    CHECK_FALSE(cia402->may_stay);
    CHECK(odrive->wraps == 0);
    CHECK(moteus->wraps == 0);
  }
  TEST_CASE("over the end the report goes on, and what is sent stays within the drive's range") {
    mit_rig r;
    r.motor().now.position = 0.4;
    r.motor().inertia = 1e6;
    talk t(r.bus, r.drive, r, 5 * ms);
    REQUIRE(t.ask_position().empty());
    CHECK(t.turned() == 0);
    for (const double q : {0.5, 0.6}) {
      r.motor().now.position = q;
      t.cycle(r.drive.ask_state());
    }
    CHECK(t.report().position == doctest::Approx(0.6).epsilon(0.001));
    CHECK(t.turned() == doctest::Approx(2 * end));
    const hw::drive_command c{.position = 0.7, .stiffness = 5};
    CHECK(t.set_point(c, 0.5).frames[0] ==
          r.drive.set_point({.position = 0.7 - 2 * end, .stiffness = 5}, 0.5).frames[0]);
  }
  TEST_CASE("calibrate refuses a joint at the end of what its drive reports") {
    torque_rig c;
    c.motor().now.position = end - 0.001;
    c.motor().now.velocity = 0.004;
    c.motor().friction = 0;
    const calibrate_order o{.joint = joint_named("left_hind_knee"), .at = 0.5, .file = "cca_can_wraps.toml"};
    CHECK(calibrate(c.bus, "can0", c.drive, o, c, c.say) == failed);
    CHECK_MESSAGE(c.printed("its position begins again just here"), c.error.str());
  }
}

}  // namespace tool_test
