// ODrive's CAN Simple: known frames, every representable number, what differs between 0.5 and 0.6, the way to closed loop.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

#include <cca/hardware/odrive.hpp>

#include "../../laws/drive_laws.hpp"

using namespace cca::hardware;

namespace {

using position = odrive<1, odrive_mode::position>;
using velocity = odrive<2, odrive_mode::velocity>;
using torque = odrive<3, odrive_mode::torque>;
using old = odrive<4, odrive_mode::position, odrive_firmware::v0_5>;
using far = odrive<0x1234, odrive_mode::torque>;
constexpr double turn = detail::radians_in_turn;

static_assert(position::set_point({.position = turn}).frames[0].id == standard(0x2C));  // the example of ODrive's page

}  // namespace

TEST_CASE("odrive: the laws of a drive") {
  laws::drive<position>();
  laws::drive<velocity>();
  laws::drive<torque>();
  laws::drive<old>();
  laws::drive<far>();
}

TEST_CASE("odrive: known frames") {
  const auto f = position::set_point({.position = turn, .velocity = -turn, .torque = 0.5}).frames[0];
  CHECK(f == classic(standard(0x2C), std::array<std::uint8_t, 8>{0, 0, 0x80, 0x3F, 0x18, 0xFC, 0xF4, 0x01}));  // 1.0f, -1000, 500
  CHECK(torque::set_point({.torque = 1}).frames[0] == classic(standard(0x6E), std::array<std::uint8_t, 4>{0, 0, 0x80, 0x3F}));
  CHECK(far::set_point({}).frames[0].id == extended(0x1234 << 5 | 0x0E));
  CHECK(position::axis_state(8) == classic(standard(0x27), std::array<std::uint8_t, 8>{8}));
}

TEST_CASE("odrive: every number comes back as it was") {
  const auto again = [](const can_frame& f, auto drive) {
    drive_command c;
    if (!decltype(drive)::hear(f, c)) return false;
    const auto s = decltype(drive)::set_point(c);
    return s.finite && s.cut == 0 && s.frames[0] == f;
  };
  can_frame f = position::set_point({}).frames[0];
  for (int n = -32767; n <= 32767; ++n) {
    detail::put(f.data, 4, static_cast<std::uint16_t>(n));
    detail::put(f.data, 6, static_cast<std::uint16_t>(-n));
    REQUIRE(again(f, position{}));
  }
  can_frame g = torque::set_point({}).frames[0], v = velocity::set_point({}).frames[0], p = position::set_point({}).frames[0];
  for (std::uint64_t bits = 0; bits < 0x100000000u; bits += 9973) {  // all exponents, both signs
    const float x = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (!std::isfinite(x) || (x != 0 && std::fabs(x) < 1.2e-38f)) continue;
    detail::put_float(g.data, 0, x);
    REQUIRE(again(g, torque{}));
    detail::put_float(v.data, 0, x);
    REQUIRE(again(v, velocity{}));
    detail::put_float(p.data, 0, x);
    REQUIRE(again(p, position{}));
  }
}

TEST_CASE("odrive: estimates, and those that it has not got") {
  drive_report r;
  REQUIRE(position::decode(position::estimates(1.5, -2), r));
  CHECK(r.position == doctest::Approx(1.5).epsilon(1e-6));
  CHECK(r.velocity == doctest::Approx(-2).epsilon(1e-6));
  can_frame f = position::estimates(0, 0);
  detail::put_float(f.data, 0, std::numeric_limits<float>::infinity());
  detail::put_float(f.data, 4, std::numeric_limits<float>::quiet_NaN());
  REQUIRE(position::decode(f, r));
  CHECK(std::isnan(r.position));
  CHECK(std::isnan(r.velocity));
}

TEST_CASE("odrive: states and faults of 0.6 and 0.5") {
  drive_report r;
  for (const auto& [state, activity] : {std::pair{0, drive_activity::disabled},
                                        {1, drive_activity::disabled},
                                        {4, drive_activity::enabling},
                                        {8, drive_activity::enabled}}) {
    REQUIRE(position::decode(position::heartbeat(static_cast<std::uint8_t>(state)), r));
    CHECK(r.activity == activity);
  }
  const auto fault = [&r](auto drive, std::uint32_t error) {
    REQUIRE(decltype(drive)::decode(decltype(drive)::heartbeat(8, error), r));
    CHECK(r.activity == drive_activity::faulted);  // closed loop or not
    return r.fault;
  };
  CHECK(fault(position{}, 0x01000000) == drive_fault::watchdog);
  CHECK(fault(position{}, 0x00001000) == drive_fault::over_current);
  CHECK(fault(position{}, 0x00004000) == drive_fault::over_temperature);
  CHECK(fault(position{}, 0x80000000) == drive_fault::other);
  CHECK(fault(old{}, 0x800) == drive_fault::watchdog);
  CHECK(fault(old{}, 0x100) == drive_fault::position_sensor);
  CHECK(fault(old{}, 0x80000) == drive_fault::position_sensor);
  CHECK(fault(old{}, 0x40000) == drive_fault::over_temperature);
  CHECK(fault(old{}, 0x40) == drive_fault::power_stage);
  can_frame f = old::heartbeat(8);
  f.data[6] = 1;  // the encoder's flag, of 0.5 alone
  REQUIRE(old::decode(f, r));
  CHECK(r.fault == drive_fault::position_sensor);
  f = position::heartbeat(8);
  f.data[6] = 1;  // trajectory done, of 0.6
  REQUIRE(position::decode(f, r));
  CHECK(r.activity == drive_activity::enabled);
  CHECK(!old::decode({.id = old::id(odrive_command::torques), .length = 8}, r));  // of 0.5 something else
}

TEST_CASE("odrive: into closed loop from where it stands") {
  position::enabling enabling;
  drive_report r;
  auto s = enabling.next(r);
  REQUIRE(s.frames.size() == 2);
  CHECK(s.frames[0] == position::clear_errors());
  CHECK(s.frames[1] == position::controller_mode());
  CHECK(enabling.next(r).frames.empty());  // where is it?
  position::decode(position::estimates(0.7, 0), r);
  s = enabling.next(r);
  REQUIRE(s.frames.size() == 2);
  CHECK(s.frames[0] == position::set_point({.position = r.position}).frames[0]);
  CHECK(s.frames[1] == position::axis_state(8));
  CHECK(enabling.next(r).progress == enable_progress::going);
  position::decode(position::heartbeat(8), r);
  CHECK(enabling.next(r).progress == enable_progress::done);

  position::enabling failing;
  failing.next(r);
  position::decode(position::heartbeat(1, 0x200), r);  // may be from before
  CHECK(failing.next(r).progress == enable_progress::going);
  position::decode(position::heartbeat(1, 0x200), r);
  CHECK(failing.next(r).progress == enable_progress::failed);
}
