// What acts on the joints of a compiled world: springs, friction, motors, cables, stops, lines between
// points. Against formulas, and against the Open Dynamics Engine.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <cmath>

#include <cca/sim/robot/world/robot_world.hpp>

#include "robots.hpp"

using namespace compiled_test;

namespace {

struct bench_frame : cca::frame<"bench"> {};
struct wheel_frame : cca::frame<"wheel"> {};
struct spin : cca::dimension<"spin"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::torque{-5, 5}};
};
constexpr double inertia = 0.01;  // kg m^2

// About a vertical axis, so gravity does nothing.
struct wheel_chain : cca::serial_chain<bench_frame, wheel_frame, cca::axes<spin>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0.1, 0, 0);
  static constexpr std::array links{cca::link_inertia{1, {0, 0, 0}, {inertia, inertia, inertia, 0, 0, 0}}};
};
struct wheel_body : cca::body<bench_frame, cca::part<"wheel", wheel_chain>> {};

template <robots::joint_drive Drive>
struct wheel {
  using body = wheel_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr std::array drives{Drive};
};

template <class R>
sim::compiled_world<R> world_of(int steps) {
  sim::robot_world_settings s;
  s.steps_per_beat = steps;
  return sim::compiled_world<R>(s);
}
template <class R>
sim::compiled_world<R> world(double q, double dq, int steps = 2) {
  auto w = world_of<R>(steps);
  w.place({q}, {dq});
  return w;
}
template <class World>
void run(World& w, const sim::joint_law& law, int beats) {
  for (int i = 0; i < beats; ++i) w.advance(std::array{law});
}

using sprung = wheel<robots::joint_drive{.spring = 4, .spring_rest = 0.1, .stops = false}>;
double error_of_oscillation(int steps) {
  auto w = world<sprung>(0.5, 0, steps);
  double worst = 0;
  for (int i = 1; i <= 1000; ++i) {
    w.advance({});
    worst = std::max(worst, std::abs(w.joints()[0].angle - 0.1 - 0.4 * std::cos(20e-3 * i)));
  }
  CHECK(w.energy() + w.spring_energy() == doctest::Approx(0.5 * 4 * 0.4 * 0.4).epsilon(1e-9));
  return worst;
}

using rubbed = wheel<robots::joint_drive{.friction = 0.05, .stops = false}>;
double error_of_decay(int steps) {
  auto w = world<rubbed>(0, 3, steps);
  run(w, {}, 300);
  return std::abs(w.joints()[0].velocity - 3 * std::exp(-0.05 / inertia * 0.3));
}

using driven = wheel<robots::joint_drive{.motor = {2, 10}, .stops = false}>;
using wound = wheel<robots::joint_drive{
    .motor = {2, 10}, .friction = 0.05, .cable = {.stiffness = 20, .damping = 0.5}, .stops = false}>;
using bounded = wheel<robots::joint_drive{.motor = {5, 1000}}>;

// The arm follows targets with its servos, in the air.
struct free_arm : robots::arm::description {
  static constexpr std::array<robots::shape_on, 0> shapes{};
};
// The Oncilla, without what touches; high above everything.
struct free_oncilla : robots::oncilla::description {
  static constexpr std::array<robots::shape_on, 0> shapes{};
};

// The largest difference of an angle between this world and the engine's, in the same motion of half a
// second.
template <class R, class Laws>
double difference(int steps, int steps_of_engine, Laws laws_at) {
  sim::robot_world_settings ours, engines;
  ours.steps_per_beat = steps, engines.steps_per_beat = steps_of_engine;
  sim::compiled_world<R> w(ours);
  sim::robot_world e(sim::model_of<R>(), {}, engines);
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    const auto laws = laws_at(0.001 * i);
    w.advance(laws), e.advance(laws);
    for (std::size_t c = 0; c < coordinates<R>; ++c)
      worst = std::max(worst, std::abs(w.joints()[c].angle - e.joints()[c].angle));
  }
  CHECK(!w.trouble());
  return worst;
}
std::array<sim::joint_law, 7> waving(double t) {
  std::array<sim::joint_law, 7> laws;
  for (std::size_t c = 0; c < 7; ++c) {
    const auto& d = robots::arm::description::drives[c];
    const double way = 0.2 * (1 - std::cos(6 * t)), speed = 1.2 * std::sin(6 * t);
    laws[c] = {robots::arm::description::start[c] + (c % 2 ? way : -way), c % 2 ? speed : -speed, 0,
               d.stiffness, d.damping};
  }
  return laws;
}
std::array<sim::joint_law, 16> treading(double t) {
  std::array<sim::joint_law, 16> laws;
  for (std::size_t c = 0; c < 16; ++c) {
    const auto& d = robots::oncilla::description::drives[c];
    const double side = c / 4 % 3 == 0 ? 1 : -1, swing = side * std::sin(20 * t);
    const double from = robots::oncilla::description::start[c];
    laws[c] = {.position = from + (c % 4 == 1   ? 0.25 * swing
                                   : c % 4 == 2 ? 0.3 * (1 - std::cos(20 * t))
                                                : 0),
               .stiffness = d.position_stiffness(),
               .damping = d.damping};
  }
  return laws;
}

// What the motor moves is so light that one step of its law leads beyond its no-load speed.
using light = wheel<robots::joint_drive{.motor = {200, 1.7}, .stops = false}>;
struct light_arm : limp_arm {
  static constexpr auto drives = [] {
    auto all = limp_arm::drives;
    for (auto& d : all) d.motor = {60, 2};
    return all;
  }();
};
// By random servos, and by random torques.
numbers<light_arm> moved(std::uint64_t seed, int steps) {
  laws::source random{std::mt19937_64(seed)};
  std::array<sim::joint_law, 7> laws;
  for (sim::joint_law& l : laws) {
    l = {.position = random(-0.4, 0.4), .stiffness = 60 * std::exp(random(0, 4.5))};
    l.damping = l.stiffness * random(0.02, 0.1);
    if (seed % 4 == 0) l = {.torque = random(-60, 60), .damping = 0.5};
  }
  auto w = world_of<light_arm>(steps);
  for (int beat = 0; beat < 300; ++beat) w.advance(laws);
  numbers<light_arm> q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = w.joints()[i].angle;
  CHECK(!w.trouble());
  return q;
}

}  // namespace

TEST_SUITE("compiled world: joints") {
  TEST_CASE("a spring swings as its formula, to the second order, and keeps its energy") {
    const double whole = error_of_oscillation(2), half = error_of_oscillation(4);
    MESSAGE("rad: ", whole, ", ", half);
    CHECK(whole < 1e-3);
    CHECK(half < 0.27 * whole);
  }
  TEST_CASE("friction slows down as its formula, to the second order") {
    const double whole = error_of_decay(2), half = error_of_decay(4);
    CHECK(whole < 1e-5);
    CHECK(half < 0.27 * whole);
  }

  TEST_CASE("a motor gives its torque up to half of its speed, then what its line leaves") {
    auto w = world<driven>(0, 0);
    run(w, {.torque = 50}, 20);
    CHECK(w.joints()[0].velocity == doctest::Approx(2 / inertia * 0.02));
    CHECK(w.joints()[0].torque == doctest::Approx(2));
    run(w, {.torque = 50}, 30);  // 25 ms to 5 rad/s; then towards 10 rad/s with a time of 25 ms
    CHECK(w.joints()[0].velocity == doctest::Approx(10 - 5 * std::exp(-1)).epsilon(2e-3));
    run(w, {.torque = 50}, 1000);
    CHECK(w.joints()[0].velocity == doctest::Approx(10));
    run(w, {.torque = -50}, 1);  // it brakes with its full torque
    CHECK(w.joints()[0].torque == doctest::Approx(-2));
    CHECK(w.absolute_work() > w.positive_work());
  }

  TEST_CASE("a strong motor on a light joint reaches its target, and its no-load speed and no more") {
    for (const int steps : {1, 2, 4, 8, 16}) {
      CAPTURE(steps);
      for (const double stiffness : {200.0, 500.0, 1000.0, 4000.0}) {
        for (const double target : {0.1, -0.1}) {
          auto w = world<light>(0, 0, steps);
          run(w, {.position = target, .stiffness = stiffness, .damping = 0.05 * stiffness}, 2000);
          CHECK(w.joints()[0].angle == doctest::Approx(target).epsilon(1e-4));
        }
      }
      for (const double torque : {0.5, 5.0, 20.0, 100.0, 190.0, 500.0}) {
        for (const double way : {1.0, -1.0}) {
          auto w = world<light>(0, 0, steps);
          run(w, {.torque = way * torque}, 500);
          CHECK(w.joints()[0].velocity == doctest::Approx(way * 1.7).epsilon(1e-3));
        }
      }
    }
  }

  TEST_CASE("an arm of strong motors and light joints moves as with small steps") {
    double most = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const numbers<light_arm> coarse = moved(seed, 4), fine = moved(seed, 64);
      for (std::size_t i = 0; i < fine.size(); ++i) most = std::max(most, std::abs(coarse[i] - fine[i]));
    }
    MESSAGE("largest difference: ", most, " rad");
    CHECK(most < 0.01);
  }

  TEST_CASE("a servo of any stiffness reaches its target and stays there") {
    for (const double times : {1.0, 10.0, 1000.0, 1e6}) {
      auto w = world<bounded>(0, 0);
      const sim::joint_law law{.position = 0.5, .stiffness = 30 * times, .damping = 0.375 * times};
      run(w, law, 2000);
      CHECK(w.joints()[0].angle == doctest::Approx(0.5));
      CHECK(std::abs(w.joints()[0].velocity) < 1e-6);
    }
  }

  TEST_CASE("a cable only pulls, and no more than its motor") {
    auto w = world<wound>(0, 0);
    run(w, {.position = 0.4, .stiffness = 20}, 1000);
    CHECK(w.joints()[0].angle > 0.39);  // it gets slack there; friction stops the wheel
    const double there = w.joints()[0].angle;
    run(w, {.position = -0.4, .stiffness = 20}, 1000);
    CHECK(w.joints()[0].angle >= there);
    CHECK(w.joints()[0].torque == 0);
    auto pulled = world<wound>(0, 0);
    run(pulled, {.torque = 50}, 1);
    CHECK(pulled.joints()[0].torque == doctest::Approx(2));
    run(pulled, {.torque = -50}, 1);
    CHECK(pulled.joints()[0].torque == 0);
  }

  TEST_CASE("a stop ends a motion at once, and holds") {
    for (const double speed : {0.5, 40.0, 200.0}) {
      auto w = world<bounded>(0.9, speed);
      double most = 0, least = 1;
      for (int i = 0; i < 400; ++i) {
        w.advance({});
        most = std::max(most, w.joints()[0].angle);
        if (i > 250) least = std::min(least, w.joints()[0].angle);
      }
      CHECK(most < 1 + 0.6 * 0.0005 * speed + 1e-6);
      CHECK(least > 0.999);
      CHECK(std::abs(w.joints()[0].velocity) < 1e-6);
      run(w, {.torque = 5}, 500);
      CHECK(std::abs(w.joints()[0].velocity) < 1e-6);
      CHECK(w.joints()[0].angle == doctest::Approx(1).epsilon(1e-3));
      run(w, {.torque = -5}, 10);
      CHECK(w.joints()[0].velocity == doctest::Approx(-5 / inertia * 0.01).epsilon(0.01));
    }
  }

  TEST_CASE("a base that is held is no part of the robot") {
    using held = alone<robots::oncilla::walking_body, false>;
    sim::robot_world_settings high;
    high.mount = cca::at(0, 0, 10);
    sim::compiled_world<held> w(high);
    sim::robot_world e(sim::model_of<held>(), {}, high);
    CHECK(w.mass() == doctest::Approx(e.mass()).epsilon(1e-12));
    CHECK(w.mass() < robots::oncilla::walking_body::base.mass + e.mass());
    for (Eigen::Index k = 0; k < 3; ++k)
      CHECK(w.centre_of_mass()[static_cast<std::size_t>(k)] ==
            doctest::Approx(e.centre_of_mass()[k]).epsilon(1e-9));
    CHECK(w.energy() == doctest::Approx(e.energy()).epsilon(1e-9));
  }

  TEST_CASE("an arm on its servos moves as in the engine with small steps") {
    const double d = difference<free_arm>(2, 16, waving);
    MESSAGE("largest difference: ", d, " rad");
    CHECK(d < 1e-3);
  }
  TEST_CASE("an Oncilla treads the air as in the engine with small steps") {
    const double d = difference<free_oncilla>(2, 32, treading);
    MESSAGE("largest difference: ", d, " rad");
    CHECK(d < 5e-3);
  }
}
