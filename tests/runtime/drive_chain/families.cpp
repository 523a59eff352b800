// One robot with all families of drives: moteus on CAN FD, RobStride with ids of 29 bits, ODrive, CiA 402
// with its SYNC, MIT. Eight plain motors are its mechanics.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <doctest/doctest.h>

#include <cca/cca.hpp>

#include "../../laws/families_oncilla.hpp"
#include "../../laws/robot_lab.hpp"

namespace {

namespace hw = cca::hardware;
namespace sim = cca::sim;
using namespace families;

struct robot : families::robot<laws::lab_end> {};

// The ODrive in position mode leaves out the stiffness of its hip; without the hint it would be refused.
struct without_hint : oncilla::as_built {
  using commands = cca::robots::commands<
      cca::robots::of_joints<"stiffness", cca::robots::stiffness_command, oncilla::hip_stiffnesses>>;
};
static_assert(hw::detail::followers<oncilla::as_built, joints, cca::axes<>>::all &&
              !hw::detail::followers<without_hint, joints, cca::axes<>>::all);

using plan = hw::robot_buses<cca::rate<1000>, board, joints>;
static_assert(plan::load<0> < 0.6);
static_assert(plan::load<2> > 0.75 && plan::load<2> < 0.9);                  // SYNC counts once
static_assert(plan::requests<2>.count == 4 && plan::replies<2>.count == 8);  // with NMT and SYNC
static_assert(hw::cycle_ends<3, left_front_knee, right_front_knee>()[2].size() == 1);

constexpr std::size_t count = joints::count;
constexpr auto faults = []<class... J>(hw::joint_list<J...>) { return std::array{J::fault...}; }(joints());
constexpr double way = 0.15, none = std::numeric_limits<double>::quiet_NaN();

struct posture {
  auto process() -> cca::out<"angles", sim::leg_angles> {
    sim::leg_angles::vector_type v;
    for (std::size_t i = 0; i < count; ++i)
      v[static_cast<Eigen::Index>(i)] = laws::middle_of<joints>(i) + way;
    return v;
  }
};

struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"posture", posture>,
                                 cca::node<"limits", cca::limiter<sim::leg_angles>>,
                                 cca::node<"robot", robot>,
                                 cca::wire<"posture.angles", "limits.command">,
                                 cca::wire<"limits.safe", "robot.command">> {};

struct lab : laws::robot_lab<robot, architecture> {
  lab() : robot_lab(false) {
    controller.load();
    heard = [this](std::size_t, const hw::can_frame& f) { syncs += f == hw::canopen_sync(); };
  }
  // A drive that takes torque alone is damped by torque against its speed.
  bool all_give_way() const {
    for (std::size_t i = 0; i < count; ++i) {
      const auto& c = laws[i];
      const double speed = plant.motors[i].now.velocity;
      const bool brakes =
          c.torque * speed <= 0 && std::abs(c.torque) <= servo.safe_damping * std::abs(speed) + 0.1;
      if (c.stiffness != 0 || !(brakes || std::abs(c.torque) <= 0.01) ||
          std::abs(c.velocity * c.damping) > 0.05)
        return false;
    }
    return true;
  }
  bool all_there() const {
    for (std::size_t i = 0; i < count; ++i)
      if (std::abs(plant.motors[i].now.position - laws::middle_of<joints>(i) - way) > 0.03) return false;
    return true;
  }
  int syncs = 0;
};

}  // namespace

TEST_SUITE("families of drives") {
  TEST_CASE("a robot with all families is enabled, and each joint goes softly to its command") {
    lab l;
    l.controller.start();
    double fastest = 0;
    for (int k = 0; k < 2000; ++k) {
      l.beats(1);
      for (const auto& m : l.plant.motors) fastest = std::max(fastest, std::abs(m.now.velocity));
    }
    CHECK(l.synchronizer().phase() == hw::motion_phase::running);
    CHECK(l.stop().mode() == hw::motion_mode::run);
    CHECK(l.stop().first_cause().rule == hw::safety_rule::none);
    CHECK(l.all_there());
    CHECK(fastest < 3);
    CHECK(l.syncs >= 1990);  // one a beat for both drives on this bus
    CHECK(l.syncs <= 2000);
    for (auto& w : l.wires) CHECK(w.end(0).counters().dropped_full == 0);
    l.controller.stop();
    l.beats(3);
    CHECK(l.all_give_way());
  }

  TEST_CASE(
      "if a drive of any family fails, falls silent or reboots, all give way, and a start brings them back") {
    for (std::size_t drive = 0; drive < count; ++drive) {
      CAPTURE(drive);
      lab l;
      l.controller.start();
      l.beats(1200);
      REQUIRE(l.stop().mode() == hw::motion_mode::run);
      REQUIRE(l.all_there());
      const auto recovers = [&](hw::safety_rule rule) {
        CHECK(l.stop().mode() == hw::motion_mode::damped);
        CHECK(l.stop().first_cause().rule == rule);
        CHECK(l.stop().first_cause().joint == static_cast<int>(drive));
        CHECK(l.all_give_way());
        CHECK_MESSAGE((drive == 0 || l.laws[0].damping > 0),
                      "a moteus damps by its brake, since a set point without stiffness does not damp it");
        l.of_drive(drive, [](auto& d) { d.clear(); });
        l.beats(50);
        CHECK(l.all_give_way());
        l.controller.stop();
        l.controller.start();
        l.beats(1500);
        CHECK(l.stop().mode() == hw::motion_mode::run);
        CHECK(l.all_there());
      };
      l.of_drive(drive, [&](auto& d) { d.fail(faults[drive]); });
      l.beats(110);  // an ODrive reports it in its next heartbeat
      recovers(hw::safety_rule::drive_fault);
      l.of_drive(drive, [](auto& d) { d.go_silent(true); });
      l.beats(6);
      CHECK_MESSAGE(l.stop().mode() == hw::motion_mode::damped, "three beats of silence are enough");
      l.beats(64);  // meanwhile the drive's own watchdog runs out
      recovers(hw::safety_rule::silent);
      l.of_drive(drive, [&](auto& d) { d.reboot(l.now, 100'000'000); });
      l.beats(200);
      recovers(hw::safety_rule::silent);
    }
  }

  TEST_CASE("pressed, the emergency stop lets no drive of any family be enabled, nor does a start") {
    for (std::size_t missing = 0; missing < count; ++missing) {
      CAPTURE(missing);
      lab l;
      l.of_drive(missing, [](auto& d) { d.go_silent(true); });
      l.stop().press();
      l.controller.start();
      for (int k = 0; k < 900; ++k) {
        l.beats(1);
        REQUIRE(l.enabled_count() == 0);
        REQUIRE(l.all_give_way());
      }
      CHECK(l.synchronizer().refusal() == hw::safety_rule::pressed);
      l.controller.stop();
      l.controller.start();  // does not release the button
      l.of_drive(missing, [](auto& d) { d.go_silent(false); });
      for (int k = 0; k < 200; ++k) {
        l.beats(1);
        REQUIRE(l.enabled_count() == 0);
      }
      if (missing % 3 != 0) continue;
      l.stop().release();
      l.beats(100);
      CHECK(l.enabled_count() == 0);  // nor does the release alone enable anything
      l.controller.stop();
      l.controller.start();
      l.beats(1500);
      CHECK(l.stop().mode() == hw::motion_mode::run);
      CHECK(l.all_there());
    }
  }

  // Of each family one drive at least holds its position when the button is pressed: the start waits for the
  // missing one.
  TEST_CASE("pressed while drives are being enabled, those that are already enabled are disabled") {
    std::array<bool, count> were_enabled{};
    for (std::size_t missing = 0; missing < count; ++missing) {
      CAPTURE(missing);
      lab l;
      l.of_drive(missing, [](auto& d) { d.go_silent(true); });
      l.controller.start();
      l.beats(300);
      REQUIRE(l.synchronizer().phase() == hw::motion_phase::enabling);
      const auto enabled = l.enabled();
      for (std::size_t i = 0; i < count; ++i) were_enabled[i] |= enabled[i];
      CHECK(l.enabled_count() >= 7);
      l.stop().press();
      l.beats(10);
      CHECK(l.enabled_count() == 0);
      CHECK(l.all_give_way());
      l.of_drive(missing, [](auto& d) { d.go_silent(false); });
      for (int k = 0; k < 900; ++k) {
        l.beats(1);
        REQUIRE(l.enabled_count() == 0);
        REQUIRE(l.all_give_way());
      }
      CHECK(l.synchronizer().refusal() == hw::safety_rule::pressed);
    }
    CHECK(std::ranges::count(were_enabled, true) == 8);
  }

  TEST_CASE("a drive that no longer reports its velocity trips after three answers, and all give way") {
    for (const std::size_t drive : {2u, 3u}) {
      CAPTURE(drive);
      lab l;
      l.controller.start();
      l.beats(1200);
      REQUIRE(l.stop().mode() == hw::motion_mode::run);
      l.speed_scale[drive] = none;
      l.beats(5);
      CHECK(l.stop().mode() == hw::motion_mode::damped);
      CHECK(l.stop().first_cause().rule == hw::safety_rule::implausible);
      CHECK(l.stop().first_cause().joint == static_cast<int>(drive));
      l.beats(5);
      CHECK(l.all_give_way());
      l.speed_scale[drive] = 1;
      l.controller.stop();
      l.controller.start();
      l.beats(1500);
      CHECK(l.stop().mode() == hw::motion_mode::run);
      CHECK(l.all_there());
    }
  }

  TEST_CASE("a drive that does not report its velocity is not enabled") {
    lab l;
    l.speed_scale[2] = none;
    l.controller.start();
    l.beats(1000);
    CHECK(l.synchronizer().refusal() == hw::safety_rule::enabling);
    CHECK(l.synchronizer().phase() == hw::motion_phase::stopped);
    l.beats(3);
    CHECK(l.all_give_way());
  }

  TEST_CASE("a CANopen drive whose frames of velocity are lost trips, and is not started without them") {
    std::array<hw::bus_fault, 1> lost{{{.what = hw::bus_trouble::lose,
                                        .from = 1'200'000'000,
                                        .end = 0,
                                        .frames = hw::can_filter{hw::standard(0x281)}}}};
    lab late;
    late.wires[2].follow(lost);
    late.controller.start();
    late.beats(1200);
    REQUIRE(late.stop().mode() == hw::motion_mode::run);
    late.beats(5);
    CHECK(late.stop().mode() == hw::motion_mode::damped);
    CHECK(late.stop().first_cause().rule == hw::safety_rule::implausible);
    CHECK(late.stop().first_cause().joint == 4);

    lost[0].from = 0;
    lab never;
    never.wires[2].follow(lost);
    never.controller.start();
    never.beats(1000);
    CHECK(never.synchronizer().refusal() == hw::safety_rule::enabling);
    CHECK(hw::text_of(never.synchronizer().failure()) ==
          "left_front_knee: its drive does not report its velocity");
  }
}
