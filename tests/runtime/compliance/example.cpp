// The example of docs/compliance.md: an arm whose stiffness somebody else chooses, and that gives way.
#include <cca/cca.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/compliance/contact_reaction.hpp>
#include <cca/robot/compliance/joint_impedance.hpp>
#include <cca/robot/compliance/passivity_guard.hpp>
#include <cca/robot/dynamics/momentum_observer.hpp>

#include "rig.hpp"

namespace laws {
std::size_t allocations();  // in tests/laws/allocations.cpp
}

using namespace compliance_test;

namespace {

struct plant {
  simulated body{bent, vector::Zero()};
  auto sense() -> std::tuple<cca::out<"angles", angles>, cca::out<"velocities", velocities>> {
    return {body.q, body.dq};
  }
  void act(cca::in<"torques", torques> command) { body.hold(in_order(command.vector()), 1e-3); }
};
// Somebody who learns: any stiffness, in any beat.
struct learner {
  auto process(cca::beat now)
      -> std::tuple<cca::out<"reference", angles>, cca::out<"stiffness", cca::stiffness_along<torques>>> {
    return {bent, vector(vector::Constant(now.index() % 100 < 50 ? 20 : 60))};
  }
};

// [arm]
template <class Robot, class Learner>
struct compliant_arm
    : cca::graph<cca::rate<1000>,
                 cca::node<"learner", Learner, cca::timed<1>>,
                 cca::node<"gravity", cca::gravity_compensation<arm, angles, torques>>,
                 cca::node<"servo", cca::joint_impedance<arm, angles, velocities, torques>, cca::timed<1>>,
                 cca::node<"guard", cca::passivity_guard<arm, angles, velocities, torques>, cca::timed<1>>,
                 cca::node<"sees", cca::momentum_observer<arm, angles, velocities, torques>, cca::timed<1>>,
                 cca::node<"reacts", cca::contact_reaction<arm, angles, velocities, torques>, cca::timed<1>>,
                 cca::node<"limits", cca::limiter<torques>>,
                 cca::node<"robot", Robot>,
                 cca::wire<"learner.reference", "servo.reference">,
                 cca::wire<"learner.stiffness", "servo.stiffness">,
                 cca::wire<"robot.angles", "servo.angles">,
                 cca::wire<"robot.velocities", "servo.velocities">,
                 // What the servo asks for passes the guard; gravity compensation goes around it.
                 cca::wire<"servo.torques", "guard.torques">,
                 cca::wire<"robot.angles", "guard.angles">,
                 cca::wire<"robot.velocities", "guard.velocities">,
                 cca::wire<"robot.angles", "gravity.angles">,
                 cca::wire<"gravity.torques", "guard.gravity">,
                 // The observer compares the motion with the torques of the last beat.
                 cca::wire<"robot.angles", "sees.angles">,
                 cca::wire<"robot.velocities", "sees.velocities">,
                 cca::wire<"limits.safe", "sees.torques", cca::delayed<1>>,
                 cca::wire<"guard.torques", "reacts.torques">,
                 cca::wire<"sees.external", "reacts.external">,
                 cca::wire<"robot.angles", "reacts.angles">,
                 cca::wire<"robot.velocities", "reacts.velocities">,
                 cca::wire<"reacts.torques", "limits.command">,
                 cca::wire<"limits.safe", "robot.torques">> {};
// [arm end]

struct touched : compliant_arm<plant, learner> {};

}  // namespace

TEST_SUITE("compliance, example") {
  TEST_CASE("an arm whose stiffness changes all the time gives way to a push, and returns") {
    cca::controller<touched> c;
    // [load]
    auto servo = c.get<"servo">().p;
    servo.compensate_gravity = false;  // it has a way of its own
    c.get<"servo">().p = servo;
    c.get<"guard">().p = {20, 20};  // J: enough for the way back
    c.get<"reacts">().p.reaction = cca::reaction::yield;
    c.get<"reacts">().p.braking = 100;
    c.load();
    // [load end]
    c.start();
    auto& arm_of = c.get<"robot">().body;
    c.run(cca::for_beats<500>{});
    CHECK((arm_of.q - bent).norm() < 1e-3);
    arm_of.world.wrench << 0, 0, 0, 0, 20, 0;
    const std::size_t before = laws::allocations();
    c.run(cca::for_beats<60>{});
    CHECK(laws::allocations() == before);
    CHECK((arm_of.q - bent).norm() > 0.02);
    arm_of.world.wrench.setZero();
    c.run(cca::for_beats<5000>{});
    CHECK((arm_of.q - bent).norm() < 0.02);
    CHECK(c.state() == cca::state::started);
  }
}
