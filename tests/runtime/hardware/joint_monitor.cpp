// What a joint's reports show: two drives under one id, somebody else's commands, positions that wrap.
#include <doctest/doctest.h>

#include <cmath>

#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/mit.hpp>
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
