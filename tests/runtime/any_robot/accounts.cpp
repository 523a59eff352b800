// What a world keeps accounts of: slip, load and work of friction, the work of the motors; and pushes. All
// against what can be computed by hand.
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/sim/robot.hpp>

#include "flagged.hpp"

using namespace any_robot_test;

namespace {

namespace sim = cca::sim;
namespace robots = cca::robots;

struct sled : flagged {
  static constexpr std::array shapes{robots::on_base(robots::box(0.4, 0.3, 0.02)),
                                     robots::at_tip("flag", robots::sphere(0.005))};
};

// A lift of 2 kg on a rail.
struct rail : cca::dimension<"rail"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::velocity{-1, 1}, cca::torque{-100, 100}};
};
struct rail_chain : cca::serial_chain<room, tip_frame, cca::axes<rail>> {
  static constexpr std::array joints{cca::prismatic(cca::along_z)};
  static constexpr auto tip = cca::at(0, 0, 0);
  static constexpr std::array links{cca::link_inertia{2, {}, {0.01, 0.01, 0.01}}};
};
struct lift {
  using body = cca::body<room, cca::part<"cabin", rail_chain>>;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::position_command>;
  static constexpr std::array<robots::joint_drive, 1> drives{
      {{.motor = {100, 10}, .stiffness = 1e4, .damping = 200}}};
};

sim::robot_world sliding(double speed, double friction) {
  sim::scene ice;
  ice.floor = 0;
  ice.contact.friction = friction;
  sim::robot_world w(sim::model_of<sled>(), ice);
  sim::moving_frame base;
  base.where.at = {0, 0, 0.01};
  base.velocity = {speed, 0, 0};
  w.place(std::vector<double>{0}, std::vector<double>{0}, base);
  return w;
}

void advance(sim::robot_world& w, int beats, const sim::joint_law& law = {}) {
  for (int k = 0; k < beats; ++k) w.advance(std::array{law});
}

// Lifts the cabin, or lowers it, at a constant speed.
void move_cabin(sim::robot_world& w, double from, double to, int beats) {
  for (int k = 1; k <= beats; ++k)
    advance(w, 1, {from + (to - from) * k / beats, (to - from) / (1e-3 * beats), 0, 1e4, 200});
}

struct nothing {
  auto process(cca::beat) -> cca::out<"torque", robots::torques<sled>> { return 0.0; }
};
struct pushed : cca::graph<cca::node<"nothing", nothing>,
                           cca::node<"limits", cca::limiter<robots::torques<sled>>>,
                           cca::node<"robot", sim::robot<sled>>,
                           cca::wire<"nothing.torque", "limits.command">,
                           cca::wire<"limits.safe", "robot.torque">> {};

}  // namespace

TEST_SUITE("accounts") {
  TEST_CASE("a sled that slides to rest: friction has taken all of its energy, and slip is load times way") {
    constexpr double speed = 1, friction = 0.2, gravity = 9.81;
    sim::robot_world w = sliding(speed, friction);
    CHECK(w.mass() == doctest::Approx(1));
    CHECK(w.centre_of_mass()[2] == doctest::Approx(0.01).epsilon(0.01));
    advance(w, 1000);
    const sim::contact_account all = w.contact_of_base();
    const double way = w.frame(-1).where.at[0];
    CHECK(w.frame(-1).velocity.norm() < 1e-3);
    CHECK(way == doctest::Approx(speed * speed / (2 * friction * gravity)).epsilon(0.03));
    CHECK(all.friction_work == doctest::Approx(0.5 * speed * speed).epsilon(0.03));
    CHECK(all.load == doctest::Approx(gravity).epsilon(0.01));  // N s in a second
    CHECK(all.slip == doctest::Approx(gravity * way).epsilon(0.03));
    CHECK(all.pressing == doctest::Approx(gravity).epsilon(0.01));
    CHECK(all.touching == doctest::Approx(1).epsilon(0.01));
    CHECK(all.contacts == 4);
    CHECK(w.contact_at_end("flag").load == 0);
    CHECK(w.contact(0).slip == all.slip);
  }

  TEST_CASE("since a moment: at rest nothing slips, and the state brings the accounts back") {
    sim::robot_world w = sliding(0.5, 0.5);
    advance(w, 500);
    const sim::robot_state rest = w.save();
    const sim::contact_account before = w.contact_of_base();
    advance(w, 500);
    const sim::contact_account since = w.contact_of_base() - before;
    CHECK(since.load == doctest::Approx(9.81 * 0.5).epsilon(0.01));
    CHECK(since.slip < 1e-3 * since.load);
    const auto hash = w.hash();
    w.restore(rest);
    CHECK(w.contact_of_base().load == before.load);
    advance(w, 500);
    CHECK(w.hash() == hash);
    sim::robot_state other = rest;
    other.contacts[0].slip += 1;
    CHECK(other.hash() != rest.hash());
  }

  TEST_CASE("a push moves the base by its impulse, along it, until it is set again") {
    sim::robot_world_settings weightless;
    weightless.engine.gravity = 0;
    sim::robot_world w(sim::model_of<sled>(), {}, weightless);
    w.push({3, -2, 1});
    w.push({NAN, -2, INFINITY});  // what is not finite is ignored
    advance(w, 100);
    w.push({0, 0, 0});
    advance(w, 100);
    const Eigen::Vector3d v = w.frame(-1).velocity;
    CHECK(v[0] == doctest::Approx(0.3).epsilon(1e-6));
    CHECK(v[1] == doctest::Approx(-0.2).epsilon(1e-6));
    CHECK(v[2] == doctest::Approx(0.1).epsilon(1e-6));
  }

  TEST_CASE("the motors' work: up it is the weight's, down only braking") {
    constexpr double rise = 0.5, energy = 2 * 9.81 * rise;
    sim::robot_world w(sim::model_of<lift>());
    advance(w, 500, {0, 0, 0, 1e4, 200});
    const double begun = w.positive_work();
    CHECK(begun < 0.05);
    move_cabin(w, 0, rise, 5000);
    CHECK(w.positive_work() - begun == doctest::Approx(energy).epsilon(0.02));
    const double up = w.positive_work(), all = w.absolute_work();
    move_cabin(w, rise, 0, 5000);
    CHECK(w.positive_work() - up < 0.02 * energy);
    CHECK(w.absolute_work() - all == doctest::Approx(energy).epsilon(0.03));
  }

  TEST_CASE("a simulated robot is pushed as its plan says, and its world may be pushed besides") {
    cca::controller<pushed> c;
    c.load();
    sim::robot_world_settings weightless;
    weightless.engine.gravity = 0;
    auto& robot = c.get<"robot.simulator">();
    robot.put_down(sim::robot_world(sim::model_of<sled>(), {}, weightless),
                   {{{{.start = 0.0995, .duration = 0.05, .force = {2, 0, 0}},
                      {.start = 0.1195, .duration = 0.1, .force = {0, 4, 0}}}}});
    c.start();
    for (int k = 0; k < 300; ++k) REQUIRE(c.step());
    CHECK(robot.world().frame(-1).velocity[0] == doctest::Approx(0.1).epsilon(1e-6));
    CHECK(robot.world().frame(-1).velocity[1] == doctest::Approx(0.4).epsilon(1e-6));
    robot.world().push({0, 0, 5});
    for (int k = 0; k < 100; ++k) REQUIRE(c.step());
    CHECK(robot.world().frame(-1).velocity[2] == doctest::Approx(0.5).epsilon(1e-6));
    robot.world().push({0, 0, 0});
    auto copy = c;
    robot.disturb({{{{.start = 0.3995, .duration = 0.1, .force = {-1, 0, 0}}}}});
    for (int k = 0; k < 200; ++k) REQUIRE((c.step() && copy.step()));
    CHECK(robot.world().frame(-1).velocity[0] == doctest::Approx(0).epsilon(1e-6));
    CHECK(copy.get<"robot.simulator">().world().frame(-1).velocity[0] == doctest::Approx(0.1).epsilon(1e-6));
  }
}
