// Balls in a compiled world: they fall, bounce, roll and slide by the laws, carry and push the robot, and are
// carried and pushed by it.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <cca/sim/robot/world/robot_world.hpp>

#include "robots.hpp"

namespace laws {
std::size_t allocations();  // in tests/laws/allocations.cpp
}

using namespace compiled_test;

namespace {

// A board whose base is held, with a block on it that slides along x.
struct board_frame : cca::frame<"board"> {};
struct block_frame : cca::frame<"block"> {};
struct way : cca::dimension<"way"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}};
};
struct block_chain : cca::serial_chain<board_frame, block_frame, cca::axes<way>> {
  static constexpr std::array joints{cca::prismatic(cca::along_x)};
  static constexpr auto tip = cca::at(0, 0, 0.1);
  static constexpr std::array links{cca::link_inertia{1, {0, 0, 0.1}, {1e-3, 1e-3, 1e-3, 0, 0, 0}}};
};
template <auto Form>
struct board {
  struct body : cca::body<board_frame, cca::part<"block", block_chain>> {};
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr std::array drives{robots::joint_drive{.stops = false}};
  static constexpr std::array shapes{robots::at_tip("block", Form)};
};
struct with_sphere : board<robots::sphere(0.05)> {};
struct with_capsule : board<robots::capsule(0.05, 0.08)> {};
struct with_block : board<robots::box(0.1, 0.1, 0.1)> {};

// Three feet on three balls would roll off; a plate does not.
struct plate : sledge {
  static constexpr std::array shapes{robots::on_base(robots::box(0.6, 0.6, 0.02))};
};
struct shapeless : alone<sledge::body, true> {};
// Its base is held: a post under the ball.
struct post : with_sphere {
  static constexpr std::array shapes{robots::on_base(robots::box(0.4, 0.4, 0.2))};
};

constexpr double ball_radius = 0.05, ball_mass = 0.2;
sim::scene on_floor(std::array<double, 3> at, std::array<double, 3> velocity = {}, double friction = 0.75) {
  sim::scene s;
  s.floor = 0, s.contact.friction = friction;
  s.add(sim::ball{.radius = ball_radius, .mass = ball_mass, .position = at, .velocity = velocity});
  return s;
}
double carried(double m, double points = 1) { return 0.0005 + m * gravity / points / 40e3; }

// With that of the floor's spring.
template <class World>
double energy_of_ball(const World& w, std::size_t i) {
  const double deep = std::max(0.0, ball_radius - 0.0005 - w.ball_position(i)[2]);
  const auto& b = w.save().around.balls[i];
  const Eigen::Vector3d turning(b.turning[0], b.turning[1], b.turning[2]);
  return ball_mass * (0.5 * w.ball_velocity(i).squaredNorm() + gravity * w.ball_position(i)[2]) +
         0.2 * ball_mass * ball_radius * ball_radius * turning.squaredNorm() + 0.5 * 40e3 * deep * deep;
}
template <class World>
bool same_bits(const World& a, const World& b) {
  return std::memcmp(&a.save().motion, &b.save().motion, sizeof a.save().motion) == 0 &&
         std::memcmp(&a.save().around, &b.save().around, sizeof a.save().around) == 0;
}

}  // namespace

TEST_SUITE("compiled world: balls") {
  TEST_CASE("a ball falls freely, lands, and comes to rest - its energy never grows") {
    sim::compiled_world<with_sphere> w(on_floor({1, 1, 0.4}, {0.5, 0, 0}));
    run(w, 200);
    CHECK(w.ball_velocity(0)[2] == doctest::Approx(-0.2 * gravity).epsilon(1e-12));
    CHECK(w.ball_position(0)[2] == doctest::Approx(0.4 - 0.02 * gravity).epsilon(1e-9));
    double before = energy_of_ball(w, 0), most = 0;
    for (int i = 0; i < 3000; ++i) {
      w.advance({});
      const double now = energy_of_ball(w, 0);
      most = std::max(most, now - before), before = std::min(before, now);
    }
    MESSAGE("largest growth: ", most, " J");
    CHECK(most < 1e-12);
    CHECK(w.ball_position(0)[2] == doctest::Approx(ball_radius - carried(ball_mass)).epsilon(1e-4));
    CHECK(std::abs(w.ball_velocity(0)[2]) < 1e-9);
  }

  TEST_CASE("a soft ball bounces, and each time less high") {
    sim::scene s = on_floor({1, 1, 0.5});
    s.contact.damping = 2;
    sim::compiled_world<with_sphere> w(s);
    double top = 0.5, last = 0;
    int bounces = 0;
    bool rises = false;
    for (int i = 0; i < 3000; ++i) {
      w.advance({});
      const double v = w.ball_velocity(0)[2];
      if (rises && v < 0) {
        CHECK(w.ball_position(0)[2] < top + 1e-9);
        top = w.ball_position(0)[2], last = top, ++bounces;
      }
      rises = v > 0;
    }
    MESSAGE(bounces, " bounces, the last to ", last, " m");
    CHECK(bounces > 2);
  }

  TEST_CASE("a ball that slides comes to roll with 5/7 of its speed, and rolls on") {
    sim::compiled_world<with_sphere> w(on_floor({-1, 1, ball_radius - carried(ball_mass)}, {2, 0, 0}, 0.4));
    run(w, 50);
    CHECK(w.ball_velocity(0)[0] == doctest::Approx(2 - 0.05 * 0.4 * gravity).epsilon(2e-3));  // it slides
    run(w, 950);
    CHECK(w.ball_velocity(0)[0] == doctest::Approx(2 * 5.0 / 7).epsilon(1e-3));
    const auto& turning = w.save().around.balls[0].turning;
    CHECK(turning[1] == doctest::Approx(w.ball_velocity(0)[0] / ball_radius).epsilon(0.02));
    const double before = w.ball_velocity(0)[0];
    run(w, 1000);
    CHECK(w.ball_velocity(0)[0] == doctest::Approx(before).epsilon(1e-6));
  }

  TEST_CASE("down a slope and down a tilted box it rolls with 5/7 of the acceleration") {
    const double pitch = 0.3, a = gravity * std::sin(pitch) * 5 / 7;
    sim::scene hill = hill_of(pitch, 0.75);
    const double above = ball_radius - carried(ball_mass);
    const auto at = [&](double x, double z) -> std::array<double, 3> {
      return {x - above * std::sin(pitch), 1, z + above * std::cos(pitch)};
    };
    hill.add(sim::ball{.radius = ball_radius, .mass = ball_mass, .position = at(0, 10 * std::tan(pitch))});
    sim::scene tilted;
    tilted.add(sim::fixed_box{{8, 4, 0.2}, cca::turned_about(cca::along_y, -pitch) * cca::at(0, 0, -0.1)});
    tilted.add(sim::ball{.radius = ball_radius, .mass = ball_mass, .position = at(0, 0)});
    for (const sim::scene& s : {hill, tilted}) {
      sim::compiled_world<with_sphere> w(s);
      run(w, 200);
      const double from = w.ball_velocity(0).norm();
      run(w, 400);
      CHECK(w.ball_velocity(0).norm() - from == doctest::Approx(0.4 * a).epsilon(2e-3));
    }
  }

  TEST_CASE_TEMPLATE("a block pushes a ball, and feels it as much: momentum stays", R, with_sphere,
                     with_capsule, with_block) {
    sim::scene s;  // without a floor, and without weight
    const double y = std::is_same_v<R, with_block> ? 0.03 : 0;
    s.add(sim::ball{.radius = ball_radius, .mass = ball_mass, .position = {0.2, y, 0.1}});
    s.contact.friction = 0;
    sim::robot_world_settings weightless;
    weightless.engine.gravity = 0;
    sim::compiled_world<R> w(s, weightless);
    w.place({0}, {1});
    double load = 0;
    for (int i = 0; i < 300; ++i) {
      w.advance({});
      load -= w.force_on_end("block")[0] * 1e-3;
      const double now = 0.5 * w.joints()[0].velocity * w.joints()[0].velocity +
                         0.5 * ball_mass * w.ball_velocity(0).squaredNorm();
      CHECK(now < 0.5 + 1e-12);
    }
    CHECK(w.joints()[0].velocity + ball_mass * w.ball_velocity(0)[0] == doctest::Approx(1).epsilon(1e-9));
    CHECK(w.ball_velocity(0)[0] >= w.joints()[0].velocity - 1e-6);
    CHECK(w.ball_velocity(0)[0] > 0.8);
    CHECK(std::abs(w.ball_velocity(0)[1]) < 1e-9);
    CHECK(load == doctest::Approx(1 - w.joints()[0].velocity).epsilon(1e-6));
    CHECK(w.contact_at_end("block").load == doctest::Approx(load).epsilon(1e-6));
  }

  TEST_CASE("a plate stands on balls and rolls away on them") {
    const auto scene = [] {
      sim::scene s;
      s.floor = 0;
      for (const auto& [x, y] : {std::array{0.2, 0.0}, std::array{-0.1, 0.15}, std::array{-0.1, -0.15}})
        s.add(sim::ball{.radius = ball_radius, .mass = ball_mass, .position = {x, y, ball_radius - 0.0006}});
      return s;
    };
    sim::compiled_world<plate> w(scene());
    w.place({0}, {0}, cca::at(0, 0, 0.11 - 0.0014), {}, {});
    run(w, 500);
    CHECK(w.frame(-1).where.at[2] == doctest::Approx(0.11).epsilon(0.02));
    CHECK(w.contact(0).contacts == 3);
    CHECK(w.contact(0).pressing == doctest::Approx(mass * gravity).epsilon(1e-3));
    // Pushed, it rolls: of each ball 3/8 of its mass count.
    const double before = w.frame(-1).velocity[0];
    const sim::contact_account rested = w.contact(0);
    w.push({1, 0, 0});
    run(w, 300);
    MESSAGE("slip: ", (w.contact(0) - rested).slip, " N m");
    CHECK((w.contact(0) - rested).slip < 1e-5);  // it rolls
    const double a = 1 / (mass + 3 * ball_mass * (1 + 0.4) / 4);
    CHECK(w.frame(-1).velocity[0] - before == doctest::Approx(0.3 * a).epsilon(5e-3));
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(w.ball_velocity(i)[0] == doctest::Approx(w.frame(-1).velocity[0] / 2).epsilon(2e-2));
  }

  TEST_CASE("a held base carries a ball, a table that moves takes it along, balls lie on each other") {
    sim::scene s;
    s.add(sim::ball{.radius = ball_radius, .mass = ball_mass, .position = {0, 0, 0.1 + ball_radius}});
    sim::compiled_world<post> held(s);
    run(held, 1000);
    CHECK(held.ball_position(0)[2] == doctest::Approx(0.1 + ball_radius - carried(ball_mass)).epsilon(1e-5));

    sim::scene room;
    room.add(sim::fixed_box{{6, 6, 0.2}, cca::at(0, 0, -0.1)});
    room.add(sim::ball{
        .radius = ball_radius, .mass = ball_mass, .position = {1, 1, ball_radius - carried(ball_mass)}});
    sim::compiled_world<with_sphere> w(room);
    for (int i = 1; i <= 500; ++i) w.move(0, cca::at(0.5e-6 * i * i, 0, -0.1)), w.advance({});
    CHECK(w.ball_velocity(0)[0] == doctest::Approx(0.5 * 2.0 / 7).epsilon(5e-3));  // it rolls back on it

    sim::scene two;
    two.floor = 0;
    two.add(sim::ball{.radius = ball_radius, .mass = ball_mass, .position = {1, 1, ball_radius}});
    two.add(sim::ball{.radius = ball_radius, .mass = ball_mass, .position = {1, 1, 3 * ball_radius}});
    sim::compiled_world<with_sphere> tower(two);
    run(tower, 500);
    const double lower = ball_radius - carried(2 * ball_mass);
    CHECK(tower.ball_position(0)[2] == doctest::Approx(lower).epsilon(1e-4));
    CHECK(tower.ball_position(1)[2] ==
          doctest::Approx(lower + 2 * ball_radius - carried(ball_mass)).epsilon(1e-4));
  }

  TEST_CASE("a ball pushed over the floor goes as in the engine") {
    sim::scene s;
    s.floor = 0;
    s.add(sim::ball{.radius = 0.1, .mass = ball_mass, .position = {0.2, 0, 0.1}});
    sim::compiled_world<with_capsule> w(s);
    sim::robot_world_settings fine;
    fine.steps_per_beat = 8;
    sim::robot_world e(sim::model_of<with_capsule>(), s, fine);
    w.place({0}, {1}), e.place(std::vector{0.0}, std::vector{1.0});
    run(w, 500), run(e, 500);
    MESSAGE("ball at ", w.ball_position(0).transpose(), ", in the engine ", e.ball_position(0).transpose());
    CHECK(w.ball_position(0)[0] > 0.4);
    CHECK(w.ball_position(0)[0] == doctest::Approx(e.ball_position(0)[0]).epsilon(0.03));
    CHECK(w.ball_velocity(0)[0] == doctest::Approx(e.ball_velocity(0)[0]).epsilon(0.03));
  }

  TEST_CASE("copy, save and restore go on bit for bit with balls, and nothing allocates") {
    sim::scene s = on_floor({0.15, 0.01, 0.05});
    s.add(sim::ball{.radius = 0.04, .mass = 0.1, .position = {0.16, 0, 0.3}});
    sim::compiled_world<with_sphere> w(s);
    w.place({0}, {1});
    run(w, 150);
    auto copy = w;
    const auto saved = w.save();
    const std::size_t before = laws::allocations();
    run(w, 150), run(copy, 150);
    CHECK(laws::allocations() == before);
    CHECK(same_bits(w, copy));
    w.restore(saved);
    CHECK_FALSE(same_bits(w, copy));
    run(w, 150);
    CHECK(same_bits(w, copy));
  }

  TEST_CASE("a ball that can't be right is named, and too many are refused") {
    sim::scene s = on_floor({1, 0, 1});
    s.add(sim::ball{.position = {2, 0, 1}, .velocity = {2000, 0, 0}});
    sim::compiled_world<with_sphere> fast(s);
    fast.advance({});
    CHECK(fast.trouble_text().find("ball 1: its speed of 2000 is beyond 1000 m/s") == 0);
    CHECK(fast.ball_position(0)[2] == 1);  // as before the beat
    s = on_floor({1, 0, 1});
    for (int i = 0; i < 3; ++i) s.add(sim::ball{.position = {2.0 + i, 0, 1}});
    const sim::compiled_world<with_sphere> w(s);
    CHECK_THROWS_WITH_AS(static_cast<void>(w.ball_position(4)), doctest::Contains("ball 4"),
                         std::out_of_range);
    s.add(sim::ball{.position = {9, 0, 1}});
    CHECK_THROWS_WITH_AS(sim::compiled_world<with_sphere>{s},
                         doctest::Contains("5 balls, and there is room for 4"), std::invalid_argument);
    CHECK_THROWS_WITH_AS(sim::compiled_world<with_sphere>{s}, doctest::Contains("cca::sim::robot_world"),
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(sim::compiled_world<shapeless>{on_floor({1, 0, 1})}, doctest::Contains("no shapes"),
                         std::invalid_argument);
  }
}
