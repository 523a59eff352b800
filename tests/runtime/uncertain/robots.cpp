// Robots that are not ideal as nodes, in both worlds: without uncertainty the bits of the plain one, and each
// effect of sensors, drives and battery on a whole robot.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/sim/compiled/robot.hpp>
#include <cca/sim/robot.hpp>
#include <cca/sim/uncertain/uncertain_robot.hpp>

#include "close_to.hpp"

namespace laws {
std::size_t allocations();  // in tests/laws/allocations.cpp
}

namespace {

using uncertain_test::close_to;

namespace arm = cca::robots::arm;
namespace sim = cca::sim;
using angles = arm::angles::vector_type;

// Targets that move by themselves, or stand where a test puts them.
struct waving {
  auto process(cca::beat now) -> cca::out<"angles", arm::angles> {
    const double way = swing * (1 - cca::math::cos(6e-9 * static_cast<double>(now.time())));
    angles q = angles::Map(arm::description::start.data());
    for (Eigen::Index i = 0; i < 7; ++i) q[i] += shift + (i % 2 ? way : -way);
    return q;
  }
  double swing = 0.1, shift = 0;
};
template <class Robot>
struct moved : cca::graph<cca::node<"targets", waving>,
                          cca::node<"limits", cca::limiter<arm::angles>>,
                          cca::node<"robot", Robot>,
                          cca::wire<"targets.angles", "limits.command">,
                          cca::wire<"robot.angles", "limits.measured">,
                          cca::wire<"limits.safe", "robot.position">,
                          cca::observe<"robot.angles">,
                          cca::observe<"robot.flange_load">> {};
template <class World>
struct plain_arm : moved<sim::robot<arm::description, World>> {};
// [robot]
template <class World>  // cca::sim::robot_world or cca::sim::compiled
struct uncertain_arm : moved<sim::robot<arm::description, sim::uncertain<World>>> {};
// [robot end]
using in_compiled = cca::controller<uncertain_arm<sim::compiled>>;
static_assert(cca::well_formed<uncertain_arm<sim::compiled>>);

template <class Controller>
Controller loaded(const sim::uncertainty& u = {}) {
  Controller c;
  c.load();
  if constexpr (requires { c.template get<"robot.simulator">().p; }) c.template set<"robot.simulator">(u);
  return c;
}
template <class Controller>
auto& joints(Controller& c) {
  return c.template get<"robot.simulator">().world().joints();
}
template <class Controller>
angles measured(const Controller& c) {
  angles q = angles::Zero();
  c.observed([&](const cca::observation& one) {
    if (one.path == "robot.angles")
      for (std::size_t i = 0; i < 7; ++i) q[static_cast<Eigen::Index>(i)] = one.values[i];
  });
  return q;
}

// Angle of every joint after each of some beats.
template <class Controller>
std::vector<double> way_of(Controller c, int beats) {
  std::vector<double> way;
  c.start();
  for (int k = 0; k < beats; ++k) {
    REQUIRE(c.step());
    for (const auto& j : joints(c)) way.push_back(j.angle);
  }
  return way;
}
bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

sim::uncertainty much(std::int64_t seed) {
  sim::uncertainty u{};
  u.seed = seed;
  u.angle.noise = 0.001, u.angle.loss = 0.1, u.velocity.bias = 0.1, u.load.noise = 0.3;
  u.drives.delay = 0.004, u.drives.backlash = 0.002, u.drives.strength = 0.1, u.drives.friction = 0.5;
  u.drives.dry_friction = 0.2, u.drives.loss = 0.1;
  u.battery.open_circuit = 24, u.battery.resistance = 0.3, u.battery.mean = 0.01;
  return u;
}

}  // namespace

TEST_SUITE("uncertain: robots") {
  TEST_CASE("without uncertainty it has the bits of the plain robot, in both worlds") {
    CHECK(same_bits(way_of(loaded<cca::controller<plain_arm<sim::compiled>>>(), 300),
                    way_of(loaded<in_compiled>(), 300)));
    CHECK(same_bits(way_of(loaded<cca::controller<plain_arm<sim::robot_world>>>(), 300),
                    way_of(loaded<cca::controller<uncertain_arm<sim::robot_world>>>(), 300)));
  }

  TEST_CASE("the same seed gives the same bits, another one others, a copy goes on, and nothing allocates") {
    const auto once = way_of(loaded<in_compiled>(much(1)), 300);
    CHECK(same_bits(once, way_of(loaded<in_compiled>(much(1)), 300)));
    CHECK(apart(once, way_of(loaded<in_compiled>(much(2)), 300)) > 1e-5);
    const auto engine = way_of(loaded<cca::controller<uncertain_arm<sim::robot_world>>>(much(1)), 300);
    CHECK(apart(once, engine) < 2e-3);

    auto c = loaded<in_compiled>(much(1));
    c.start();
    for (int k = 0; k < 100; ++k) c.step();
    auto copy = c;
    const std::size_t before = laws::allocations();
    for (int k = 0; k < 100; ++k) c.step();
    CHECK(laws::allocations() == before);
    for (int k = 0; k < 100; ++k) copy.step();
    for (std::size_t i = 0; i < 7; ++i) CHECK(joints(c)[i].angle == joints(copy)[i].angle);
    // Another start is the same run again: what was drawn is drawn again.
    c.stop();
    c.start();
    CHECK(c.get<"robot.simulator">().power() == 0);
  }

  TEST_CASE("a file sets it") {
    // [set]
    cca::controller<uncertain_arm<cca::sim::compiled>> c;
    cca::sim::uncertainty u{};
    u.seed = 7;
    u.velocity.bias = 0.1;
    c.load();
    c.set<"robot.simulator">(u);
    c.set("robot.simulator.angle.noise", "2 deg");
    c.set("robot.simulator.drives.delay", "5 ms");
    // [set end]
    CHECK(c.get<"robot.simulator">().p.seed == 7);
    CHECK(close_to(c.get<"robot.simulator">().p.angle.noise, 2 * cca::pi / 180));
    CHECK(close_to(c.get<"robot.simulator">().p.drives.delay, 0.005));
    CHECK_THROWS_WITH_AS(c.set("robot.simulator.angle.noise", -1.0),
                         doctest::Contains("robot.simulator.angle.noise: -1 rad is out of range"),
                         cca::refused);
  }

  TEST_CASE("what the robot measures has the noise and the bias, its motion has not") {
    sim::uncertainty u{};
    u.angle.noise = 0.01, u.angle.bias = 0.02;
    auto c = loaded<in_compiled>(u), ideal = loaded<in_compiled>();
    c.get<"targets">().swing = ideal.get<"targets">().swing = 0;
    c.start(), ideal.start();
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(7), square = sum;
    constexpr int beats = 2000;
    std::array<double, 7> before{};
    for (int k = 0; k < beats; ++k) {
      for (std::size_t i = 0; i < 7; ++i) before[i] = joints(c)[i].angle;
      c.step(), ideal.step();
      const Eigen::ArrayXd off = (measured(c) - angles::Map(before.data())).array();
      sum += off, square += off * off;
    }
    const Eigen::ArrayXd mean = sum / beats;
    CHECK(((square / beats - mean * mean).sqrt() - 0.01).abs().maxCoeff() < 0.001);
    CHECK(mean.abs().maxCoeff() > 0.01);
    CHECK(mean.abs().maxCoeff() < 0.061);
    for (std::size_t i = 0; i < 7; ++i) CHECK(std::abs(joints(c)[i].angle - joints(ideal)[i].angle) < 1e-9);
  }

  TEST_CASE("a delay of sensors and of drives is exact, in beats") {
    sim::uncertainty u{};
    u.angle.delay = 0.012;
    auto late = loaded<in_compiled>(u), ideal = loaded<in_compiled>();
    late.start(), ideal.start();
    std::vector<angles> past;
    for (std::size_t k = 0; k < 200; ++k) {
      late.step(), ideal.step();
      past.push_back(measured(ideal));
      REQUIRE(measured(late) == past[k < 12 ? 0 : k - 12]);
    }
    // A drive that is 20 beats late does the same 20 beats later, from a robot that rests.
    u = {};
    u.drives.delay = 0.02;
    auto at_once = loaded<in_compiled>(), behind = loaded<in_compiled>(u);
    at_once.get<"targets">().swing = behind.get<"targets">().swing = 0;
    at_once.start(), behind.start();
    for (int k = 0; k < 1500; ++k) at_once.step(), behind.step();  // it comes to rest
    at_once.get<"targets">().shift = behind.get<"targets">().shift = 0.05;
    std::vector<double> first, second;
    for (int k = 0; k < 120; ++k) {
      at_once.step(), behind.step();
      first.push_back(joints(at_once)[3].angle), second.push_back(joints(behind)[3].angle);
    }
    const double rest = second[0];
    for (std::size_t k = 0; k < 20; ++k) REQUIRE(close_to(second[k], rest, 1e-9));
    CHECK(std::abs(second[21] - rest) > 1e-6);
    for (std::size_t k = 20; k < 120; ++k) REQUIRE(std::abs(second[k] - first[k - 20]) < 1e-5);
  }

  TEST_CASE("backlash: a position is lost motion behind, on the side from which it comes") {
    sim::uncertainty u{};
    u.drives.backlash = 0.02;
    auto c = loaded<in_compiled>(u), ideal = loaded<in_compiled>();
    c.get<"targets">().swing = ideal.get<"targets">().swing = 0;
    c.start(), ideal.start();
    const auto go_to = [&](double shift) {
      c.get<"targets">().shift = ideal.get<"targets">().shift = shift;
      for (int k = 0; k < 2000; ++k) c.step(), ideal.step();
      return joints(c)[3].angle - joints(ideal)[3].angle;
    };
    CHECK(close_to(go_to(0.1), -0.01, 0.02));
    CHECK(close_to(go_to(0.095), -0.005, 0.02));  // within the play: it stays
    CHECK(close_to(go_to(0.05), 0.01, 0.02));
    CHECK(close_to(go_to(0.1), -0.01, 0.02));
  }

  TEST_CASE("a bounded speed of the position") {
    sim::uncertainty u{};
    u.drives.speed = 0.1;
    auto c = loaded<in_compiled>(u);
    c.get<"targets">().swing = 0;
    c.start();
    for (int k = 0; k < 500; ++k) c.step();
    const double from = joints(c)[3].angle;
    c.get<"targets">().shift = 0.3;
    for (int k = 0; k < 1000; ++k) c.step();
    CHECK(close_to(joints(c)[3].angle - from, 0.1, 0.05));
  }

  TEST_CASE("friction that is not known: each joint its own, and beneath the bound") {
    sim::uncertainty u{};
    u.drives.dry_friction = 2, u.drives.friction = 1;
    auto c = loaded<in_compiled>(u);
    c.start();
    c.step();
    double least = 10, most = 0;
    for (const auto& d : c.get<"robot.simulator">().world().save().conditions) {
      least = std::min(least, d.dry_friction), most = std::max(most, d.dry_friction);
      CHECK(d.friction <= 1);
      CHECK(d.strength == 1);
    }
    CHECK(least >= 0);
    CHECK(most <= 2);
    CHECK(most - least > 0.2);
    // Back to nothing while it runs.
    c.set<"robot.simulator">(sim::uncertainty{});
    c.step();
    for (const auto& d : c.get<"robot.simulator">().world().save().conditions) CHECK(d.dry_friction == 0);
  }

  TEST_CASE("a battery sags while the motors work, and recovers") {
    sim::uncertainty u{};
    u.battery.open_circuit = 24, u.battery.resistance = 0.5, u.battery.mean = 0.05;
    auto c = loaded<in_compiled>(u);
    c.get<"targets">().swing = 0;
    c.start();
    const auto& robot = c.get<"robot.simulator">();
    for (int k = 0; k < 1500; ++k) c.step();
    const double at_rest = robot.supply();
    c.get<"targets">().swing = 0.6;
    double least = 1, power = 0;
    for (int k = 0; k < 1000; ++k) {
      c.step();
      if (robot.supply() < least) least = robot.supply(), power = robot.power();
    }
    MESSAGE("at rest ", at_rest, ", least ", least, " at ", power, " W");
    CHECK(least < at_rest - 0.01);
    const double volts = 24 * least;  // what it gives: U (V - U) / R
    CHECK(close_to(volts * (24 - volts) / 0.5, power, 1e-6));
    // The drives feel what was left before this beat, at most 1 ms old.
    CHECK(robot.world().save().conditions[0].supply == robot.supply());
    c.get<"targets">().swing = 0;
    for (int k = 0; k < 2500; ++k) c.step();
    CHECK(close_to(robot.supply(), at_rest, 1e-3));
  }
}
