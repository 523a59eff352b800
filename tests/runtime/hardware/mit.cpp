// The MIT mini-cheetah protocol: known frames, every possible number, special frames, NaN and infinity,
// replies.
#include <doctest/doctest.h>

#include <array>
#include <limits>

#include <cca/hardware/mit.hpp>

#include "../../laws/drive_laws.hpp"

using namespace cca::hardware;

namespace {

using ak = mit_drive<ak80_9, 3>;
using cheetah = mit_drive<ak80_6, 7, 0x100, mit_firmware::original>;
using damiao = mit_drive<ak70_10, 5, 0x15, mit_firmware::damiao>;
using wire = mit_wire<ak80_9>;

std::array<std::uint8_t, 8> bytes(const can_frame& f) {
  std::array<std::uint8_t, 8> b{};
  std::copy_n(f.data.begin(), 8, b.begin());
  return b;
}

// Frames are known at compile time.
static_assert(ak::set_point({.position = 1, .stiffness = 20, .damping = 0.5}).frames[0].id == standard(3));

}  // namespace

TEST_CASE("mit: the laws of a drive") {
  laws::drive<ak>();
  laws::drive<cheetah>();
  laws::drive<damiao>();
}

TEST_CASE("mit: the zero command is the frame that every driver sends") {
  CHECK(bytes(ak::still()) == std::array<std::uint8_t, 8>{0x7F, 0xFF, 0x7F, 0xF0, 0x00, 0x00, 0x07, 0xFF});
}

TEST_CASE("mit: each number has its place") {
  const auto at = [](drive_command c) { return bytes(ak::set_point(c).frames[0]); };
  CHECK(at({.position = 12.5, .velocity = -50, .torque = -18}) ==
        std::array<std::uint8_t, 8>{0xFF, 0xFF, 0, 0, 0, 0, 0, 0});
  CHECK(at({.position = -12.5, .velocity = 50, .torque = -18}) ==
        std::array<std::uint8_t, 8>{0, 0, 0xFF, 0xF0, 0, 0, 0, 0});
  CHECK(at({.position = -12.5, .velocity = -50, .torque = -18, .stiffness = 500}) ==
        std::array<std::uint8_t, 8>{0, 0, 0, 0x0F, 0xFF, 0, 0, 0});
  CHECK(at({.position = -12.5, .velocity = -50, .torque = -18, .damping = 5}) ==
        std::array<std::uint8_t, 8>{0, 0, 0, 0, 0, 0xFF, 0xF0, 0});
  CHECK(at({.position = -12.5, .velocity = -50, .torque = 18}) ==
        std::array<std::uint8_t, 8>{0, 0, 0, 0, 0, 0, 0x0F, 0xFF});
}

TEST_CASE("mit: every number of a command survives encoding and decoding") {
  const auto back = [](const wire::command& w) {
    std::uint8_t cut = 0;
    const auto again = wire::to_wire(wire::from_wire(w), cut);
    const can_frame f = wire::frame(standard(3), w);
    return cut == 0 && again == w && wire::read(std::span<const std::uint8_t, 8>(f.data.data(), 8)) == w;
  };
  for (std::uint32_t p = 0; p <= 0xFFFF; ++p) REQUIRE(back({.position = p}));
  for (std::uint32_t n = 0; n <= 0xFFF; ++n) {
    REQUIRE(back({.velocity = n}));
    REQUIRE(back({.stiffness = n}));
    REQUIRE(back({.damping = n}));
    REQUIRE(back({.torque = n}));
    REQUIRE(back({.position = n * 15,
                  .velocity = 0xFFF - n,
                  .stiffness = n ^ 0x555,
                  .damping = (n * 7) & 0xFFF,
                  .torque = (n * 11) & 0xFFF}));
  }
}

TEST_CASE("mit: every number of a reply survives encoding and decoding") {
  drive_report r;
  for (std::uint32_t p = 0; p <= 0xFFFF; ++p) {
    REQUIRE(ak::decode(ak::reply(wire::position.from_step(p), 0, 0), r));
    REQUIRE(r.position == wire::position.from_step(p));
    REQUIRE(((r.at_end & of_position) != 0) == (p == 0 || p == 0xFFFF));
  }
  for (std::uint32_t n = 0; n <= 0xFFF; ++n) {
    REQUIRE(ak::decode(ak::reply(1, wire::velocity.from_step(n), wire::torque.from_step(0xFFF - n)), r));
    REQUIRE(r.velocity == wire::velocity.from_step(n));
    REQUIRE(r.torque == wire::torque.from_step(0xFFF - n));
  }
}

TEST_CASE("mit: no command looks like a special frame") {
  const auto is_special = [](const can_frame& f) {
    for (std::size_t i = 0; i < 7; ++i)
      if (f.data[i] != 0xFF) return false;
    return f.data[7] >= 0xFB && f.data[7] <= 0xFE;
  };
  const double step = 36.0 / 4095;
  int near = 0;
  for (double torque = 17.9; torque < 18.2; torque += step / 10) {
    const auto asked =
        ak::set_point({.position = 99, .velocity = 99, .torque = torque, .stiffness = 999, .damping = 99});
    CHECK(!is_special(asked.frames[0]));
    near += asked.frames[0].data[7] == 0xFA;
    const auto sent =
        wire::from_wire(wire::read(std::span<const std::uint8_t, 8>(asked.frames[0].data.data(), 8)));
    CHECK(sent.torque <= torque + step);
    CHECK(sent.torque >= std::min(torque, 18.0) - 5 * step);
  }
  CHECK(near >= 40);
  CHECK(is_special(mit_special_frame(standard(3), mit_special::enter)));
  // With one number lower it does not look like one, and is left alone.
  CHECK(ak::set_point(
            {.position = 99, .velocity = 99, .torque = 18 - 3 * step, .stiffness = 499, .damping = 99})
            .frames[0]
            .data[7] == 0xFC);
}

TEST_CASE("mit: the original firmware answers with 6 bytes or, with the supply's voltage, with 7") {
  drive_report r, longer;
  can_frame f = cheetah::reply(1, 2, 3);
  CHECK(f.length == 6);
  REQUIRE(cheetah::decode(f, r));
  f.length = 7;
  f.data[6] = 0x18;
  REQUIRE(cheetah::decode(f, longer));
  CHECK(longer.position == r.position);
  CHECK(longer.velocity == r.velocity);
  CHECK(longer.torque == r.torque);
  CHECK(longer.told == r.told);
  for (const unsigned length : {5u, 8u}) {
    f.length = static_cast<std::uint8_t>(length);
    CHECK_FALSE(cheetah::decode(f, r));
  }
  static_assert(cheetah::traffic[1].shape.length == 7);
}

TEST_CASE("mit: NaN does not become the end of a range") {
  drive_command c{.stiffness = 100};
  c.position = std::numeric_limits<double>::quiet_NaN();
  const auto asked = ak::set_point(c);
  CHECK(!asked.finite);
  CHECK(asked.frames.empty());
}

TEST_CASE("mit: replies of other drives, lengths and kinds are not taken") {
  drive_report r;
  const can_frame good = ak::reply(1, 2, 3);
  REQUIRE(ak::decode(good, r));
  CHECK(r.position == doctest::Approx(1).epsilon(1e-3));
  CHECK(r.velocity == doctest::Approx(2).epsilon(1e-2));
  CHECK(r.torque == doctest::Approx(3).epsilon(1e-2));
  CHECK(r.temperature == 25);
  using other = mit_drive<ak80_9, 4>;
  CHECK(!ak::decode(other::reply(1, 2, 3), r));
  for (const unsigned length : {0u, 5u, 6u, 7u}) {
    can_frame f = good;
    f.length = static_cast<std::uint8_t>(length);
    CHECK(!ak::decode(f, r));
  }
  can_frame f = good;
  f.fd = true;
  CHECK(!ak::decode(f, r));
  f = good;
  f.remote = true;
  CHECK(!ak::decode(f, r));
  f = good;
  f.id = extended(0);
  CHECK(!ak::decode(f, r));
  CHECK(r.frames == 1);
}

TEST_CASE("mit: faults of AK and Damiao") {
  drive_report r;
  const drive_fault known[] = {drive_fault::none,
                               drive_fault::over_temperature,
                               drive_fault::over_current,
                               drive_fault::over_voltage,
                               drive_fault::under_voltage,
                               drive_fault::position_sensor,
                               drive_fault::over_temperature};
  for (std::uint32_t code = 0; code < 256; ++code) {
    REQUIRE(ak::decode(ak::reply(0, 0, 0, 40, code), r));
    CHECK(r.fault == (code < 7 ? known[code] : drive_fault::other));
    CHECK(r.code == code);
    CHECK((r.activity == drive_activity::faulted) == (code != 0));
  }
  REQUIRE(damiao::decode(damiao::reply(0, 0, 0, 40, 1), r));
  CHECK(r.activity == drive_activity::enabled);
  REQUIRE(damiao::decode(damiao::reply(0, 0, 0, 40, 0), r));
  CHECK(r.activity == drive_activity::disabled);
  REQUIRE(damiao::decode(damiao::reply(0, 0, 0, 40, 0xD), r));
  CHECK(r.fault == drive_fault::watchdog);
  CHECK(!damiao::decode(damiao::reply(0, 0, 0).id == standard(0x15)
                            ? mit_drive<ak70_10, 6, 0x15, mit_firmware::damiao>::reply(0, 0, 0)
                            : can_frame{},
                        r));
  REQUIRE(cheetah::decode(cheetah::reply(1, 2, 3), r));
  CHECK(cheetah::reply(1, 2, 3).length == 6);
}

TEST_CASE("mit: enters with a zero command, and is enabled with its answer") {
  ak::enabling enabling;
  drive_report r;
  const auto first = enabling.next(r);
  REQUIRE(first.frames.size() == 3);
  CHECK(first.frames[0] == ak::still());
  CHECK(first.frames[1] == mit_special_frame(standard(3), mit_special::enter));
  CHECK(first.frames[2] == ak::still());
  CHECK(enabling.next(r).progress == enable_progress::going);
  REQUIRE(ak::decode(ak::reply(0.3, 0, 0), r));
  CHECK(enabling.next(r).progress == enable_progress::done);

  ak::enabling again;
  again.next(r);
  REQUIRE(ak::decode(ak::reply(0.3, 0, 0, 90, 1), r));
  CHECK(again.next(r).progress == enable_progress::failed);
}
