// Imported policies as modes of one robot, above a torque loop of 1 kHz: a switch does not jump, and a
// watchdog lets `stand` or `damp` take over when a policy can't be trusted.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "hanging.hpp"

namespace laws {
std::size_t allocations();
}  // namespace laws

namespace {

using namespace policies;
using controller = cca::controller<hanging::legs>;
using hanging::probe;

std::unique_ptr<controller> started(double blend = 0.2) {
  auto c = std::make_unique<controller>();
  c->get<"intent.walk">().read(std::string(CCA_WRITTEN "/walk.policy"));
  c->get<"intent.other">().read(std::string(CCA_WRITTEN "/other.policy"));
  c->load();
  auto p = c->get<"blend">().p;
  p.duration = blend;
  c->set<"blend">(p);
  auto stands = c->get<"intent.standing">().p;
  stands.pose << 0.2, 0.6, -0.2, -0.6;
  stands.stiffness.setConstant(40);
  c->set<"intent.standing">(stands);
  c->start();
  return c;
}

// The largest steps between two beats.
struct steps {
  double target = 0, stiffness = 0, torque = 0;
  void note(const probe& before, const probe& now) {
    target = std::max(target, (now.target - before.target).cwiseAbs().maxCoeff());
    stiffness = std::max(stiffness, (now.stiffness - before.stiffness).cwiseAbs().maxCoeff());
    torque = std::max(torque, (now.torque - before.torque).cwiseAbs().maxCoeff());
  }
};
steps run(controller& c, int beats) {
  steps most;
  for (int i = 0; i < beats; ++i) {
    const probe before = c.get<"probe">();
    REQUIRE(c.step());
    most.note(before, c.get<"probe">());
  }
  return most;
}

constexpr std::array<std::string_view, 12> order{"other", "walk",  "stand", "other", "damp",  "walk",
                                                 "damp",  "stand", "walk",  "other", "stand", "walk"};

// Through all modes, in the middle of blends too: the largest steps in the 30 beats after a switch, by which
// a policy has answered once; between two of its answers only the blend moves the targets.
steps through_all_modes(double blend) {
  const auto c = started(blend);
  run(*c, 1003);
  steps worst;
  int k = 0;
  for (const std::string_view mode : order) {
    c->switch_to(mode);
    const steps now = run(*c, 30);
    worst.target = std::max(worst.target, now.target);
    worst.stiffness = std::max(worst.stiffness, now.stiffness);
    worst.torque = std::max(worst.torque, now.torque);
    run(*c, k++ % 3 == 0 ? 57 : 907);
    CHECK(c->mode() == mode);
  }
  return worst;
}

}  // namespace

TEST_SUITE("switching") {
  TEST_CASE("a switch between policies of other pose, gains, rate and memory does not jump") {
    const steps bumpless = through_all_modes(0.2), jumps = through_all_modes(0);
    MESSAGE("largest steps between two beats, blended within 0.2 s: ", bumpless.target, " rad, ",
            bumpless.stiffness, " N m/rad, ", bumpless.torque, " N m; without: ", jumps.target, " rad, ",
            jumps.stiffness, " N m/rad, ", jumps.torque, " N m");
    // 60 N m/rad is the largest difference; of a target 2.5 rad, and a policy's own step beside it.
    CHECK(bumpless.stiffness <= 60 * 0.001 / 0.2 + 1e-9);
    CHECK(bumpless.target < 0.03);
    CHECK(bumpless.torque < 1);
    CHECK(jumps.stiffness == doctest::Approx(60));
    CHECK(jumps.target > 10 * bumpless.target);
    CHECK(jumps.torque > 10 * bumpless.torque);
  }

  TEST_CASE("in the beat of a switch nothing moves, and until the new policy answers the old targets hold") {
    const auto c = started();
    run(*c, 1001);  // the policy answers in beat 1000
    const probe before = c->get<"probe">();
    c->switch_to<"other">();
    for (int k = 0; k < 9; ++k) {
      REQUIRE(c->step());
      CHECK(c->get<"probe">().target == before.target);
      CHECK(c->get<"probe">().stiffness == before.stiffness);
    }
    REQUIRE(c->step());  // beat 1010: it answers, and the blend begins
    CHECK(c->get<"probe">().target == before.target);
    REQUIRE(c->step());
    CHECK(c->get<"probe">().target != before.target);
    CHECK(c->get<"probe">().stiffness[0] == doctest::Approx(25 + 35 * 0.005));
    run(*c, 300);
    CHECK(c->get<"probe">().stiffness == Eigen::Vector4d::Constant(60));
  }

  TEST_CASE("`stand` goes from the applied targets to its pose, `damp` stays at them, also without a blend") {
    const auto c = started(0);
    run(*c, 1001);
    const Eigen::Vector4d from = c->get<"probe">().target, pose(0.2, 0.6, -0.2, -0.6);
    c->switch_to<"stand">();
    const steps whole = run(*c, 501);
    CHECK((c->get<"probe">().target - (from + pose) / 2).norm() < 1e-9);  // half of its second
    run(*c, 500);
    CHECK((c->get<"probe">().target - pose).norm() < 1e-9);
    CHECK(whole.target <= 1.5 * 0.001 * (pose - from).cwiseAbs().maxCoeff() + 1e-9);
    c->switch_to<"damp">();
    run(*c, 1);
    CHECK((c->get<"probe">().target - pose).norm() < 1e-9);
    CHECK(c->get<"probe">().stiffness == Eigen::Vector4d::Zero());
  }

  TEST_CASE("a beat with a switch allocates nothing") {
    const auto c = started();
    run(*c, 100);
    const auto before = laws::allocations();
    for (int k = 0; k < 20; ++k) {
      c->switch_to(order[static_cast<std::size_t>(k) % order.size()]);
      for (int i = 0; i < 37; ++i) c->step();
    }
    CHECK(laws::allocations() == before);
  }
}

TEST_SUITE("watchdog") {
  // Breaks a sensor of a walking robot, and returns the largest torque step of the following second.
  template <class Break>
  steps taken_over(controller & c, std::string_view by, const Break& breaks, int within) {
    run(c, 1007);
    breaks(c.get<"senses">());
    steps most;
    int beats = 0;
    while (c.mode() != by && beats < 2000) {
      const steps one = run(c, 1);
      most.torque = std::max(most.torque, one.torque), most.target = std::max(most.target, one.target);
      ++beats;
    }
    CHECK(c.mode() == by);
    CHECK(beats <= within);
    const steps rest = run(c, 1000);
    most.torque = std::max(most.torque, rest.torque), most.target = std::max(most.target, rest.target);
    CHECK(c.mode() == by);
    return most;
  }

  TEST_CASE("an observation that is not finite: `stand` takes over in the same period, without a jump") {
    const auto c = started();
    const steps most = taken_over(*c, "stand", [](hanging::senses& s) { s.spoils_an_angle = true; }, 20);
    CHECK(c->get<"intent.watchdog_of_walk">().cause() == "walk: joint_pos_rel is unreadable");
    MESSAGE("largest step ", most.torque, " N m, ", most.target, " rad");
    CHECK(most.torque < 1);
    CHECK(c->get<"probe">().torque[1] ==
          doctest::Approx(0).epsilon(1e-3));  // the spring of this joint has faded
  }
  TEST_CASE("a stale observation: `stand` takes over after the contract's age") {
    const auto c = started();
    const steps most = taken_over(*c, "stand", [](hanging::senses& s) { s.says_rates = false; }, 121);
    CHECK(c->get<"intent.watchdog_of_walk">().cause() == "walk: base_ang_vel is stale");
    MESSAGE("largest step ", most.torque, " N m, ", most.target, " rad");
    CHECK(most.torque < 1);
  }
  TEST_CASE("an observation out of the range seen in training: tolerated for a while, then `stand`") {
    const auto c = started();
    run(*c, 100);
    c->get<"senses">().wish[0] = 1.5;
    run(*c, 400);  // less than half a second
    c->get<"senses">().wish[0] = 0.5;
    run(*c, 100);
    CHECK(c->mode() == "walk");
    CHECK(c->get<"intent.watchdog_of_walk">().cause().empty());
    const steps most = taken_over(*c, "stand", [](hanging::senses& s) { s.wish[0] = 1.5; }, 541);
    CHECK(c->get<"intent.watchdog_of_walk">().cause() == "walk: velocity_commands is unseen");
    MESSAGE("largest step ", most.torque, " N m, ", most.target, " rad");
    CHECK(most.torque < 4);
  }
  TEST_CASE("another watchdog names another mode: `damp`") {
    const auto c = started();
    c->switch_to<"other">();
    const steps most = taken_over(*c, "damp", [](hanging::senses& s) { s.spoils_an_angle = true; }, 10);
    CHECK(c->get<"intent.watchdog_of_other">().cause() == "other: joint_pos is unreadable");
    CHECK(c->get<"probe">().stiffness == Eigen::Vector4d::Zero());
    MESSAGE("largest step ", most.torque, " N m, ", most.target, " rad");
    CHECK(most.torque < 1);
    c->get<"senses">().spoils_an_angle = false;
    c->switch_to<"other">();  // and back, when it can be trusted again
    const steps back = run(*c, 1000);
    CHECK(c->mode() == "other");
    CHECK(c->get<"intent.watchdog_of_other">().cause().empty());
    MESSAGE("largest step on the way back ", back.torque, " N m");
  }
}
