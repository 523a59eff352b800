// moteus over CAN FD: the frames of its documentation, every representable number, bytes that make no sense, its timeout.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>

#include <cca/hardware/moteus.hpp>

#include "../../laws/drive_laws.hpp"

using namespace cca::hardware;

namespace {

struct motor {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.05;
};
using servo = moteus<motor, 1>;
using ninth = moteus<motor, 9>;
constexpr double turn = detail::radians_in_turn;

can_frame from_hex(can_id id, std::string_view hex) {
  std::array<std::uint8_t, 64> bytes{};
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  for (std::size_t i = 0; i < hex.size() / 2; ++i)
    bytes[i] = static_cast<std::uint8_t>(digit(hex[2 * i]) << 4 | digit(hex[2 * i + 1]));
  return fd(id, std::span<const std::uint8_t>(bytes.data(), hex.size() / 2), 0x50);
}

static_assert(servo::set_point({.position = 1}).frames[0].length == 48);

}  // namespace

TEST_CASE("moteus: the laws of a drive") {
  laws::drive<servo>();
  laws::drive<ninth>();
}

TEST_CASE("moteus: the request and the reply of its documentation") {
  servo::request q;
  REQUIRE(servo::hear(from_hex(extended(0x8001), "01000a07206000200150ff140400130d"), q));
  CHECK(q.mode == 10);
  CHECK(q.command.position == doctest::Approx(0.0096 * turn));
  CHECK(q.command.velocity == doctest::Approx(0.072 * turn));
  CHECK(q.command.torque == doctest::Approx(-1.76));
  CHECK(q.command.stiffness == 1);

  drive_report r;
  REQUIRE(servo::decode(from_hex(standard(0x100), "2404000a005000000170ff230d181400"), r));
  CHECK(r.state == 10);
  CHECK(r.activity == drive_activity::enabled);
  CHECK(r.position == doctest::Approx(0.008 * turn));
  CHECK(r.velocity == doctest::Approx(0.064 * turn));
  CHECK(r.torque == doctest::Approx(-1.44));
  CHECK(r.temperature == 20);
  CHECK(r.fault == drive_fault::none);
}

TEST_CASE("moteus: a command is heard as it was given, floats exactly") {
  servo::request q;
  REQUIRE(servo::hear(
      servo::set_point({.position = turn, .velocity = -2 * turn, .torque = 3, .stiffness = 40, .damping = 0.5}).frames[0], q));
  CHECK(q.mode == 10);
  CHECK(q.command.position == turn);
  CHECK(q.command.velocity == -2 * turn);
  CHECK(q.command.torque == 3);
  CHECK(q.command.stiffness == 0.5);
  CHECK(q.command.damping == 0.25);
  CHECK(q.most_torque == 12);
  CHECK(q.timeout == doctest::Approx(0.05));
  for (std::uint64_t bits = 0; bits < 0x100000000u; bits += 99991) {
    const float x = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (!std::isfinite(x) || (x != 0 && std::fabs(x) < 1.2e-38f)) continue;
    const auto s = servo::set_point({.position = static_cast<double>(x) * turn});
    REQUIRE(servo::hear(s.frames[0], q));
    REQUIRE(static_cast<float>(q.command.position / turn) == x);
  }
}

TEST_CASE("moteus: every integer of a reply comes back as it was, the most negative is none") {
  drive_report r;
  can_frame f = from_hex(standard(0x100), "24040000000000000000000000");
  for (int n = -32768; n <= 32767; ++n) {
    for (const std::size_t at : {5u, 7u, 9u}) detail::put(f.data, at, static_cast<std::uint16_t>(n));
    REQUIRE(servo::decode(f, r));
    if (n == -32768) {
      CHECK(std::isnan(r.position));
      CHECK(std::isnan(r.torque));
      continue;
    }
    REQUIRE(std::lround(r.position / turn / 0.0001) == n);
    REQUIRE(std::lround(r.velocity / turn / 0.00025) == n);
    REQUIRE(std::lround(r.torque / 0.01) == n);
  }
  for (std::int64_t n = -2147483647; n <= 2147483647; n += 65521) {
    const double position = static_cast<double>(n) * 1e-5 * turn;
    REQUIRE(servo::decode(servo::reply(10, position, 0, 0), r));
    REQUIRE(std::llround(r.position / turn / 1e-5) == n);
  }
}

TEST_CASE("moteus: stiffness and damping are parts of its own, damping no larger a part") {
  servo::request q;
  auto s = servo::set_point({.stiffness = 160, .damping = 1});
  CHECK(s.cut == of_stiffness);
  s = servo::set_point({.stiffness = 8, .damping = 2});
  CHECK(s.cut == of_damping);
  REQUIRE(servo::hear(s.frames[0], q));
  CHECK(q.command.damping == doctest::Approx(0.1));
  CHECK(servo::set_point({.torque = 13, .stiffness = -1}).cut == (of_torque | of_stiffness));
  REQUIRE(servo::hear(servo::stay(), q));
  CHECK(std::isnan(q.command.position));  // on this bus: stay
  CHECK(q.command.stiffness == 1);
}

TEST_CASE("moteus: bytes that make no sense are not taken, whole or in part") {
  for (const std::string_view hex :
       {"24", "2404", "24040a", "24ff0f00", "2c0100", "280400", "40", "60", "ff", "20ffffffffff0100", "2100", "3001", "1004"}) {
    drive_report r;
    const can_frame f = classic(standard(0x100), from_hex({}, hex).payload().first(hex.size() / 2));
    CHECK_MESSAGE(!servo::decode(f, r), hex);
    CHECK(r.frames == 0);
  }
  drive_report r;
  CHECK(!servo::decode(from_hex(standard(0x100), "2101002404"), r));  // a mode, and then the bytes end
  CHECK(r.activity == drive_activity::unknown);
  CHECK(!servo::decode(from_hex(standard(0x200), "21000a"), r));
  CHECK(!servo::decode(from_hex(standard(0x100), "5050"), r));  // says nothing
  CHECK(servo::decode(from_hex(extended(0x100), "21000a"), r));
}

TEST_CASE("moteus: its timeout is a fault, its limits are none") {
  drive_report r;
  REQUIRE(servo::decode(servo::reply(11, 0, 0, 0), r));
  CHECK(r.activity == drive_activity::faulted);
  CHECK(r.fault == drive_fault::watchdog);
  REQUIRE(servo::decode(servo::reply(10, 0, 0, 0, 99), r));
  CHECK(r.activity == drive_activity::enabled);
  CHECK(r.fault == drive_fault::none);
  CHECK(r.code == 99);
  REQUIRE(servo::decode(servo::reply(1, 0, 0, 0, 38), r));
  CHECK(r.fault == drive_fault::over_temperature);
  CHECK(servo::watchdog.nanoseconds == 50'000'000);
}

TEST_CASE("moteus: stopped first, then held where it is") {
  servo::enabling enabling;
  drive_report r;
  REQUIRE(servo::decode(servo::reply(11, 0, 0, 0), r));  // from before
  auto s = enabling.next(r);
  CHECK(s.frames[0] == servo::disable()[0]);
  REQUIRE(servo::decode(servo::reply(0, 0, 0, 0), r));
  s = enabling.next(r);
  CHECK(s.frames[0].payload()[2] == 10);
  CHECK(s.progress == enable_progress::going);
  REQUIRE(servo::decode(servo::reply(10, 0, 0, 0), r));
  CHECK(enabling.next(r).progress == enable_progress::done);
  REQUIRE(servo::decode(servo::reply(1, 0, 0, 0, 39), r));
  CHECK(enabling.next(r).progress == enable_progress::failed);
}
