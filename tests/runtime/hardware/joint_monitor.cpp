// What a joint's reports show: two drives under one id, somebody else's commands, positions that wrap.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <span>

#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/odrive.hpp>
#include <cca/hardware/robot/joint_monitor.hpp>

using namespace cca::hardware;

namespace {

struct turning : cca::dimension<"turning"> {
  static constexpr auto limits = cca::limits{cca::angle{-50, 50}, cca::velocity{-20, 20}, cca::torque{-5, 5}};
};
using drive = mit_drive<ak60_6, 3>;
struct plain : joint<turning, drive, mounting{}, joint_servo{}> {};
struct wrapping
    : joint<turning, drive, mounting{.gear = 2, .sign = -1, .offset = 0.5, .wraps = 25}, joint_servo{}> {};

constexpr std::int64_t ms = 1'000'000;
struct moteus_motor {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.02;
};

template <class J>
struct bench {
  joint_monitor<J> m{};
  std::int64_t now = 0;

  bool hear(const can_frame& f) { return m.template hear<J, 0>(0, {f, now}, 0, true); }
  template <class... Frames>
  safety_rule beat(const Frames&... frames) {
    now += ms;
    m.begin_beat();
    (hear(frames), ...);
    m.check();
    return m.trips[0];
  }
};

can_frame at(double position, int noise, double velocity = 0) {
  return drive::reply(position, velocity, 0.1 * (noise % 7));
}

}  // namespace

TEST_CASE("joint monitor: one drive under its id runs on, also if frames come twice or late") {
  bench<plain> b;
  for (int i = 0; i < 1000; ++i)
    CHECK(b.beat(at(0.01 * std::sin(0.01 * i), i, 0.1 * std::cos(0.01 * i))) == safety_rule::none);
  for (int i = 0; i < 1000; ++i) CHECK(b.beat(at(0, i), at(0, i)) == safety_rule::none);
  for (int i = 0; i < 500; ++i) {
    CHECK(b.beat() == safety_rule::none);
    CHECK(b.beat(at(0, i), at(0, i + 1)) == safety_rule::none);
  }
}

TEST_CASE("joint monitor: two drives that answer under one id are noticed, far apart or close together") {
  for (const double apart : {1.0, 0.001}) {
    bench<plain> b;
    int beats = 0;
    while (beats < 2000 && b.beat(at(0, beats), at(apart, beats + 1)) == safety_rule::none) ++beats;
    CHECK(b.m.trips[0] == safety_rule::implausible);
    CHECK(beats < (apart == 1.0 ? 10 : 200));
  }
}

TEST_CASE("joint monitor: a single jump now and then is passed over") {
  bench<plain> b;
  for (int i = 0; i < 500; ++i) CHECK(b.beat(at(i % 20 == 10 ? 5 : 0, i)) == safety_rule::none);
  for (int i = 0; i < 2; ++i) CHECK(b.beat(at(5, i)) == safety_rule::none);
  CHECK(b.beat(at(5, 3)) == safety_rule::implausible);  // the third in a row
}

// A drive that sends estimates and torques by itself, in frames of their own.
namespace {
struct by_itself : joint<turning,
                         odrive<1, odrive_mode::torque, odrive_firmware::v0_6, 2 * ms, 5 * ms>,
                         mounting{},
                         joint_servo{}> {};
struct without_torques : joint<turning,
                               odrive<1, odrive_mode::torque, odrive_firmware::v0_6, 2 * ms>,
                               mounting{},
                               joint_servo{}> {};

// Beats with estimates each 2 ms, and torques each 5 ms until `end` of them have been sent.
template <class J>
safety_rule reports(bench<J>& b, int beats, int torques) {
  using sender = typename J::drive;
  safety_rule first = safety_rule::none;
  for (int k = 0, sent = 0; k < beats; ++k) {
    const bool sends = k % 5 == 0 && sent < torques;
    sent += sends;
    const can_frame heartbeat = sender::heartbeat(8), estimates = sender::estimates(0.5, 0);
    first = sends        ? b.beat(heartbeat, estimates, sender::torques(0.25))
            : k % 2 == 0 ? b.beat(heartbeat, estimates)
                         : b.beat(heartbeat);
  }
  return first;
}
}  // namespace

TEST_CASE("joint monitor: a torque that is no longer reported is not published, and trips") {
  bench<by_itself> b;
  CHECK_FALSE(b.m.is_ready(0));
  CHECK(reports(b, 100, 1000) == safety_rule::none);
  CHECK(b.m.is_ready(0));
  CHECK(b.m.torque_now(0) == doctest::Approx(0.25));
  CHECK(reports(b, 10, 0) == safety_rule::none);  // three of its periods are 15 beats; the last was 4 ago
  CHECK(b.m.torque_now(0) == doctest::Approx(0.25));
  CHECK(reports(b, 8, 0) == safety_rule::implausible);
  CHECK(std::isnan(b.m.torque_now(0)));
  CHECK(b.m.angle_now(0) == doctest::Approx(0.5));
}

TEST_CASE(
    "joint monitor: a start waits for the torque of a drive whose type states its period, not of others") {
  bench<by_itself> b;
  CHECK(reports(b, 100, 0) == safety_rule::none);
  CHECK_FALSE(b.m.is_ready(0));
  CHECK_FALSE(b.m.knows_torque(0));
  bench<without_torques> other;
  CHECK(reports(other, 100, 0) == safety_rule::none);
  CHECK(other.m.is_ready(0));
  CHECK(std::isnan(other.m.torque_now(0)));
  CHECK(reports(other, 100, 1) == safety_rule::implausible);  // it has begun, so it must go on
  other.m.restart();
  reports(other, 20, 0);
  CHECK(other.m.is_ready(0));
  CHECK(std::isnan(other.m.torque_now(0)));  // and not the torque from before
}

TEST_CASE("joint monitor: a drive that has no number for its torque has lost it") {
  using servo = moteus<moteus_motor, 1>;
  struct on_moteus : joint<turning, servo, mounting{}, joint_servo{}> {};
  bench<on_moteus> b;
  // The most negative integer in the place of the torque.
  const auto no_torque = [] {
    can_frame f = servo::reply(10, 0.5, 0, 0.001);
    const can_frame other = servo::reply(10, 0.5, 0, 0.002);
    std::size_t at = 0;
    while (f.data[at] == other.data[at]) ++at;
    f.data[at] = 0, f.data[at + 3] = 0x80;
    return f;
  };
  const auto beats = [&](double torque, int n) {
    safety_rule rule = safety_rule::none;
    for (int k = 0; k < n; ++k)
      rule = b.beat(std::isnan(torque) ? no_torque() : servo::reply(10, 0.5, 0, torque, 0));
    return rule;
  };
  CHECK(beats(0.1, 10) == safety_rule::none);
  CHECK(beats(drive_report::untold, 2) == safety_rule::none);
  CHECK(b.m.torque_now(0) == doctest::Approx(0.1).epsilon(0.1));
  CHECK(beats(drive_report::untold, 1) == safety_rule::implausible);
  CHECK(std::isnan(b.m.torque_now(0)));
}

TEST_CASE("joint monitor: a drive that somebody else has told to leave is not taken for running") {
  for (const can_frame& f : {mit_special_frame(drive::request_id, mit_special::leave), drive::still()}) {
    bench<plain> b;
    CHECK(b.beat(at(0, 0)) == safety_rule::none);
    CHECK(b.beat(at(0, 1), f) == safety_rule::implausible);
    b.m.forget_trips();
    CHECK(b.beat(at(0, 2)) == safety_rule::none);  // after a new start
  }
}

TEST_CASE(
    "joint monitor: the angle of a drive that wraps goes on, and a command stays on its side of the end") {
  bench<wrapping> b;
  for (int i = 0; i < 6500; ++i) {
    const double drive_angle = 20 * std::sin(0.001 * i), reported = std::remainder(drive_angle, 25.0);
    REQUIRE(b.beat(at(reported, i, 20 * std::cos(0.001 * i))) == safety_rule::none);
    REQUIRE(b.m.angle[0] == doctest::Approx(wrapping::angle_of(drive_angle)).epsilon(1e-3));
    // To hold where it is means the drive's own position, not one a turn away.
    const double command = wrapping::drive_angle_of(b.m.angle[0] - b.m.turned<wrapping>(0));
    REQUIRE(std::abs(command - b.m.reports[0].position) < 1e-9);
  }
  CHECK(bench<plain>().m.turned<plain>(0) == 0);
}

namespace {
struct endless : cca::dimension<"endless"> {
  static constexpr bool continuous = true;
  static constexpr auto limits = cca::limits{cca::velocity{-20, 20}, cca::torque{-12, 12}};
};
struct on_endless : joint<endless, drive, mounting{.sign = -1, .wraps = 25}, joint_servo{}> {};
}  // namespace

TEST_CASE("frames: a continuous joint is pulled across the end of its drive's range as hard as within it") {
  // N m at the joint, which a drive makes of a set point 0.4 rad ahead.
  const auto pull = [](double from) {
    const set_point ahead{{.position = from + 0.4, .stiffness = 20, .damping = 0.5}, motion_mode::run};
    const auto frames = frames_for<on_endless>(ahead, from, 0, true);
    REQUIRE(frames.size() == 1);
    const auto payload = std::span<const std::uint8_t, 8>(frames[0].data.data(), 8);
    const drive_command c = on_endless::from_drive(drive::wire::from_wire(drive::wire::read(payload)));
    return c.stiffness * (c.position - from) + c.torque;
  };
  for (const double from : {0.0, 12.0, 12.2, 12.45, -12.45})
    CHECK(pull(from) == doctest::Approx(8).epsilon(0.01));
}
