// ODrive's CAN Simple: known frames, every possible number, differences between 0.5 and 0.6, the way to
// closed loop.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include <cca/hardware/odrive.hpp>

#include "../../laws/drive_laws.hpp"
#include "all_numbers.hpp"

using namespace cca::hardware;

namespace {

using position = odrive<1, odrive_mode::position>;
using velocity = odrive<2, odrive_mode::velocity>;
using torque = odrive<3, odrive_mode::torque>;
using old = odrive<4, odrive_mode::position, odrive_firmware::v0_5>;
using far = odrive<0x1234, odrive_mode::torque>;
using with_torques = odrive<5, odrive_mode::torque, odrive_firmware::v0_6, 1'000'000, 5'000'000>;
constexpr double turn = detail::radians_in_turn;
constexpr std::uint32_t stride = 9973;  // step through the bits of all floats

static_assert(position::set_point({.position = turn}).frames[0].id ==
              standard(0x2C));  // the example in ODrive's documentation

}  // namespace

TEST_CASE("odrive: the laws of a drive") {
  laws::drive<position>();
  laws::drive<velocity>();
  laws::drive<torque>();
  laws::drive<old>();
  laws::drive<far>();
  laws::drive<with_torques>();
}

TEST_CASE("odrive: torques in frames of their own, with their period, if the type states it") {
  static_assert(with_torques::torque_period == 5'000'000 && with_torques::traffic.size() == 4 &&
                with_torques::traffic[3].period == 5'000'000 && torque::traffic.size() == 3);
  static_assert(torque_period_of<with_torques> == 5'000'000 &&
                torque_period_of<torque> == torque::report_period);
  drive_report r;
  REQUIRE(with_torques::decode(with_torques::torques(-0.75), r));
  CHECK(r.torque == -0.75);
  CHECK(r.told == of_torque);
}

TEST_CASE("odrive: known frames") {
  const auto f = position::set_point({.position = turn, .velocity = -turn, .torque = 0.5}).frames[0];
  CHECK(f == classic(standard(0x2C), std::array<std::uint8_t, 8>{0, 0, 0x80, 0x3F, 0x18, 0xFC, 0xF4,
                                                                 0x01}));  // 1.0f, -1000, 500
  CHECK(torque::set_point({.torque = 1}).frames[0] ==
        classic(standard(0x6E), std::array<std::uint8_t, 4>{0, 0, 0x80, 0x3F}));
  CHECK(far::set_point({}).frames[0].id == extended(0x1234 << 5 | 0x0E));
  CHECK(position::axis_state(8) == classic(standard(0x27), std::array<std::uint8_t, 8>{8}));
}

TEST_CASE("odrive: every number of a command survives encoding and decoding") {
  const auto again = [](const can_frame& f, auto drive) {
    drive_command c;
    if (!decltype(drive)::hear(f, c)) return false;
    const auto s = decltype(drive)::set_point(c);
    return s.finite && s.cut == 0 && s.frames[0] == f;
  };
  drive_command c;
  can_frame f = position::set_point({}).frames[0];
  for (int n = -32767; n <= 32767; ++n) {
    detail::put(f.data, 4, static_cast<std::uint16_t>(n));
    detail::put(f.data, 6, static_cast<std::uint16_t>(-n));
    REQUIRE(again(f, position{}));
    REQUIRE(position::hear(f, c));
    REQUIRE(std::lround(c.velocity / turn * 1000) == n);
    REQUIRE(std::lround(c.torque * 1000) == -n);
  }
  detail::put(f.data, 4, std::uint16_t{0x8000});  // -32768 is understood, but never sent
  detail::put(f.data, 6, std::uint16_t{0x8000});
  REQUIRE(position::hear(f, c));
  CHECK(c.velocity == -32.768 * turn);
  CHECK(c.torque == -32.768);
  const auto s = position::set_point(c);
  CHECK(s.cut == (of_velocity | of_torque));
  CHECK(detail::got<std::uint16_t>(s.frames[0].payload(), 4) == 0x8001);
  CHECK(detail::got<std::uint16_t>(s.frames[0].payload(), 6) == 0x8001);

  can_frame g = torque::set_point({}).frames[0], v = velocity::set_point({}).frames[0],
            p = position::set_point({}).frames[0];
  for_floats(stride, [&](float x) {
    if (!std::isfinite(x)) return;
    detail::put_float(g.data, 0, x);
    REQUIRE(again(g, torque{}));
    detail::put_float(v.data, 0, x);
    detail::put_float(v.data, 4, -x);
    REQUIRE(again(v, velocity{}));
    REQUIRE(velocity::hear(v, c));
    REQUIRE(c.velocity == static_cast<double>(x) * turn);
    REQUIRE(c.torque == static_cast<double>(-x));
    detail::put_float(p.data, 0, x);
    REQUIRE(again(p, position{}));
    REQUIRE(position::hear(p, c));
    REQUIRE(c.position == static_cast<double>(x) * turn);
  });
}

TEST_CASE(
    "odrive: every number of a report is reported as it was - NaN and infinity mean that it lacks the "
    "number") {
  const auto is = [](double told, float x, double unit) {
    return std::isfinite(x) ? told == static_cast<double>(x) * unit : std::isnan(told);
  };
  for_floats(stride, [&](float x) {
    drive_report r;
    can_frame f{.id = position::id(odrive_command::estimates), .length = 8};
    detail::put_float(f.data, 0, x);
    detail::put_float(f.data, 4, -x);
    REQUIRE(position::decode(f, r));
    REQUIRE(is(r.position, x, turn));
    REQUIRE(is(r.velocity, -x, turn));
    REQUIRE(r.told == (of_position | of_velocity));
    if (std::isfinite(x)) REQUIRE(position::estimates(r.position, r.velocity) == f);
    f.id = position::id(odrive_command::temperature);  // the power stage's, then the motor's
    REQUIRE(position::decode(f, r));
    REQUIRE(is(r.temperature, x, 1));
    REQUIRE(r.told == of_temperature);
    f.id = position::id(odrive_command::torques);  // wanted, then estimated
    REQUIRE(position::decode(f, r));
    REQUIRE(is(r.torque, -x, 1));
    REQUIRE(r.told == of_torque);
    REQUIRE(is(r.position, x, turn));  // what other frames reported stays
    REQUIRE(r.frames == 3);
  });
  drive_report r;
  for (const auto c : {odrive_command::temperature, odrive_command::torques})
    CHECK(!old::decode({.id = old::id(c), .length = 8}, r));  // means something else in 0.5
}

TEST_CASE("odrive: a position has no end and does not wrap - it only gets coarser") {
  drive_report r;
  double before = 0;
  for (double turns = 0.5; turns < 3e38; turns *= 2) {
    REQUIRE(position::decode(position::estimates(turns * turn, -turns * turn), r));
    REQUIRE(r.position == turns * turn);
    REQUIRE(r.velocity == -turns * turn);
    REQUIRE(r.position > before);
    REQUIRE(r.at_end == 0);
    before = r.position;
  }
  // A million turns away a step is a sixteenth of a turn, in reports and in commands.
  REQUIRE(position::decode(position::estimates((1e6 + 0.03) * turn, 0), r));
  CHECK(r.position == 1e6 * turn);
  drive_command c;
  REQUIRE(position::hear(position::set_point({.position = (1e6 + 0.04) * turn}).frames[0], c));
  CHECK(c.position == (1e6 + 0.0625) * turn);
}

TEST_CASE("odrive: frames that stop, reboot or configure it have ids that no command uses") {
  CHECK(position::estop() == can_frame{.id = standard(0x22)});
  CHECK(position::clear_errors() == classic(standard(0x38), std::array<std::uint8_t, 1>{}));
  CHECK(old::clear_errors() == can_frame{.id = standard(0x98)});
  CHECK(position::controller_mode() == classic(standard(0x2B), std::array<std::uint8_t, 8>{3, 0, 0, 0, 1}));
  CHECK(position::disable()[0] == position::axis_state(1));
  CHECK(old::axis_state(1) == classic(standard(0x87), std::array<std::uint8_t, 4>{1}));
  drive_report r;
  // Of the drive's frames, five are reports.
  for (std::uint32_t command = 0; command < 32; ++command) {
    const auto c = static_cast<odrive_command>(command);
    const bool told = c == odrive_command::heartbeat || c == odrive_command::error ||
                      c == odrive_command::estimates || c == odrive_command::temperature ||
                      c == odrive_command::torques;
    CHECK(position::decode({.id = position::id(c), .length = 8}, r) == told);
  }
  for (const double x : {-1e30, -1.0, 0.0, 1.0, 1e30}) {
    const drive_command all{x, x, x, x, x};
    CHECK(position::set_point(all).frames[0].id == standard(0x2C));
    CHECK(velocity::set_point(all).frames[0].id == standard(0x4D));
    CHECK(torque::set_point(all).frames[0].id == standard(0x6E));
  }
  // After that it reports a fault until the fault is cleared.
  REQUIRE(position::decode(position::heartbeat(1, 0x02000000), r));
  CHECK(r.fault == drive_fault::emergency_stop);
  CHECK(r.activity == drive_activity::faulted);
}

TEST_CASE("odrive: each error and each state, in heartbeats and in error frames") {
  using enum drive_fault;
  struct known {
    int bit;
    drive_fault of;
  };
  const auto expected = [](std::span<const known> all, int bit) {
    for (const known& k : all)
      if (k.bit == bit) return k.of;
    return other;
  };
  const known now[] = {{3, position_sensor},   {4, configuration},   {5, power_stage},
                       {8, over_voltage},      {9, under_voltage},   {10, over_current},
                       {11, over_voltage},     {12, over_current},   {13, over_temperature},
                       {14, over_temperature}, {15, limit},          {16, limit},
                       {24, watchdog},         {25, emergency_stop}, {26, position_sensor},
                       {27, power_stage},      {30, configuration}};
  const known before[] = {{0, configuration},   {1, under_voltage},   {2, over_voltage},
                          {4, power_stage},     {5, power_stage},     {6, power_stage},
                          {7, position_sensor}, {8, position_sensor}, {11, watchdog},
                          {12, limit},          {13, limit},          {14, emergency_stop},
                          {15, over_current},   {16, over_current},   {18, over_temperature},
                          {19, position_sensor}};
  for (int bit = 0; bit < 32; ++bit) {
    const std::uint32_t error = std::uint32_t{1} << bit;
    drive_report r;
    REQUIRE(position::decode(position::heartbeat(8, error), r));
    CHECK_MESSAGE(r.fault == expected(now, bit), bit);
    CHECK(r.code == error);
    REQUIRE(old::decode(old::heartbeat(8, error), r));
    CHECK_MESSAGE(r.fault == expected(before, bit), bit);

    can_frame f{.id = position::id(odrive_command::error), .length = 8};
    detail::put(f.data, 0, error);
    detail::put(f.data, 4, ~error);
    r = {};
    REQUIRE(position::decode(f, r));
    CHECK(r.fault == expected(now, bit));
    CHECK(r.code == error);
    CHECK(r.activity == drive_activity::faulted);
    CHECK(r.states == 1);
    detail::put(f.data, 0, std::uint32_t{0});  // no error any more, and the reason why it was disarmed
    r = {};
    REQUIRE(position::decode(f, r));
    CHECK(r.code == ~error);
    CHECK(r.fault == none);
    CHECK(r.activity == drive_activity::unknown);
    CHECK_MESSAGE(r.states == 0, "only the heartbeat says whether it drives");
    f.id = old::id(odrive_command::error);  // 64 bits of the motor's errors
    for (const std::size_t at : {0u, 4u}) {
      detail::put(f.data, 4 - at, std::uint32_t{0});
      detail::put(f.data, at, error);
      r = {};
      REQUIRE(old::decode(f, r));
      CHECK(r.fault == other);
      CHECK(r.code == error);
      CHECK(r.activity == drive_activity::faulted);
    }
  }
  for (unsigned state = 0; state < 256; ++state) {
    drive_report r;
    REQUIRE(position::decode(position::heartbeat(static_cast<std::uint8_t>(state)), r));
    CHECK(r.state == state);
    CHECK(r.activity == (state == 8   ? drive_activity::enabled
                         : state <= 1 ? drive_activity::disabled
                                      : drive_activity::enabling));
  }
}

TEST_CASE("odrive: estimates, and those that it lacks") {
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
    CHECK(r.activity == drive_activity::faulted);  // in closed loop or not
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
  f.data[6] = 1;  // the encoder's flag, in 0.5 only
  REQUIRE(old::decode(f, r));
  CHECK(r.fault == drive_fault::position_sensor);
  f = position::heartbeat(8);
  f.data[6] = 1;  // trajectory done, in 0.6
  REQUIRE(position::decode(f, r));
  CHECK(r.activity == drive_activity::enabled);
  CHECK(!old::decode({.id = old::id(odrive_command::torques), .length = 8},
                     r));  // means something else in 0.5
}

// Node 63 of firmware 0.6 is not addressed: `odrive<63, Mode>` does not compile.
static_assert(!detail::is_odrive_node(63, odrive_firmware::v0_6));
static_assert(detail::is_odrive_node(63, odrive_firmware::v0_5));
static_assert(detail::is_odrive_node(62, odrive_firmware::v0_6) &&
              detail::is_odrive_node(64, odrive_firmware::v0_6));

TEST_CASE("odrive: goes to closed loop from where it is") {
  position::enabling enabling;
  drive_report r;
  auto s = enabling.next(r);
  REQUIRE(s.frames.size() == 2);
  CHECK(s.frames[0] == position::clear_errors());
  CHECK(s.frames[1] == position::controller_mode());
  CHECK(enabling.next(r).frames.empty());  // it waits for a position
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
  position::decode(position::heartbeat(1, 0x200), r);  // this may be from before
  CHECK(failing.next(r).progress == enable_progress::going);
  position::decode(position::heartbeat(1, 0x200), r);
  CHECK(failing.next(r).progress == enable_progress::failed);

  // It was in closed loop before. That there is no error does not say that it still is.
  position::enabling again;
  position::decode(position::heartbeat(8), r);
  again.next(r);
  again.next(r);
  position::decode({.id = position::id(odrive_command::error), .length = 8}, r);
  CHECK(again.next(r).progress == enable_progress::going);
  position::decode(position::heartbeat(8), r);
  CHECK(again.next(r).progress == enable_progress::done);
}
