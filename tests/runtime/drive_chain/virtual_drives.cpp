// The laws of a virtual drive for every family, and what only one family does.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include <cca/hardware/virtual_cia402.hpp>
#include <cca/hardware/virtual_mit.hpp>
#include <cca/hardware/virtual_moteus.hpp>
#include <cca/hardware/virtual_odrive.hpp>
#include <cca/hardware/virtual_robstride.hpp>

#include "../../laws/virtual_drive_laws.hpp"

namespace {

using namespace cca::hardware;

template <class Virtual, std::uint32_t Code, drive_fault Fault, drive_fault Unfed = drive_fault::watchdog>
struct rig {
  using drive = Virtual;
  static constexpr std::uint32_t code = Code;
  static constexpr drive_fault fault = Fault, unfed = Unfed;
  static drive_frames no_number() { return {}; }  // every step and count is a number
};

struct ak : rig<virtual_mit<mit_drive<ak60_6, 9>>, 2, drive_fault::over_current> {};
struct damiao : rig<virtual_mit<mit_drive<ak60_6, 3, 0, mit_firmware::damiao>, 5'000'000>,
                    0xA,
                    drive_fault::over_current> {};

// Floats can be NaN: each of them in turn.
template <class Drive, class Base>
struct odrive_rig : Base {
  static drive_frames no_number() {
    drive_frames all;
    for (const std::size_t at : {0u, 4u}) {
      can_frame f = Drive::set_point({.position = laws::virtual_drives::starts_at}).frames[0];
      detail::put_float(f.data, at, std::numeric_limits<float>::quiet_NaN());
      if (at < f.length && (at == 0 || Drive::by_velocity)) all.add(f);
    }
    return all;
  }
};
template <class Drive, std::int64_t Timeout, std::uint32_t Code, drive_fault Fault>
using odrive_of = odrive_rig<Drive, rig<virtual_odrive<Drive, Timeout>, Code, Fault>>;

struct by_position
    : odrive_of<odrive<1, odrive_mode::position>, 50'000'000, 0x1000, drive_fault::over_current> {};
struct by_velocity
    : odrive_of<odrive<2, odrive_mode::velocity>, 50'000'000, 0x2000, drive_fault::over_temperature> {};
struct by_torque
    : odrive_of<odrive<0x1234, odrive_mode::torque>, 50'000'000, 0x8, drive_fault::position_sensor> {};
struct old : odrive_of<odrive<4, odrive_mode::position, odrive_firmware::v0_5>,
                       80'000'000,
                       0x4,
                       drive_fault::over_voltage> {};

// Its encoder counts one turn, before a gear of 6.
template <class Virtual>
struct one_turn : Virtual {
  static constexpr double width = 2 * std::numbers::pi / 6;
  drive_frames answer(drive_motion m) {
    m.position = std::remainder(m.position, width);
    return Virtual::answer(m);
  }
};
using turning = odrive<5, odrive_mode::torque>;
struct wrapping
    : odrive_rig<turning,
                 rig<one_turn<virtual_odrive<turning, 50'000'000>>, 0x8, drive_fault::position_sensor>> {
  static constexpr double wraps = one_turn<virtual_odrive<turning, 50'000'000>>::width;
};

struct n1 {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.02;
  static constexpr double run_on = std::numeric_limits<double>::infinity();
};
struct n1_with_stop : n1 {
  static constexpr double run_on = 0.005;
};
using hip = moteus<n1, 3>;
template <moteus_timeout Then>
struct moteus_rig : rig<virtual_moteus<hip, Then>, 38, drive_fault::over_temperature> {
  static drive_frames no_number() {
    drive_frames all{hip::stay()};
    for (std::size_t at = 6; at < 6 + 5 * 4; at += 4) {  // after the mode and the head of the floats
      can_frame f =
          hip::set_point({.position = laws::virtual_drives::starts_at, .stiffness = 20, .damping = 0.1})
              .frames[0];
      detail::put_float(f.data, at, std::numeric_limits<float>::quiet_NaN());
      all.add(f);
    }
    return all;
  }
};

struct strong
    : rig<virtual_robstride<robstride<rs04, 3>>, 4, drive_fault::over_temperature, drive_fault::none> {};
struct small : rig<virtual_robstride<robstride<cybergear, 127, 0>, 50'000'000>,
                   1,
                   drive_fault::under_voltage,
                   drive_fault::none> {};

struct epos {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 65536, torque = 0.8;
};
using knee = cia402<epos, 5, cia402_mode::position>;
using ankle = cia402<epos, 6, cia402_mode::torque>;
struct with_fault : rig<virtual_cia402<knee>, 0x2310, drive_fault::over_current> {};
struct with_quick_stop : rig<virtual_cia402<ankle, 10'000'000, cia402_lost::quick_stop>,
                             0x4210,
                             drive_fault::over_temperature,
                             drive_fault::none> {};

template <class Virtual>
using bench = laws::virtual_drives::bench<Virtual>;
using laws::virtual_drives::gives_way;

}  // namespace

TEST_SUITE("virtual drives") {
  TEST_CASE_TEMPLATE("the laws", Rig, ak, damiao, by_position, by_velocity, by_torque, wrapping, old,
                     moteus_rig<moteus_timeout::stop>, moteus_rig<moteus_timeout::zero_velocity>,
                     moteus_rig<moteus_timeout::brake>, strong, small, with_fault, with_quick_stop) {
    laws::virtual_drive<Rig>();
  }

  TEST_CASE("mit: entering without a zero command makes the drive jerk, as its firmware does") {
    using D = mit_drive<ak60_6, 9>;
    virtual_mit<D> v;
    v.hear(D::set_point({.position = 1, .stiffness = 20}).frames[0], 0);
    CHECK(gives_way(v.law(0)));
    v.hear(mit_special_frame(D::request_id, mit_special::enter), 1'000'000);
    CHECK(v.law(1'000'000).stiffness > 19);
    CHECK(gives_way(v.law(20'000'001)));  // the special frame did not feed it
  }

  TEST_CASE("odrive: position control begins where the drive is, whatever the last command was") {
    using D = odrive<1, odrive_mode::position>;
    by_position::drive v;
    v.answer({.position = 0.7});
    v.hear(D::set_point({.position = 3}).frames[0], 0);
    v.hear(D::axis_state(8), 0);
    CHECK(v.law(0).position == 0.7);
  }

  TEST_CASE("odrive: it sends by itself, and the watchdog of 0.5 runs out in idle too") {
    bench<by_position::drive> b;
    b.beats(1000);
    CHECK(b.report.states == 10);
    CHECK(b.report.frames == 110);
    CHECK(b.report.fault == drive_fault::none);
    bench<old::drive> o;
    o.beats(300);
    CHECK(o.report.fault == drive_fault::watchdog);
    CHECK(o.enable());
  }

  TEST_CASE("odrive: an error, also the emergency stop, keeps it from closed loop until it is cleared") {
    using D = odrive<1, odrive_mode::position>;
    bench<by_position::drive> b;
    REQUIRE(b.enable());
    b.beat({D::estop()});
    b.beats(200, {D::axis_state(8)});
    CHECK_FALSE(b.v.enabled());
    CHECK(b.report.fault == drive_fault::emergency_stop);
    b.beat({D::clear_errors()});
    CHECK_FALSE(b.v.enabled());
    b.beat({D::axis_state(8)});
    CHECK(b.v.enabled());
  }

  TEST_CASE(
      "moteus: a position moves on with its velocity, brake damps, and a command may have its own timeout") {
    virtual_moteus<hip> v;
    v.hear(hip::set_point({.position = 1, .velocity = 2, .stiffness = 40, .damping = 1}).frames[0], 0);
    CHECK(v.law(10'000'000).position == doctest::Approx(1.02));
    CHECK(v.law(10'000'000).stiffness == doctest::Approx(40));
    v.hear(hip::brake(), 10'000'000);
    CHECK(gives_way(v.law(10'000'000)));
    CHECK(v.law(1'000'000'000).damping == 2);
    v.hear(hip::disable()[0], 1'000'000'000);
    CHECK(v.law(1'000'000'000).damping == 0);
    can_frame f = hip::stay();
    detail::put_float(f.data, 6 + 7 * 4, 0.5f);  // the timeout, after seven floats
    v.hear(f, 2'000'000'000);
    CHECK(v.law(2'499'000'000).stiffness == 80);
    CHECK(gives_way(v.law(2'501'000'000)));
  }

  TEST_CASE("moteus: a command of a controller that died moves on for run_on and no longer") {
    using D = moteus<n1_with_stop, 3>;
    virtual_moteus<D, moteus_timeout::hold, 10.0> v;
    v.hear(D::set_point({.position = 1, .velocity = 13.5, .stiffness = 40}).frames[0], 0);
    CHECK(v.law(1'000'000).position == doctest::Approx(1 + 0.0135));  // until the next command, as before
    CHECK(v.law(1'000'000).velocity == doctest::Approx(13.5));
    for (const std::int64_t later : {5'100'000, 19'000'000, 21'000'000, 900'000'000}) {
      CHECK(v.law(later).position == doctest::Approx(1 + 13.5 * 0.005));
      CHECK(v.law(later).velocity == 0);
    }
  }

  TEST_CASE("moteus: in timeout mode 10 it slows down to 0 and holds there until it is stopped") {
    const auto go = hip::set_point({.position = 1, .velocity = 2, .stiffness = 40, .damping = 1}).frames[0];
    constexpr std::int64_t timeout = 20'000'000;
    virtual_moteus<hip, moteus_timeout::hold, 10.0> v;
    v.hear(go, 0);
    CHECK(v.law(timeout - 1000).stiffness == doctest::Approx(40));  // until the timeout, as commanded
    CHECK(v.law(timeout - 1000).position == doctest::Approx(1.04));
    const drive_command slowing = v.law(timeout + 100'000'000);
    CHECK(slowing.position == doctest::Approx(1.04 + 2 * 0.1 - 0.5 * 10 * 0.1 * 0.1));
    CHECK(slowing.velocity == doctest::Approx(1));
    CHECK(slowing.stiffness == 80);  // all of kp, whatever part the command had
    CHECK(slowing.damping == 2);
    const drive_command still = v.law(timeout + 5'000'000'000);
    CHECK(still.position == doctest::Approx(1.04 + 0.5 * 2 * 2 / 10));
    CHECK(still.velocity == 0);
    CHECK(still.torque == 0);
    CHECK_FALSE(v.enabled());
    v.hear(go, timeout + 6'000'000'000);  // too late: it stays there
    CHECK(laws::virtual_drives::same(v.law(timeout + 6'000'000'000), still));
    v.hear(hip::disable()[0], timeout + 7'000'000'000);
    CHECK(gives_way(v.law(timeout + 7'000'000'000)));

    virtual_moteus<hip, moteus_timeout::hold> at_once;
    at_once.hear(go, 0);
    CHECK(at_once.law(timeout + 1'000'000).position == doctest::Approx(1.04));
    CHECK(at_once.law(timeout + 1'000'000).velocity == 0);
    CHECK(at_once.law(timeout + 900'000'000).position == doctest::Approx(1.04));
    virtual_moteus<hip, moteus_timeout::hold, 10.0> backwards;
    backwards.hear(hip::set_point({.position = 1, .velocity = -2, .stiffness = 40}).frames[0], 0);
    CHECK(backwards.law(timeout + 5'000'000'000).position == doctest::Approx(0.96 - 0.2));
  }

  TEST_CASE("odrive: a state request feeds the watchdog of 0.6 as a set point does") {
    using D = odrive<1, odrive_mode::position>;
    bench<by_position::drive> b;
    REQUIRE(b.enable());
    b.beats(40, b.go());
    b.beats(40);
    b.beat({D::axis_state(8)});
    b.beats(40);
    CHECK(b.v.enabled());
    b.beats(20);
    CHECK_FALSE(b.v.enabled());
  }

  TEST_CASE("robstride: enabling without a zero command makes the drive jerk, as its protocol allows") {
    using D = robstride<rs04, 3>;
    virtual_robstride<D> v;
    v.hear(D::set_point({.position = 1, .stiffness = 20}).frames[0], 0);
    CHECK(gives_way(v.law(0)));
    v.hear(D::enable(), 1'000'000);
    CHECK(v.law(1'000'000).stiffness > 19);
    CHECK_FALSE(gives_way(v.law(21'000'000)));  // the frame for enabling fed it
    CHECK(gives_way(v.law(21'000'001)));
  }

  TEST_CASE("robstride: in another mode than operation control a command moves nothing") {
    using D = robstride<rs04, 3>;
    bench<virtual_robstride<D>> b;
    REQUIRE(b.enable());
    REQUIRE(b.follows());
    b.beats(5, {D::stop(), D::run_mode(2), D::enable()});
    CHECK(b.report.activity == drive_activity::enabled);
    CHECK_FALSE(b.follows());
    REQUIRE(b.enable());  // which asks for operation control
    CHECK(b.follows());
  }

  TEST_CASE("robstride: with a fault it is not enabled until that is cleared") {
    using D = robstride<rs04, 3>;
    bench<virtual_robstride<D>> b;
    REQUIRE(b.enable());
    b.v.fail(8);
    b.beats(3, {D::stop(), D::enable()});
    CHECK(b.report.fault == drive_fault::position_sensor);
    CHECK_FALSE(b.v.enabled());
    b.beat({D::clear_fault(), D::enable()});
    CHECK(b.v.enabled());
  }

  TEST_CASE("cia402: NMT and SYNC are needed - after a quick stop the drive is off") {
    using V = virtual_cia402<knee, 20'000'000, cia402_lost::quick_stop>;
    V v;
    for (int i = 0; i < 10; ++i)
      for (const std::uint16_t word : {std::uint16_t{6}, std::uint16_t{7}, std::uint16_t{15}})
        v.hear(knee::control(word), i), v.hear(canopen_sync(), i);
    CHECK(v.now_in() == cia402_state::switch_on_disabled);  // pre-operational: process data is ignored
    v.hear(canopen_start(4), 20);
    v.hear(knee::control(6), 20), v.hear(canopen_sync(), 20);
    CHECK(v.now_in() == cia402_state::switch_on_disabled);  // that was another node
    v.hear(canopen_start(0), 30);
    v.hear(knee::control(6), 30);
    CHECK(v.now_in() == cia402_state::switch_on_disabled);  // it waits for SYNC
    v.hear(canopen_sync(), 30);
    CHECK(v.now_in() == cia402_state::ready);
    for (const std::uint16_t word : {std::uint16_t{7}, std::uint16_t{15}})
      v.hear(knee::control(word), 40), v.hear(canopen_sync(), 40);
    CHECK(v.enabled());
    for (const can_frame& f : knee::quick_stop()) v.hear(f, 50);
    v.hear(canopen_sync(), 50);
    CHECK(v.now_in() == cia402_state::quick_stop);
    CHECK(v.law(50).damping > 0);
    v.answer({.velocity = 1});
    CHECK(v.now_in() == cia402_state::quick_stop);
    v.answer({.velocity = 0});
    CHECK(v.now_in() == cia402_state::switch_on_disabled);
  }

  TEST_CASE("cia402: without SYNC no set point is taken, and the watchdog notices") {
    bench<virtual_cia402<knee>> b;
    REQUIRE(b.enable());
    for (std::int64_t k = 0; k < 30; ++k) {
      for (const can_frame& f : b.go()) b.v.hear(f, b.now + k * 1'000'000);
      CHECK(gives_way(b.v.law(b.now + k * 1'000'000)) == (k >= 20));
    }
    CHECK(b.v.now_in() == cia402_state::fault);
    bench<virtual_cia402<knee>> c;
    REQUIRE(c.enable());
    c.v.hear(canopen_stop(5), c.now);
    CHECK(c.v.now_in() == cia402_state::fault);
    CHECK(c.enable());
  }
}
