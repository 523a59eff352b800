// The parts of a robot on drives, one at a time: the mounting of a joint, the sensor board, a virtual drive
// and its watchdog.
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include <cca/hardware/virtual_mit.hpp>

#include "../../../examples/hardware_in_the_loop/robot.hpp"

namespace {

namespace hw = cca::hardware;

using drive = hw::mit_drive<hw::ak60_6, 9>;
struct geared : hw::joint<cca::sim::left_front_hip,
                          drive,
                          hw::mounting{.gear = 2, .sign = -1, .offset = 0.3},
                          hw::joint_servo{.stiffness = 30, .damping = 0.4}> {};
using virtual_drive = hw::virtual_mit<drive, 5'000'000>;
static_assert(hw::VirtualDrive<virtual_drive>);

// One millisecond of a motor behind a drive, and the drive's answer.
hw::drive_report turn(virtual_drive& v, hw::virtual_motor& motor, std::int64_t now) {
  motor.advance(v.law(now), 0, 1e-3);
  hw::drive_report r;
  const auto frames = v.answer(motor.now);
  for (std::size_t i = 0; i < frames.size(); ++i) CHECK(drive::decode(frames[i], r));
  return r;
}
void tell(virtual_drive& v, const hw::drive_frames& frames, std::int64_t now) {
  for (std::size_t i = 0; i < frames.size(); ++i) CHECK(v.hear(frames[i], now));
}

}  // namespace

TEST_SUITE("parts of the drive chain") {
  TEST_CASE("a joint's mounting: angle, speed, torque and gains there and back") {
    CHECK(geared::angle_of(0) == doctest::Approx(0.3));
    CHECK(geared::angle_of(1) == doctest::Approx(0.3 - 0.5));
    CHECK(geared::drive_angle_of(geared::angle_of(0.7)) == doctest::Approx(0.7));
    const hw::drive_command c{0.1, 2, 3, 40, 0.5};
    const hw::drive_command d = geared::to_drive(c), back = geared::from_drive(d);
    CHECK(back.position == doctest::Approx(c.position));
    CHECK(back.velocity == doctest::Approx(c.velocity));
    CHECK(back.torque == doctest::Approx(c.torque));
    CHECK(back.stiffness == doctest::Approx(c.stiffness));
    CHECK(back.damping == doctest::Approx(c.damping));
    // The same law on both sides gives the same torque.
    const double q = 0.25, v = -1.5;
    const double at_joint = c.stiffness * (c.position - q) + c.damping * (c.velocity - v) + c.torque;
    const double at_drive = d.stiffness * (d.position - geared::drive_angle_of(q)) +
                            d.damping * (d.velocity - geared::drive_speed_of(v)) + d.torque;
    CHECK(geared::torque_of(at_drive) == doctest::Approx(at_joint));
  }

  TEST_CASE("the sensor board reports what it measured, to within a step") {
    using board = hw::sensor_board<0x40>;
    hw::board_reading r;
    r.orientation = {0.5, -0.5, 0.1, std::sqrt(1 - 0.51)};
    r.angular_velocity = {1.2345, -3, 0.001};
    r.specific_force = {0.1, -9.81, 150};
    r.foot_load = {0, 12.34, 50, 300};
    r.contact = {false, true, true, false};
    r.abduction = {0.1, -0.1, 0.3, 0};
    hw::board_reading heard;
    for (const auto& f : board::frames(r, 7)) CHECK(board::decode(f, heard));
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(heard.orientation[i] == doctest::Approx(r.orientation[i]).epsilon(0.001));
      CHECK(std::abs(heard.foot_load[i] - r.foot_load[i]) <= 0.006);
      CHECK(std::abs(heard.abduction[i] - r.abduction[i]) <= 0.00006);
      CHECK(heard.contact[i] == r.contact[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs(heard.angular_velocity[i] - r.angular_velocity[i]) <= 0.0006);
      CHECK(std::abs(heard.specific_force[i] - r.specific_force[i]) <= 0.003);
    }
    CHECK(heard.frames == 5);

    std::array<double, 4> targets{1, 2, 3, 4};
    CHECK(board::abducted(board::abduct({0.1, std::nan(""), -0.2, std::numeric_limits<double>::infinity()}),
                          targets));
    CHECK(targets[0] == doctest::Approx(0.1));
    CHECK(targets[1] == 2);  // NaN: the target stays
    CHECK(targets[2] == doctest::Approx(-0.2));
    CHECK(targets[3] == 4);
  }

  TEST_CASE(
      "random bytes: a quaternion has length 1 or is refused - nothing is taken from other ids or lengths") {
    using board = hw::sensor_board<0x40>;
    std::mt19937 random(3);
    int taken = 0;
    for (int i = 0; i < 20000; ++i) {
      hw::can_frame f{.id = hw::standard(static_cast<std::uint32_t>(0x3E + random() % 10)),
                      .length = static_cast<std::uint8_t>(random() % 9)};
      for (auto& b : f.data) b = static_cast<std::uint8_t>(random());
      hw::board_reading r;
      const bool mine = board::decode(f, r);
      taken += mine;
      if (mine) CHECK((f.length == 8 && f.id.number > 0x40 && f.id.number <= 0x45));
      double square = 0;
      for (const double x : r.orientation) square += x * x;
      CHECK(square == doctest::Approx(1));
    }
    CHECK(taken > 0);
  }

  TEST_CASE("a virtual drive moves only when it is enabled, and follows the law of its frames") {
    virtual_drive v;
    hw::virtual_motor motor;
    const auto go = drive::set_point({.position = 1, .stiffness = 20, .damping = 0.8});
    for (std::int64_t k = 0; k < 100; ++k) {
      tell(v, go.frames, k * 1'000'000);
      CHECK(turn(v, motor, k * 1'000'000).frames == 1);
    }
    CHECK(motor.now.position == 0);
    drive::enabling way;
    hw::drive_report r;
    auto step = way.next(r);
    for (std::int64_t k = 100; k < 110 && step.progress == hw::enable_progress::going; ++k) {
      tell(v, step.frames, k * 1'000'000);
      r = turn(v, motor, k * 1'000'000);
      step = way.next(r);
    }
    CHECK(step.progress == hw::enable_progress::done);
    for (std::int64_t k = 110; k < 1500; ++k) {
      tell(v, go.frames, k * 1'000'000);
      r = turn(v, motor, k * 1'000'000);
    }
    CHECK(motor.now.position == doctest::Approx(1).epsilon(0.01));
    CHECK(r.position == doctest::Approx(1).epsilon(0.01));
  }

  TEST_CASE("its watchdog, faults, silence and reboots take the torque away, as the firmware does") {
    virtual_drive v;
    const auto go = drive::set_point({.position = 1, .stiffness = 20, .damping = 0.8});
    const auto enter = hw::mit_special_frame(drive::request_id, hw::mit_special::enter);
    const auto torque = [&](std::int64_t now) { return v.law(now).stiffness; };
    v.hear(enter, 0);
    tell(v, go.frames, 0);
    CHECK(torque(5'000'000) > 0);
    CHECK(torque(5'000'001) == 0);  // unfed
    tell(v, go.frames, 6'000'000);
    CHECK(torque(6'000'000) > 0);  // it follows as soon as it is fed

    v.fail(2);
    CHECK(torque(6'000'000) == 0);
    hw::drive_report r;
    const auto answer = v.answer({});
    for (const auto& f : std::span<const hw::can_frame>(answer)) drive::decode(f, r);
    CHECK(r.fault == hw::drive_fault::over_current);
    v.clear();
    CHECK(torque(6'000'000) > 0);

    v.go_silent(true);
    tell(v, go.frames, 7'000'000);
    CHECK(v.answer({}).empty());
    CHECK(torque(7'000'000) > 0);  // it is silent, but still moves
    v.clear();

    v.reboot(8'000'000, 10'000'000);
    tell(v, go.frames, 9'000'000);
    CHECK(v.answer({}).empty());
    CHECK(torque(9'000'000) == 0);
    tell(v, go.frames, 19'000'000);
    CHECK(v.answer({}).size() == 1);
    CHECK(torque(19'000'000) == 0);  // it is back, but not enabled
  }

  TEST_CASE(
      "a Damiao keeps the fault of its watchdog: a late set point moves nothing until it is enabled again") {
    using damiao = hw::mit_drive<hw::ak60_6, 3, 0, hw::mit_firmware::damiao>;
    hw::virtual_mit<damiao, 5'000'000> v;
    const auto go = damiao::set_point({.position = 1, .stiffness = 20});
    const auto told = [&] {
      hw::drive_report r;
      const auto frames = v.answer({});
      for (std::size_t i = 0; i < frames.size(); ++i) damiao::decode(frames[i], r);
      return r;
    };
    v.hear(go.frames[0], 0);
    CHECK(told().activity == hw::drive_activity::disabled);
    damiao::enabling way;
    const auto on = way.next({});
    for (const auto& f : std::span<const hw::can_frame>(on.frames)) v.hear(f, 0);
    CHECK(told().activity == hw::drive_activity::enabled);
    v.hear(go.frames[0], 5'000'000);
    CHECK(v.law(5'000'000).stiffness > 0);
    v.hear(go.frames[0], 10'000'001);
    CHECK(v.law(10'000'001).stiffness == 0);
    CHECK(told().fault == hw::drive_fault::watchdog);
    damiao::enabling again;
    const auto anew = again.next({});
    for (const auto& f : std::span<const hw::can_frame>(anew.frames)) v.hear(f, 11'000'000);
    CHECK(told().activity == hw::drive_activity::enabled);
    v.hear(go.frames[0], 12'000'000);
    CHECK(v.law(12'000'000).stiffness > 0);
  }
}
