// moteus over CAN FD: the frames of its documentation, every possible number, bytes that make no sense, its
// timeout.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <cca/hardware/moteus.hpp>

#include "../../laws/drive_laws.hpp"
#include "all_numbers.hpp"

using namespace cca::hardware;

namespace {

struct motor {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.05;
};
using servo = moteus<motor, 1>;
using ninth = moteus<motor, 9>;
constexpr double turn = detail::radians_in_turn;
constexpr std::uint32_t stride = 99991;  // step through the bits of all floats

can_frame from_hex(can_id id, std::string_view hex) {
  std::array<std::uint8_t, 64> bytes{};
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  for (std::size_t i = 0; i < hex.size() / 2; ++i)
    bytes[i] = static_cast<std::uint8_t>(digit(hex[2 * i]) << 4 | digit(hex[2 * i + 1]));
  return fd(id, std::span<const std::uint8_t>(bytes.data(), hex.size() / 2), 0x50);
}

static_assert(servo::set_point({.position = 1}).frames[0].length == 48);

struct runs_on : motor {
  static constexpr double run_on = std::numeric_limits<double>::infinity();
};

template <int Milliseconds>
struct waits : motor {
  static constexpr double timeout = Milliseconds / 1000.0;
};

can_frame one_register(moteus_kind kind, moteus_value as, moteus_register which, std::uint32_t bits) {
  can_frame f = fd(extended(servo::reply_number), {});
  register_writer w(f.data);
  w.head(kind, as, which, 1);
  if (kind != moteus_kind::read)
    for (std::size_t i = 0; i < detail::moteus_size(as); ++i)
      w.byte(static_cast<std::uint8_t>(bits >> 8 * i));
  f.length = static_cast<std::uint8_t>(w.size());
  return f;
}

// Every 65521st number of 32 bits, and the ends.
template <class F>
void for_integers(F&& f) {
  for (std::int64_t n = -2147483648; n <= 2147483647; n += 65521) f(static_cast<std::int32_t>(n));
  for (const std::int64_t n :
       std::initializer_list<std::int64_t>{-2147483648, -2147483647, -1, 0, 1, 2147483646, 2147483647})
    f(static_cast<std::int32_t>(n));
}

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

TEST_CASE("moteus: subframes of the diagnostic stream are skipped, wherever they stand") {
  drive_report r;
  const std::string_view reply = "2404000a005000000170ff";
  for (const std::string_view stream : {"4101026f6b", "410100", "4001016f", "420120"}) {
    r = {};
    REQUIRE(servo::decode(from_hex(standard(0x100), std::string(stream) + std::string(reply)), r));
    CHECK(r.position == doctest::Approx(0.008 * turn));
    r = {};
    REQUIRE(servo::decode(from_hex(standard(0x100), std::string(reply) + std::string(stream)), r));
    CHECK(r.torque == doctest::Approx(-1.44));
  }
  r = {};
  CHECK_FALSE(servo::decode(from_hex(standard(0x100), std::string(reply) + std::string("41017f6f")),
                            r));                                           // ends too early
  CHECK_FALSE(servo::decode(from_hex(standard(0x100), "4101026f6b"), r));  // no register
  CHECK(r.frames == 0);
}

TEST_CASE("moteus: a commanded velocity has an end") {
  servo::request q;
  REQUIRE(servo::hear(servo::set_point({.position = 1, .velocity = 2}).frames[0], q));
  CHECK(q.stop_position == doctest::Approx(1 + 2 * 0.005));
  REQUIRE(servo::hear(servo::set_point({.position = 1, .velocity = -2}).frames[0], q));
  CHECK(q.stop_position == doctest::Approx(1 - 2 * 0.005));
  REQUIRE(servo::hear(servo::set_point({.position = 1}).frames[0], q));
  CHECK(std::isnan(q.stop_position));  // nothing moves on
  using until_the_timeout = moteus<runs_on, 1>;
  until_the_timeout::request p;
  REQUIRE(until_the_timeout::hear(until_the_timeout::set_point({.position = 1, .velocity = 2}).frames[0], p));
  CHECK(std::isnan(p.stop_position));
}

TEST_CASE("moteus: can.prefix stands above the other bits of both ids") {
  using far = moteus<motor, 3, 0, 0x123>;
  laws::drive<far>();
  CHECK(far::request_id == extended(0x01238003));
  const can_frame reply = far::reply(10, 1, 0, 0);
  CHECK(reply.id == extended(0x01230300));
  drive_report r;
  CHECK(far::decode(reply, r));
  CHECK_FALSE(moteus<motor, 3>::decode(reply, r));
  CHECK_FALSE(far::decode(moteus<motor, 3>::reply(10, 1, 0, 0), r));
}

TEST_CASE("moteus: a command survives encoding and decoding, floats exactly") {
  servo::request q;
  REQUIRE(
      servo::hear(servo::set_point(
                      {.position = turn, .velocity = -2 * turn, .torque = 3, .stiffness = 40, .damping = 0.5})
                      .frames[0],
                  q));
  CHECK(q.mode == 10);
  CHECK(q.command.position == turn);
  CHECK(q.command.velocity == -2 * turn);
  CHECK(q.command.torque == 3);
  CHECK(q.command.stiffness == 0.5);
  CHECK(q.command.damping == 0.25);
  CHECK(q.most_torque == 12);
  CHECK(q.timeout == doctest::Approx(0.05));
  for (std::uint64_t bits = 0; bits < 0x100000000u; bits += stride) {
    const float x = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (!std::isfinite(x) || (x != 0 && std::fabs(x) < 1.2e-38f)) continue;
    const auto s = servo::set_point({.position = static_cast<double>(x) * turn});
    REQUIRE(servo::hear(s.frames[0], q));
    REQUIRE(static_cast<float>(q.command.position / turn) == x);
  }
}

TEST_CASE("moteus: each number of a command survives encoding and decoding") {
  servo::request q;
  const auto hear = [&q](const auto& s) { return servo::hear(s.frames[0], q); };
  for_floats(stride, [&](float x) {
    if (!std::isfinite(x)) return;
    const double number = static_cast<double>(x), part = std::fabs(number);
    auto s = servo::set_point({.position = number * turn, .velocity = -number * turn});
    REQUIRE(s.cut == 0);
    REQUIRE(hear(s));
    REQUIRE(static_cast<float>(q.command.position / turn) == x);
    REQUIRE(static_cast<float>(q.command.velocity / turn) == -x);
    s = servo::set_point({.torque = number});
    REQUIRE(s.cut == (part > 12 ? of_torque : no_quantity));
    REQUIRE(hear(s));
    REQUIRE(q.command.torque == std::fmax(-12, std::fmin(12, number)));
    s = servo::set_point({}, part);  // the torque that it may use at most
    REQUIRE(hear(s));
    REQUIRE(q.most_torque == part);
    if (part > 1) return;
    s = servo::set_point({.stiffness = part * 80, .damping = part * 2});
    REQUIRE(s.cut == 0);
    REQUIRE(hear(s));
    REQUIRE(static_cast<float>(q.command.stiffness) == static_cast<float>(part));
    REQUIRE(static_cast<float>(q.command.damping) == static_cast<float>(part));
  });
  const auto timeout = [&q](auto drive) {
    using D = decltype(drive);
    REQUIRE(servo::hear(D::set_point({}).frames[0], q));
    CHECK(static_cast<float>(q.timeout) == static_cast<float>(D::motor::timeout));
    REQUIRE(servo::hear(D::stay(), q));
    CHECK(static_cast<float>(q.timeout) == static_cast<float>(D::motor::timeout));
    CHECK(D::watchdog.nanoseconds == std::llround(D::motor::timeout * 1e9));
  };
  timeout(moteus<waits<1>, 1>{});
  timeout(moteus<waits<2>, 1>{});
  timeout(moteus<waits<50>, 1>{});
  timeout(moteus<waits<333>, 1>{});
  timeout(moteus<waits<100'000>, 1>{});
}

// Each register of a request or a reply, in each form, with every number of 8 and 16 bits. Steps:
// registers.md.
TEST_CASE(
    "moteus: every number of a register is read as it was written - the most negative integer means none") {
  using enum moteus_register;
  struct known {
    moteus_register which;
    double steps[3];  // with 8, 16, 32 bits
  };
  const known all[] = {{position, {0.01, 0.0001, 0.00001}},
                       {velocity, {0.1, 0.00025, 0.00001}},
                       {torque, {0.5, 0.01, 0.001}},
                       {voltage, {0.5, 0.1, 0.001}},
                       {temperature, {1, 0.1, 0.001}},
                       {mode, {1, 1, 1}},
                       {fault, {1, 1, 1}},
                       {command_position, {0.01, 0.0001, 0.00001}},
                       {command_velocity, {0.1, 0.00025, 0.00001}},
                       {command_torque, {0.5, 0.01, 0.001}},
                       {stiffness_scale, {1.0 / 127, 1.0 / 32767, 1.0 / 2147483647}},
                       {damping_scale, {1.0 / 127, 1.0 / 32767, 1.0 / 2147483647}},
                       {most_torque, {0.5, 0.01, 0.001}},
                       {command_timeout, {0.01, 0.001, 0.000001}}};
  for (const known& k : all) {
    const auto reads = [&k](moteus_value as, std::uint32_t bits, double expected) {
      const can_frame f = one_register(moteus_kind::reply, as, k.which, bits);
      int seen = 0;
      const bool sound =
          read_registers(f.payload(), [&](moteus_kind kind, std::uint32_t which, double value) {
            const bool same =
                std::isnan(expected) ? std::isnan(value) : value == doctest::Approx(expected).epsilon(1e-14);
            seen += kind == moteus_kind::reply && which == static_cast<std::uint32_t>(k.which) && same;
          });
      return sound && seen == 1;
    };
    for (int n = -127; n <= 127; ++n)
      REQUIRE(reads(moteus_value::int8, static_cast<std::uint8_t>(n), n * k.steps[0]));
    for (int n = -32767; n <= 32767; ++n)
      REQUIRE(reads(moteus_value::int16, static_cast<std::uint16_t>(n), n * k.steps[1]));
    for_integers([&](std::int32_t n) {
      if (n != std::numeric_limits<std::int32_t>::min())
        REQUIRE(reads(moteus_value::int32, static_cast<std::uint32_t>(n), n * k.steps[2]));
    });
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(reads(moteus_value::int8, 0x80, none));
    CHECK(reads(moteus_value::int16, 0x8000, none));
    CHECK(reads(moteus_value::int32, 0x80000000, none));
  }
  for_floats(stride, [](float x) {
    const can_frame f =
        one_register(moteus_kind::reply, moteus_value::float32, velocity, std::bit_cast<std::uint32_t>(x));
    read_registers(f.payload(), [x](moteus_kind, std::uint32_t, double value) {
      REQUIRE((std::isfinite(x) ? value == static_cast<double>(x) : std::isnan(value)));
    });
  });
}

TEST_CASE(
    "moteus: replies in all forms are reported in SI units - NaN and infinity mean that it lacks the "
    "number") {
  using enum moteus_register;
  struct known {
    moteus_register which;
    double drive_report::* where;
    drive_quantity told;
    double unit, steps[3];
  };
  const known all[] = {{position, &drive_report::position, of_position, turn, {0.01, 0.0001, 0.00001}},
                       {velocity, &drive_report::velocity, of_velocity, turn, {0.1, 0.00025, 0.00001}},
                       {torque, &drive_report::torque, of_torque, 1, {0.5, 0.01, 0.001}},
                       {temperature, &drive_report::temperature, of_temperature, 1, {1, 0.1, 0.001}}};
  for (const known& k : all) {
    const auto tells = [&k](moteus_value as, std::uint32_t bits, double expected) {
      drive_report r;
      if (!servo::decode(one_register(moteus_kind::reply, as, k.which, bits), r) || r.told != k.told ||
          r.states != 0)
        return false;
      const double told = r.*k.where / k.unit;
      return std::isfinite(expected) ? told == doctest::Approx(expected).epsilon(1e-14) : std::isnan(told);
    };
    for (int n = -128; n <= 127; ++n)
      REQUIRE(tells(moteus_value::int8, static_cast<std::uint8_t>(n), n == -128 ? NAN : n * k.steps[0]));
    for (int n = -32768; n <= 32767; ++n)
      REQUIRE(tells(moteus_value::int16, static_cast<std::uint16_t>(n), n == -32768 ? NAN : n * k.steps[1]));
    for_integers([&](std::int32_t n) {
      REQUIRE(tells(moteus_value::int32, static_cast<std::uint32_t>(n),
                    n == std::numeric_limits<std::int32_t>::min() ? NAN : n * k.steps[2]));
    });
    for_floats(stride, [&](float x) {
      REQUIRE(tells(moteus_value::float32, std::bit_cast<std::uint32_t>(x), static_cast<double>(x)));
    });
    // Registers that a request writes or asks for are no reply.
    drive_report r;
    CHECK(!servo::decode(one_register(moteus_kind::write, moteus_value::int16, k.which, 1), r));
    CHECK(!servo::decode(one_register(moteus_kind::read, moteus_value::int16, k.which, 0), r));
  }
  // As a virtual drive sends them.
  for_integers([](std::int32_t n) {
    if (n == std::numeric_limits<std::int32_t>::min()) return;
    drive_report r;
    const double x = n;
    REQUIRE(servo::decode(servo::reply(10, x * 1e-5 * turn, -x * 1e-5 * turn, x * 1e-3), r));
    REQUIRE(std::llround(r.position / turn / 1e-5) == n);
    REQUIRE(std::llround(r.velocity / turn / 1e-5) == -std::int64_t{n});
    REQUIRE(std::llround(r.torque / 1e-3) == n);
  });
}

TEST_CASE("moteus: a position beyond 32 bits stays at their end and does not wrap") {
  drive_report r;
  for (const double sign : {-1, 1}) {
    double before = 0;
    for (const double turns : {21474.0, 21474.83646, 21474.83647, 21474.83648, 21475.0, 1e9}) {
      REQUIRE(servo::decode(servo::reply(10, sign * turns * turn, 0, 0), r));
      REQUIRE(sign * r.position >= before);
      REQUIRE(std::fabs(r.position) / turn < 21474.836471);
      before = sign * r.position;
    }
    CHECK(r.position / turn == doctest::Approx(sign * 21474.83647).epsilon(1e-12));
  }
}

TEST_CASE("moteus: each mode and each fault - a reply without a mode reports no activity") {
  using enum drive_fault;
  const std::pair<unsigned, drive_fault> faults[] = {
      {32, configuration},    {33, power_stage},     {34, over_voltage},
      {35, position_sensor},  {36, configuration},   {37, other},
      {38, over_temperature}, {39, limit},           {40, under_voltage},
      {41, configuration},    {42, position_sensor}, {43, position_sensor},
      {44, power_stage},      {45, configuration},   {46, other},
      {47, configuration},    {48, configuration}};
  for (unsigned code = 0; code < 256; ++code) {
    auto expected = other;
    for (const auto& [known, fault] : faults)
      if (known == code) expected = fault;
    drive_report r;
    if (code < 128) {  // as int8, the form that we ask for
      REQUIRE(servo::decode(servo::reply(1, 0, 0, 0, static_cast<std::uint8_t>(code)), r));
      CHECK_MESSAGE(r.fault == expected, code);
      CHECK(r.code == code);
      CHECK(r.activity == drive_activity::faulted);
    }
    REQUIRE(
        servo::decode(one_register(moteus_kind::reply, moteus_value::int16, moteus_register::mode, 1), r));
    REQUIRE(servo::decode(one_register(moteus_kind::reply, moteus_value::int16, moteus_register::fault, code),
                          r));
    CHECK_MESSAGE(r.fault == expected, code);
    CHECK(r.code == code);
  }
  for (unsigned mode = 0; mode < 256; ++mode) {
    drive_report r;
    REQUIRE(
        servo::decode(one_register(moteus_kind::reply, moteus_value::int16, moteus_register::mode, mode), r));
    CHECK(r.state == mode);
    CHECK(r.states == 1);
    CHECK(r.activity == (mode == 0                 ? drive_activity::disabled
                         : mode == 1 || mode == 11 ? drive_activity::faulted
                         : mode <= 4               ? drive_activity::enabling
                                                   : drive_activity::enabled));
  }
  // Without a mode it says nothing about what the drive does, and is not counted as if it did.
  for (const float x : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                        -1.0f, 256.0f, 4e9f}) {
    drive_report r;
    REQUIRE(servo::decode(servo::reply(10, 0, 0, 0), r));
    REQUIRE(servo::decode(one_register(moteus_kind::reply, moteus_value::float32, moteus_register::mode,
                                       std::bit_cast<std::uint32_t>(x)),
                          r));
    CHECK(r.state == 10);
    CHECK(r.activity == drive_activity::enabled);
    CHECK(r.states == 1);
  }
}

TEST_CASE("moteus: stiffness and damping are parts of kp and kd, damping no larger a part than stiffness") {
  servo::request q;
  auto s = servo::set_point({.stiffness = 160, .damping = 1});
  CHECK(s.cut == of_stiffness);
  s = servo::set_point({.stiffness = 8, .damping = 2});
  CHECK(s.cut == of_damping);
  REQUIRE(servo::hear(s.frames[0], q));
  CHECK(q.command.damping == doctest::Approx(0.1));
  CHECK(servo::set_point({.torque = 13, .stiffness = -1}).cut == (of_torque | of_stiffness));
  REQUIRE(servo::hear(servo::stay(), q));
  CHECK(std::isnan(q.command.position));  // means stay here
  CHECK(q.command.stiffness == 1);
}

TEST_CASE("moteus: bytes that make no sense are not taken, not even in part") {
  for (const std::string_view hex : {"24", "2404", "24040a", "24ff0f00", "2c0100", "280400", "40", "60", "ff",
                                     "20ffffffffff0100", "2100", "3001", "1004"}) {
    drive_report r;
    const can_frame f = classic(standard(0x100), from_hex({}, hex).payload().first(hex.size() / 2));
    CHECK_MESSAGE(!servo::decode(f, r), hex);
    CHECK(r.frames == 0);
  }
  drive_report r;
  CHECK(!servo::decode(from_hex(standard(0x100), "2101002404"), r));  // a mode, and then the bytes end
  CHECK(r.activity == drive_activity::unknown);
  CHECK(!servo::decode(from_hex(standard(0x200), "21000a"), r));
  CHECK(!servo::decode(from_hex(standard(0x100), "5050"), r));  // has no contents
  CHECK(servo::decode(from_hex(extended(0x100), "21000a"), r));
}

TEST_CASE("moteus: its timeout is a fault, its limits are not") {
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

TEST_CASE("moteus: enabling stops it first, then holds it where it is") {
  servo::enabling enabling;
  drive_report r;
  REQUIRE(servo::decode(servo::reply(11, 0, 0, 0), r));  // a report from before
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
