// CiA 402: status words, the way to operation enabled with a drive that follows the standard, process data,
// emergencies.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include <cca/hardware/cia402.hpp>
#include <cca/hardware/position_unwrap.hpp>

#include "../../laws/drive_laws.hpp"

using namespace cca::hardware;

namespace {

struct motor {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 4096, torque = 0.8;
};
using position = cia402<motor, 5, cia402_mode::position>;
using torque = cia402<motor, 6, cia402_mode::torque>;
constexpr double turn = detail::radians_in_turn;

static_assert(torque::set_point({.torque = 0.8}).frames[0].id == standard(0x206));

constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();

// Every 65521st number of 32 bits, and the ends.
template <class F>
void for_counts(F&& f) {
  for (std::int64_t n = lowest; n <= 2147483647; n += 65521) f(static_cast<std::int32_t>(n));
  for (const std::int32_t n : {lowest, lowest + 1, -1, 0, 1, 2147483646, 2147483647}) f(n);
}

// The state machine of the standard, by control words.
struct drive {
  cia402_state state = cia402_state::switch_on_disabled;
  std::uint16_t last = 0;
  double at = 0.5, target = 99;

  std::uint16_t status() const {
    switch (state) {
      case cia402_state::switch_on_disabled:
        return 0x0250;
      case cia402_state::ready:
        return 0x0231;
      case cia402_state::switched_on:
        return 0x0233;
      case cia402_state::enabled:
        return 0x0237;
      case cia402_state::fault:
        return 0x0218;
      default:
        return 0;
    }
  }
  can_frame hear(const can_frame& f) {
    std::uint16_t word = 0;
    drive_command c;
    if (position::hear(f, word, c)) {
      const bool shutdown = (word & 0x87) == 0x06, on = (word & 0x8F) == 0x07, enable = (word & 0x8F) == 0x0F,
                 voltage = (word & 0x82) != 0;
      const bool edge = (word & 0x80) != 0 && (last & 0x80) == 0;
      last = word;
      if (state == cia402_state::fault) {
        if (edge) state = cia402_state::switch_on_disabled;
      } else if (!voltage) state = cia402_state::switch_on_disabled;
      else if (shutdown) state = cia402_state::ready;
      else if (on && state == cia402_state::ready) state = cia402_state::switched_on;
      else if (enable && state == cia402_state::switched_on)
        state = cia402_state::enabled, target = c.position;
      else if (state == cia402_state::enabled) target = c.position;
    }
    return position::reply(status(), at, 0);
  }
};

}  // namespace

TEST_CASE("cia402: the laws of a drive") {
  laws::drive<position>();
  laws::drive<torque>();
}

TEST_CASE("cia402: status words") {
  for (const unsigned rest : {0x0000u, 0x0200u, 0x1700u, 0x0080u}) {
    const auto of = [rest](unsigned low) { return cia402_state_of(static_cast<std::uint16_t>(rest | low)); };
    CHECK(of(0x00) == cia402_state::not_ready);
    CHECK(of(0x40) == cia402_state::switch_on_disabled);
    CHECK(of(0x50) == cia402_state::switch_on_disabled);
    CHECK(of(0x31) == cia402_state::ready);
    CHECK(of(0x33) == cia402_state::switched_on);
    CHECK(of(0x37) == cia402_state::enabled);
    CHECK(of(0x17) == cia402_state::quick_stop);
    CHECK(of(0x0F) == cia402_state::fault_reaction);
    CHECK(of(0x08) == cia402_state::fault);
  }
  for (unsigned word = 0; word < 0x10000; ++word)
    CHECK(cia402_state_of(static_cast<std::uint16_t>(word)) <= cia402_state::unknown);
}

TEST_CASE("cia402: frames follow the mapping") {
  const auto f = position::set_point({.position = turn}).frames[0];
  CHECK(f == classic(standard(0x205), std::array<std::uint8_t, 8>{0x0F, 0, 0, 0x10, 0, 0, 0, 0}));
  CHECK(torque::set_point({.torque = -0.8}).frames[0] ==
        classic(standard(0x206), std::array<std::uint8_t, 8>{0x0F, 0, 0, 0, 0, 0, 0x18, 0xFC}));
  CHECK(canopen_sync() == can_frame{.id = standard(0x80)});
  CHECK(canopen_start(5) == classic(standard(0), std::array<std::uint8_t, 2>{1, 5}));
}

TEST_CASE("cia402: every number survives encoding and decoding") {
  drive_report r;
  std::uint16_t word = 0;
  drive_command c;
  for (int n = -32767; n <= 32767; ++n) {
    REQUIRE(torque::decode(torque::reply(0x0237, 0, n * 0.0008), r));
    REQUIRE(std::lround(r.torque / 0.0008) == n);
    const auto s = torque::set_point({.torque = r.torque});
    REQUIRE(s.cut == 0);
    REQUIRE(torque::hear(s.frames[0], word, c));
    REQUIRE(c.torque == r.torque);
  }
  for_counts([&](std::int32_t n) {
    if (n == lowest) return;
    const double x = static_cast<double>(n) / 4096 * turn;
    REQUIRE(position::decode(position::reply(0x0237, x, 0), r));
    REQUIRE(std::llround(r.position / turn * 4096) == n);
    const auto s = position::set_point({.position = r.position});
    REQUIRE(s.cut == 0);
    REQUIRE(position::hear(s.frames[0], word, c));
    REQUIRE(c.position == r.position);
    REQUIRE(position::decode(position::velocity_frame(x), r));  // TPDO2
    REQUIRE(r.told == of_velocity);
    REQUIRE(std::llround(r.velocity / turn * 4096) == n);
    REQUIRE(detail::got<std::uint32_t>(position::velocity_frame(r.velocity).payload(), 0) ==
            static_cast<std::uint32_t>(n));
  });
}

TEST_CASE("cia402: every number that a frame can hold is reported, the most negative one too") {
  can_frame data = position::reply(0x0237, 0, 0), speed = position::velocity_frame(0),
            asked = position::set_point({}).frames[0];
  drive_report r;
  std::uint16_t word = 0;
  drive_command c;
  for (int n = -32768; n <= 32767; ++n) {
    for (can_frame* f : {&data, &asked}) detail::put(f->data, 6, static_cast<std::uint16_t>(n));
    REQUIRE(position::decode(data, r));
    REQUIRE(r.torque == doctest::Approx(n * 0.0008).epsilon(1e-14));
    REQUIRE(position::hear(asked, word, c));
    REQUIRE(c.torque == r.torque);
  }
  for_counts([&](std::int32_t n) {
    for (can_frame* f : {&data, &asked}) detail::put(f->data, 2, static_cast<std::uint32_t>(n));
    detail::put(speed.data, 0, static_cast<std::uint32_t>(n));
    REQUIRE(position::decode(data, r));
    REQUIRE(r.position == doctest::Approx(n / 4096.0 * turn).epsilon(1e-14));
    REQUIRE(position::decode(speed, r));
    REQUIRE(r.velocity == r.position);
    REQUIRE(position::hear(asked, word, c));
    REQUIRE(c.position == r.position);
    REQUIRE(word == 0x000F);
  });
  // A set point never has it: it ends one before.
  const auto s = position::set_point({.position = -2147483648.0 / 4096 * turn});
  CHECK(s.cut == of_position);
  CHECK(detail::got<std::uint32_t>(s.frames[0].payload(), 2) == 0x80000001u);
  const auto t = torque::set_point({.torque = -32768 * 0.0008});
  CHECK(t.cut == of_torque);
  CHECK(detail::got<std::uint16_t>(t.frames[0].payload(), 6) == 0x8001u);
}

TEST_CASE(
    "cia402: counts that wrap are reported as they are, and can be unwrapped - set points do not wrap") {
  const double range = 4294967296.0 / 4096 * turn, count = turn / 4096;
  can_frame f = position::reply(0x0237, 0, 0);
  const auto told = [&f](std::int64_t counts) {
    drive_report r;
    detail::put(f.data, 2, static_cast<std::uint32_t>(counts));
    REQUIRE(position::decode(f, r));
    REQUIRE(r.at_end == 0);
    return r.position;
  };
  CHECK(told(2147483648) ==
        doctest::Approx(-range / 2).epsilon(1e-14));  // one after the last, as in two's complement
  CHECK(told(2147483647) - told(2147483648) == doctest::Approx(range - count).epsilon(1e-14));
  CHECK(told(-2147483649) == told(2147483647));
  for (const std::int64_t step : {70'000'001, -70'000'001}) {  // many times over the end
    position_unwrap unwrap(range);
    for (std::int64_t k = 0, at = 0; k < 1000; ++k, at += step)
      REQUIRE(std::fabs(unwrap(told(at)) - static_cast<double>(at) * count) < 0.01 * count);
  }
  for (const double sign : {-1, 1})
    for (const double beyond : {2147483648.0, 2147483649.0, 4294967296.0, 1e15}) {
      const auto s = position::set_point({.position = sign * beyond * count});
      CHECK(s.cut == of_position);
      CHECK(static_cast<std::int32_t>(detail::got<std::uint32_t>(s.frames[0].payload(), 2)) ==
            sign * 2147483647);
    }
}

TEST_CASE("cia402: no command looks like NMT or SYNC") {
  for (const double x : {-1e30, -1.0, 0.0, 1.0, 1e30}) {
    CHECK(position::set_point({x, x, x, x, x}).frames[0].id == standard(0x205));
    CHECK(torque::set_point({x, x, x, x, x}).frames[0].id == standard(0x206));
  }
  drive_report r;
  CHECK(!position::decode(canopen_sync(), r));
  CHECK(!position::decode(canopen_start(5), r));
  CHECK(!position::decode(canopen_stop(5), r));
  CHECK(canopen_stop(5) == classic(standard(0), std::array<std::uint8_t, 2>{2, 5}));
  CHECK(position::quick_stop()[0] == classic(standard(0x205), std::array<std::uint8_t, 8>{2}));
  CHECK(position::disable()[0] == classic(standard(0x205), std::array<std::uint8_t, 8>{0}));
}

TEST_CASE("cia402: enables from off and from a fault, at its present position") {
  for (const auto from : {cia402_state::switch_on_disabled, cia402_state::fault, cia402_state::ready}) {
    drive d;
    d.state = from;
    position::enabling enabling;
    drive_report r;
    int cycles = 0;
    for (; cycles < 40; ++cycles) {
      const auto s = enabling.next(r);
      if (s.progress == enable_progress::done) break;
      REQUIRE(s.progress == enable_progress::going);
      for (const can_frame& f : s.frames) REQUIRE(position::decode(d.hear(f), r));
    }
    CHECK(cycles < 12);
    CHECK(d.state == cia402_state::enabled);
    CHECK(std::fabs(d.target - 0.5) < 0.001);  // never 0
    for (const can_frame& f : position::disable()) d.hear(f);
    CHECK(d.state == cia402_state::switch_on_disabled);
  }
}

TEST_CASE("cia402: a lasting fault makes enabling fail") {
  position::enabling enabling;
  drive_report r;
  REQUIRE(position::decode(position::reply(0x0218, 0, 0), r));
  int cycles = 0;
  while (enabling.next(r).progress == enable_progress::going && cycles < 100) ++cycles;
  CHECK(cycles == 16);
  CHECK(r.fault == drive_fault::other);
  CHECK(r.activity == drive_activity::faulted);
}

TEST_CASE("cia402: emergencies and heartbeats") {
  drive_report r;
  const auto emergency = [&r](unsigned code) {
    REQUIRE(position::decode(
        classic(standard(0x85), std::array<std::uint8_t, 8>{static_cast<std::uint8_t>(code),
                                                            static_cast<std::uint8_t>(code >> 8)}),
        r));
    return r.fault;
  };
  CHECK(emergency(0x2310) == drive_fault::over_current);
  CHECK(emergency(0x3210) == drive_fault::over_voltage);
  CHECK(emergency(0x3220) == drive_fault::under_voltage);
  CHECK(emergency(0x4210) == drive_fault::over_temperature);
  CHECK(emergency(0x7305) == drive_fault::position_sensor);
  CHECK(emergency(0x8130) == drive_fault::communication);
  CHECK(emergency(0x8611) == drive_fault::limit);
  CHECK(emergency(0x8A81) == drive_fault::limit);
  CHECK(r.activity == drive_activity::faulted);
  CHECK(emergency(0x0000) == drive_fault::none);
  using enum drive_fault;
  for (unsigned code = 0; code < 0x10000; ++code) {
    constexpr drive_fault classes[] = {
        none,        other,         over_current, over_voltage,  over_temperature,
        power_stage, configuration, other,        communication, other,
        other,       other,         other,        other,         other,
        other};
    const unsigned of = code >> 8;
    drive_fault expected = of == 0 ? none : classes[code >> 12];
    if (of >> 4 == 0 && of != 0) expected = other;
    if (of >> 4 == 3 && (code >> 4 & 0xF) == 2) expected = under_voltage;
    if (of == 0x73) expected = position_sensor;
    if (of == 0x84 || of == 0x85 || of == 0x86 || of == 0x8A) expected = limit;
    if (code == 0x8250) expected = watchdog;
    r = {};
    REQUIRE(emergency(code) == expected);
    REQUIRE(r.code == code);
    REQUIRE(r.activity == (expected == none ? drive_activity::unknown : drive_activity::faulted));
    REQUIRE(position::decode(position::emergency_frame(static_cast<std::uint16_t>(code)), r));
    REQUIRE(r.code == code);
  }
  for (unsigned word = 0; word < 0x10000; ++word) {
    r = {};
    REQUIRE(position::decode(position::reply(static_cast<std::uint16_t>(word), 0, 0), r));
    REQUIRE(r.state == word);
    REQUIRE((r.activity == drive_activity::enabled) == ((word & 0x6F) == 0x27));
    REQUIRE((r.activity == drive_activity::faulted) == ((word & 0x4F) == 0x08 || (word & 0x4F) == 0x0F));
    REQUIRE((r.fault != none) == (r.activity == drive_activity::faulted));
  }
  REQUIRE(position::decode(position::reply(0x0237, 0, 0), r));
  CHECK(r.activity == drive_activity::enabled);
  REQUIRE(position::decode(classic(standard(0x705), std::array<std::uint8_t, 1>{5}), r));
  CHECK(r.activity == drive_activity::enabled);
  // A boot-up heartbeat: the drive was reset.
  REQUIRE(position::decode(classic(standard(0x705), std::array<std::uint8_t, 1>{0}), r));
  CHECK(r.activity == drive_activity::disabled);
}
