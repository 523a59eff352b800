// RobStride in operation control: frames of its manual, every possible number, faults and modes in the id,
// replies of others, enabling.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>

#include <cca/hardware/robstride.hpp>

#include "../../laws/drive_laws.hpp"

using namespace cca::hardware;

namespace {

using hip = robstride<rs04, 3>;
using knee = robstride<rs01, 127, 0>;
using gear = robstride<cybergear, 1>;

std::array<std::uint8_t, 8> bytes(const can_frame& f) {
  std::array<std::uint8_t, 8> b{};
  std::copy_n(f.data.begin(), 8, b.begin());
  return b;
}

// Frames are known at compile time.
static_assert(hip::set_point({.torque = 120}).frames[0].id == extended(0x01FFFF03));

}  // namespace

TEST_CASE("robstride: the laws of a drive") {
  laws::drive<hip>();
  laws::drive<knee>();
  laws::drive<gear>();
}

TEST_CASE("robstride: the zero command has no stiffness, no damping, and the middle of the other ranges") {
  CHECK(hip::still().id == extended(0x017FFF03));
  CHECK(bytes(hip::still()) == std::array<std::uint8_t, 8>{0x7F, 0xFF, 0x7F, 0xFF, 0, 0, 0, 0});
  CHECK(hip::still().length == 8);
}

TEST_CASE("robstride: each number has its place, the torque in the id") {
  const drive_command least{.position = -12.57, .velocity = -15, .torque = -120};
  const auto at = [](const drive_command& c) { return hip::set_point(c).frames[0]; };
  CHECK(at(least).id == extended(0x01000003));
  CHECK(bytes(at(least)) == std::array<std::uint8_t, 8>{});
  const auto with = [&](double drive_command::* number, double most) {
    drive_command c = least;
    c.*number = most;
    return at(c);
  };
  using eight = std::array<std::uint8_t, 8>;
  CHECK(bytes(with(&drive_command::position, 12.57)) == eight{0xFF, 0xFF, 0, 0, 0, 0, 0, 0});
  CHECK(bytes(with(&drive_command::velocity, 15)) == eight{0, 0, 0xFF, 0xFF, 0, 0, 0, 0});
  CHECK(bytes(with(&drive_command::stiffness, 5000)) == eight{0, 0, 0, 0, 0xFF, 0xFF, 0, 0});
  CHECK(bytes(with(&drive_command::damping, 100)) == eight{0, 0, 0, 0, 0, 0, 0xFF, 0xFF});
  CHECK(with(&drive_command::torque, 120).id == extended(0x01FFFF03));
  CHECK(bytes(with(&drive_command::torque, 120)) == eight{});
  // The upper byte comes first: a quarter of 5000 is step 4000h, rounded down.
  CHECK(bytes(with(&drive_command::stiffness, 1250)) == eight{0, 0, 0, 0, 0x40, 0x00, 0, 0});
}

TEST_CASE("robstride: frames of the manual for enabling, stopping, clearing and for the mode") {
  CHECK(hip::enable() == classic(extended(0x0300FD03), std::array<std::uint8_t, 8>{}));
  CHECK(hip::stop() == classic(extended(0x0400FD03), std::array<std::uint8_t, 8>{}));
  CHECK(hip::clear_fault() == classic(extended(0x0400FD03), std::array<std::uint8_t, 8>{1}));
  CHECK(hip::run_mode(0) == classic(extended(0x1200FD03), std::array<std::uint8_t, 8>{0x05, 0x70}));
  CHECK(hip::run_mode(5) == classic(extended(0x1200FD03), std::array<std::uint8_t, 8>{0x05, 0x70, 0, 0, 5}));
  CHECK(knee::enable().id == extended(0x0300007F));
}

TEST_CASE("robstride: every number of a command survives encoding and decoding") {
  const auto of = [](const detail::steps& r, std::uint32_t n) { return r.from_step(n); };
  for (std::uint32_t n = 0; n <= 0xFFFF; ++n) {
    const drive_command c{.position = of(hip::range<cca::angle>(), n),
                          .velocity = of(hip::range<cca::velocity>(), 0xFFFF - n),
                          .torque = of(hip::range<cca::torque>(), (n * 7) & 0xFFFF),
                          .stiffness = of(hip::range<cca::stiffness>(), n ^ 0x5555),
                          .damping = of(hip::range<cca::damping>(), (n * 11) & 0xFFFF)};
    const auto s = hip::set_point(c);
    REQUIRE(s.cut == 0);
    REQUIRE((s.frames[0].id.number >> 8 & 0xFFFF) == ((n * 7) & 0xFFFF));
    drive_command heard;
    REQUIRE(hip::hear(s.frames[0], heard));
    REQUIRE(heard.position == c.position);
    REQUIRE(heard.velocity == c.velocity);
    REQUIRE(heard.torque == c.torque);
    REQUIRE(heard.stiffness == c.stiffness);
    REQUIRE(heard.damping == c.damping);
  }
}

TEST_CASE("robstride: every number of a reply survives encoding and decoding") {
  drive_report r;
  for (std::uint32_t n = 0; n <= 0xFFFF; ++n) {
    const double position = hip::range<cca::angle>().from_step(n),
                 speed = hip::range<cca::velocity>().from_step(0xFFFF - n),
                 torque = hip::range<cca::torque>().from_step((n * 7) & 0xFFFF);
    REQUIRE(hip::decode(hip::reply(robstride_state::motor, position, speed, torque, n / 10.0), r));
    REQUIRE(r.position == position);
    REQUIRE(r.velocity == speed);
    REQUIRE(r.torque == torque);
    REQUIRE(r.temperature == n / 10.0);
    REQUIRE(((r.at_end & of_position) != 0) == (n == 0 || n == 0xFFFF));
    REQUIRE(((r.at_end & of_velocity) != 0) == (n == 0 || n == 0xFFFF));
  }
  CHECK(r.frames == 0x10000);
}

TEST_CASE("robstride: a reply of the manual, byte by byte") {
  // Motor mode (2), no fault, drive 3 to host FDh: -6.285 rad, 7.5 rad/s, 0 N m, 31.5 degrees.
  const can_frame f = classic(extended(0x028003FD),
                              std::array<std::uint8_t, 8>{0x40, 0x00, 0xC0, 0x00, 0x80, 0x00, 0x01, 0x3B});
  drive_report r;
  REQUIRE(hip::decode(f, r));
  CHECK(r.position == doctest::Approx(-12.57 / 2).epsilon(1e-4));
  CHECK(r.velocity == doctest::Approx(7.5).epsilon(1e-4));
  CHECK(r.torque == doctest::Approx(0).epsilon(2e-3));
  CHECK(r.temperature == doctest::Approx(31.5));
  CHECK(r.activity == drive_activity::enabled);
  CHECK(r.state == 2);
  CHECK(r.fault == drive_fault::none);
}

TEST_CASE("robstride: faults and modes") {
  const drive_fault lowest[] = {
      drive_fault::under_voltage,   drive_fault::power_stage, drive_fault::over_temperature,
      drive_fault::position_sensor, drive_fault::other,       drive_fault::configuration};
  for (std::uint32_t code = 0; code < 64; ++code)
    for (std::uint32_t state = 0; state < 4; ++state) {
      drive_report r;
      REQUIRE(hip::decode(hip::reply(static_cast<robstride_state>(state), 0, 0, 0, 25, code), r));
      CHECK(r.code == code);
      CHECK(r.state == state);
      drive_fault expected = drive_fault::none;
      for (std::uint32_t bit = 6; bit-- > 0;)
        if (code & 1u << bit) expected = lowest[bit];
      CHECK_MESSAGE(r.fault == expected, code);
      CHECK(r.activity == (code != 0    ? drive_activity::faulted
                           : state == 0 ? drive_activity::disabled
                           : state == 1 ? drive_activity::enabling
                           : state == 2 ? drive_activity::enabled
                                        : drive_activity::unknown));
    }
}

TEST_CASE("robstride: replies of other drives, to other hosts, of other types and lengths are not taken") {
  drive_report r;
  const can_frame good = hip::reply(robstride_state::motor, 1, 2, 3);
  REQUIRE(hip::decode(good, r));
  CHECK_FALSE(hip::decode(robstride<rs04, 4>::reply(robstride_state::motor, 1, 2, 3), r));
  CHECK_FALSE(hip::decode(robstride<rs04, 3, 0>::reply(robstride_state::motor, 1, 2, 3), r));
  for (const std::uint32_t type : {0u, 1u, 3u, 17u, 21u, 24u}) {
    can_frame f = good;
    f.id.number = (good.id.number & 0xFFFFFF) | type << 24;
    CHECK_FALSE(hip::decode(f, r));
  }
  for (const unsigned length : {0u, 6u, 7u}) {
    can_frame f = good;
    f.length = static_cast<std::uint8_t>(length);
    CHECK_FALSE(hip::decode(f, r));
  }
  can_frame f = good;
  f.fd = true;
  CHECK_FALSE(hip::decode(f, r));
  f = good;
  f.fast = true;  // no classic frame is
  CHECK_FALSE(hip::decode(f, r));
  drive_command c;
  f = hip::still();
  REQUIRE(hip::hear(f, c));
  f.fast = true;
  CHECK_FALSE(hip::hear(f, c));
  f = good;
  f.remote = true;
  CHECK_FALSE(hip::decode(f, r));
  f = good;
  f.id.extended = false;
  CHECK_FALSE(hip::decode(f, r));
  CHECK(r.frames == 1);
}

TEST_CASE("robstride: NaN does not become the end of a range") {
  const auto asked = hip::set_point({.position = std::numeric_limits<double>::quiet_NaN(), .stiffness = 100});
  CHECK_FALSE(asked.finite);
  CHECK(asked.frames.empty());
}

TEST_CASE("robstride: enters with a zero command, and is enabled when it reports the motor mode") {
  const auto report = [](drive_report& r, robstride_state state, std::uint32_t code = 0) {
    REQUIRE(hip::decode(hip::reply(state, 0.3, 0, 0, 25, code), r));
  };
  hip::enabling way;
  drive_report r;
  report(r, robstride_state::motor);  // from before
  const auto first = way.next(r);
  REQUIRE(first.frames.size() == 5);
  CHECK(first.frames[0] == hip::clear_fault());
  CHECK(first.frames[1] == hip::run_mode(0));
  CHECK(first.frames[2] == hip::still());
  CHECK(first.frames[3] == hip::enable());
  CHECK(first.frames[4] == hip::still());
  report(r, robstride_state::motor);  // an answer to a frame from before
  CHECK(way.next(r).progress == enable_progress::going);
  report(r, robstride_state::reset);  // the frame that enables was lost: it is sent again
  const auto again = way.next(r);
  CHECK(again.progress == enable_progress::going);
  CHECK(again.frames[1] == hip::enable());
  report(r, robstride_state::motor);
  CHECK(way.next(r).progress == enable_progress::done);

  hip::enabling hot;
  hot.next(r);
  report(r, robstride_state::reset, 4);
  CHECK(hot.next(r).progress == enable_progress::going);
  report(r, robstride_state::reset, 4);
  CHECK(hot.next(r).progress == enable_progress::failed);
}
