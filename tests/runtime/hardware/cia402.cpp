// CiA 402: status words, the walk to operation enabled against a drive that keeps to the standard, process data, emergencies.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string_view>

#include <cca/hardware/cia402.hpp>

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
      else if (enable && state == cia402_state::switched_on) state = cia402_state::enabled, target = c.position;
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

TEST_CASE("cia402: frames as they are mapped") {
  const auto f = position::set_point({.position = turn}).frames[0];
  CHECK(f == classic(standard(0x205), std::array<std::uint8_t, 8>{0x0F, 0, 0, 0x10, 0, 0, 0, 0}));
  CHECK(torque::set_point({.torque = -0.8}).frames[0] ==
        classic(standard(0x206), std::array<std::uint8_t, 8>{0x0F, 0, 0, 0, 0, 0, 0x18, 0xFC}));
  CHECK(canopen_sync() == can_frame{.id = standard(0x80)});
  CHECK(canopen_start(5) == classic(standard(0), std::array<std::uint8_t, 2>{1, 5}));
}

TEST_CASE("cia402: every number comes back as it was") {
  drive_report r;
  std::uint16_t word = 0;
  drive_command c;
  for (int n = -32767; n <= 32767; ++n) {
    REQUIRE(torque::decode(torque::reply(0x0237, 0, n * 0.0008), r));
    REQUIRE(std::lround(r.torque / 0.0008) == n);
    REQUIRE(torque::hear(torque::set_point({.torque = r.torque}).frames[0], word, c));
    REQUIRE(std::lround(c.torque / 0.0008) == n);
  }
  for (std::int64_t n = -2147483647; n <= 2147483647; n += 65521) {
    REQUIRE(position::decode(position::reply(0x0237, static_cast<double>(n) / 4096 * turn, 0), r));
    REQUIRE(std::llround(r.position / turn * 4096) == n);
    const auto s = position::set_point({.position = r.position});
    REQUIRE(s.cut == 0);
    REQUIRE(position::hear(s.frames[0], word, c));
    REQUIRE(c.position == r.position);
  }
}

TEST_CASE("cia402: from off, and from a fault, to operation enabled, where it stands") {
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

TEST_CASE("cia402: a fault that stays is told") {
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
    REQUIRE(position::decode(classic(standard(0x85), std::array<std::uint8_t, 8>{static_cast<std::uint8_t>(code),
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
  REQUIRE(position::decode(position::reply(0x0237, 0, 0), r));
  CHECK(r.activity == drive_activity::enabled);
  REQUIRE(position::decode(classic(standard(0x705), std::array<std::uint8_t, 1>{5}), r));
  CHECK(r.activity == drive_activity::enabled);
  REQUIRE(position::decode(classic(standard(0x705), std::array<std::uint8_t, 1>{0}), r));  // it has booted: it was reset
  CHECK(r.activity == drive_activity::disabled);
}
