// Contacts of a compiled world with the ground: standing, sticking, sliding, sensors, and the engine beside
// it.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <cmath>

#include <cca/sim/robot/world/robot_world.hpp>

#include "robots.hpp"

using namespace compiled_test;

namespace {

struct springy : sledge {
  static constexpr std::array drives{robots::joint_drive{.spring = -10}};
};

struct walking : robots::oncilla::description {};
std::array<sim::joint_law, 16> standing() {
  std::array<sim::joint_law, 16> laws;
  for (std::size_t c = 0; c < 16; ++c) {
    const auto& d = walking::drives[c];
    laws[c] = {.position = walking::start[c], .stiffness = d.position_stiffness(), .damping = d.damping};
  }
  return laws;
}
sim::scene flat() {
  sim::scene s;
  s.floor = 0;
  return s;
}
cca::placement put_down(double height) { return cca::at(0, 0, height); }
constexpr std::array feet{"left_front_load", "right_front_load", "left_hind_load", "right_hind_load"};

}  // namespace

TEST_SUITE("compiled world: touching") {
  TEST_CASE("on a slope below the angle of friction a sledge sticks, above it slides as Coulomb says") {
    for (const double degrees : {0.0, 20.0, 36.0}) {  // tan 36.87 degrees = 0.75
      auto w = on_slope(degrees * 0.017453292519943295, 0.75);
      for (int i = 0; i < 1000; ++i) w.advance({});
      const Eigen::Vector3d before = w.frame(-1).where.at;
      for (int i = 0; i < 1000; ++i) w.advance({});
      CHECK(speed(w) < 1e-9);
      CHECK((w.frame(-1).where.at - before).norm() < 1e-9);
    }
    const double steep = 0.8;
    auto w = on_slope(steep, 0.75);
    for (int i = 0; i < 200; ++i) w.advance({});
    const double from = speed(w);
    for (int i = 0; i < 200; ++i) w.advance({});
    CHECK(speed(w) - from ==
          doctest::Approx(0.2 * gravity * (std::sin(steep) - 0.75 * std::cos(steep))).epsilon(1e-5));
  }

  TEST_CASE("friction is a cone: it brakes as much in every direction") {
    for (const double way : {0.0, 0.3, 0.785, 1.2}) {
      auto w = on_slope(0, 0.5);
      const auto place = w.frame(-1).where.at;
      w.place({0}, {0}, cca::at(place[0], place[1], place[2]), {}, {2 * std::cos(way), 2 * std::sin(way), 0});
      for (int i = 0; i < 100; ++i) w.advance({});
      CHECK(speed(w) == doctest::Approx(2 - 0.1 * 0.5 * gravity).epsilon(2e-3));
    }
  }

  TEST_CASE("a pyramid, if it is asked for, brakes more between its edges") {
    sim::scene ground = hill_of(0, 0.5);
    ground.contact.pyramid = true;
    for (const double way : {0.0, 0.785398163397448}) {
      sim::compiled_world<sledge> w(ground);
      const cca::placement place = on_hill(0);
      w.place({0}, {0}, place, {}, {2 * std::cos(way), 2 * std::sin(way), 0});
      for (int i = 0; i < 100; ++i) w.advance({});
      const double times = way > 0 ? std::sqrt(2.0) : 1;
      CHECK(speed(w) == doctest::Approx(2 - times * 0.1 * 0.5 * gravity).epsilon(2e-3));
    }
  }

  TEST_CASE("an Oncilla stands at rest, and its feet carry its weight") {
    sim::compiled_world<walking> w(flat());
    w.place(walking::start, {}, put_down(0.2), {}, {});
    for (int i = 0; i < 30000; ++i) w.advance(standing());  // it sways slowly
    REQUIRE(!w.trouble());
    CHECK(w.frame(-1).velocity.norm() < 1e-6);
    CHECK(w.frame(-1).angular_velocity.norm() < 1e-6);
    double sum = 0, felt = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      sum += w.force_on_end(i)[2];
      const auto& load = w.load(feet[i]);
      felt += (w.end(i).where.turn * Eigen::Vector3d(load[3], load[4], load[5]))[2];
    }
    const double weight = robots::oncilla::body.mass() * gravity;
    CHECK(sum == doctest::Approx(weight).epsilon(1e-4));
    CHECK(felt == doctest::Approx(weight).epsilon(1e-4));
    auto copy = w;
    for (int i = 0; i < 100; ++i)
      w.push({0, 5, 0}), copy.push({0, 5, 0}), w.advance(standing()), copy.advance(standing());
    CHECK(w.save().motion.q == copy.save().motion.q);
    CHECK(w.frame(-1).where.at == copy.frame(-1).where.at);
  }

  TEST_CASE("an Oncilla that is put down stands where the engine has it") {
    sim::robot_world_settings fine;
    fine.steps_per_beat = 8;
    sim::compiled_world<walking> w(flat());
    sim::robot_world e(sim::model_of<walking>(), flat(), fine);
    w.place(walking::start, {}, put_down(0.17), {}, {});
    sim::moving_frame base;
    base.where.at = Eigen::Vector3d(0, 0, 0.17);
    const std::vector<double> rest(16, 0.0);
    e.place(walking::start, rest, base);
    for (int i = 0; i < 1500; ++i) w.advance(standing()), e.advance(standing());
    REQUIRE(!w.trouble());
    const double lower = w.frame(-1).where.at[2] - e.frame(-1).where.at[2];
    MESSAGE("height ", w.frame(-1).where.at[2], " m, difference ", lower, " m");
    CHECK(std::abs(lower) < 5e-4);
    double worst = 0;
    for (std::size_t c = 0; c < 16; ++c)
      worst = std::max(worst, std::abs(w.joints()[c].angle - e.joints()[c].angle));
    MESSAGE("largest difference of an angle: ", worst, " rad");
    CHECK(worst < 0.02);
  }

  TEST_CASE("what it has not got is refused") {
    sim::scene two = flat();
    two.ground = sim::terrain::flat();
    CHECK_THROWS_AS(sim::compiled_world<walking>{two}, std::invalid_argument);
    sim::robot_world_settings none;
    none.steps_per_beat = 0;
    CHECK_THROWS_AS(sim::compiled_world<walking>{none}, std::invalid_argument);
    sim::robot_world_settings unbounded;
    unbounded.plausible.speed = NAN;
    CHECK_THROWS_AS(sim::compiled_world<walking>{unbounded}, std::invalid_argument);
    sim::compiled_world<walking> w;
    CHECK_THROWS_WITH_AS(w.load(40), doctest::Contains("40"), std::out_of_range);
    CHECK_THROWS_AS(w.force_on_end("fifth_leg"), std::out_of_range);
    CHECK_THROWS_AS(sim::compiled_world<springy>{}, std::invalid_argument);
    CHECK_THROWS_AS(w.pull("fifth_leg", {}), std::out_of_range);
    CHECK_THROWS_AS(w.place(walking::start, {}, put_down(NAN), {}, {}), std::invalid_argument);
  }
}
