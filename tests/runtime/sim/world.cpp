// The world: the robot's weight and height, balance of forces, limits, and input that is not a number.
#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "standing.hpp"

using namespace test;

namespace {
const sim::oncilla_model& m = sim::oncilla_defaults;
constexpr double gravity = 9.81;

sim::world standing(const sim::terrain& ground = sim::terrain::flat()) {
  sim::world w(m, ground, crouched());
  for (int k = 0; k < 3000; ++k) w.advance(stand());
  return w;
}
}  // namespace

TEST_SUITE("sim world") {
  TEST_CASE("it weighs 5.1 kg and stands with its hips 0.16 to 0.18 m high") {
    const sim::world w = standing();
    CHECK(w.mass() == doctest::Approx(5.1));
    CHECK(w.hip_height() > 0.16);
    CHECK(w.hip_height() < 0.18);
    CHECK(!w.fallen());
    for (std::size_t shape = 0; shape < w.model().shapes.size(); ++shape)
      CHECK((w.contact(shape).touching > 0) == (w.model().shapes[shape].end >= 0));  // the feet alone
  }

  TEST_CASE("standing, the feet carry the weight and the sensors show gravity") {
    sim::world w = standing();
    sim::vector3 sum{}, force{};
    constexpr int beats = 2000;  // the springs still swing a little: compare means
    for (int k = 0; k < beats; ++k) {
      w.advance(stand());
      for (const sim::robot_reading r = w.reading(); const auto& l : r.legs) {
        for (std::size_t a = 0; a < 3; ++a) sum[a] += l.foot_force[a] / beats;
      }
      for (std::size_t a = 0; a < 3; ++a) force[a] += w.reading().trunk.specific_force[a] / beats;
    }
    CHECK(sum[2] == doctest::Approx(w.mass() * gravity).epsilon(0.01));
    CHECK(std::abs(sum[0]) < 0.5);
    CHECK(std::abs(sum[1]) < 0.5);
    CHECK(std::hypot(force[0], force[1], force[2]) == doctest::Approx(gravity).epsilon(0.01));
    for (const sim::robot_reading r = w.reading(); const auto& l : r.legs) CHECK(l.contact());
  }

  TEST_CASE("in the air there is no contact and no specific force") {
    sim::robot_world_settings weightless;
    weightless.engine.gravity = 0;
    sim::initial_posture up = crouched();
    up.trunk_velocity = {0, 0, 1};
    sim::world w(sim::terrain::flat(), up, weightless);
    for (int k = 0; k < 300; ++k) w.advance(stand());
    for (const sim::robot_reading r = w.reading(); const auto& l : r.legs) CHECK(!l.contact());
    CHECK(w.trunk_position()[2] > 0.25);
  }

  TEST_CASE("torques stay within the limits of the motors for any command") {
    sim::world w(m, sim::terrain::flat(), crouched());
    for (int k = 0; k < 1500; ++k) {
      sim::robot_command wild;
      for (std::size_t i = 0; i < 4; ++i) {
        const double s = (k / 40 + static_cast<int>(i)) % 2 == 0 ? 3 : -3;
        wild[i] = {s, -s, s, 200};
      }
      w.advance(laws_of(wild));
      for (const sim::robot_reading r = w.reading(); const auto& l : r.legs) {
        REQUIRE(std::abs(l.hip.torque) <= m.hip_motor.torque);
        REQUIRE(l.knee.torque >= 0);
        REQUIRE(l.knee.torque <= m.knee_motor.torque);
        REQUIRE(std::abs(l.abduction.torque) <= m.abduction_motor.torque);
        REQUIRE(std::isfinite(l.hip.angle + l.knee.angle + l.abduction.angle + l.toe.angle));
        REQUIRE(l.knee.angle > m.knee_range.low - 0.1);
        REQUIRE(l.knee.angle < m.knee_range.high + 0.1);
        REQUIRE(std::abs(l.toe.angle) < m.toe_range.high + 0.15);
      }
    }
  }

  TEST_CASE("a law that is not finite is ignored: the last finite one is kept, bit for bit") {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    sim::world sound(m, sim::terrain::flat(), crouched()), fed(sound);
    run(sound, 0, 500);
    const laws last = run(fed, 0, 500);
    for (int k = 0; k < 200; ++k) {
      laws bad = last;
      bad[1].position = nan, bad[2].stiffness = inf, bad[4].torque = -inf;
      fed.push({nan, inf, 0});
      sound.push({sound.save().push[0], sound.save().push[1], 0});
      fed.advance(bad);
      sound.advance(last);
    }
    CHECK(fed.hash() == sound.hash());
  }

  TEST_CASE("a push moves it, along the push") {
    sim::world w = standing();
    const double before = w.trunk_position()[1];
    w.push({0, 12, 0});
    for (int k = 0; k < 60; ++k) w.advance(stand());
    w.push({0, 0, 0});
    CHECK(w.trunk_velocity()[1] > 0.03);
    CHECK(w.trunk_position()[1] > before);
    for (int k = 0; k < 2000; ++k) w.advance(stand());
    CHECK(!w.fallen());
  }

  TEST_CASE("pushed on ice it slides away, pushed on rubber it leans and stays") {
    const auto moved_by_push = [](double friction) {
      sim::world w = standing(sim::terrain::flat().with_friction(friction));
      const double before = w.trunk_position()[1];
      w.push({0, 6, 0});
      for (int k = 0; k < 300; ++k) w.advance(stand());
      w.push({0, 0, 0});
      for (int k = 0; k < 1000; ++k) w.advance(stand());
      return std::abs(w.trunk_position()[1] - before);
    };
    CHECK(moved_by_push(0.8) < 0.03);
    CHECK(moved_by_push(0.02) > 0.15);
  }

  TEST_CASE("friction takes the work of its force: on ice, mu times load times the way that the feet slide") {
    constexpr double mu = 0.02;
    sim::world w(m, sim::terrain::flat().with_friction(mu), crouched());
    for (int k = 0; k < 1000; ++k) w.advance(stand());
    const sim::world before = w;
    w.push({0, 6, 0});
    for (int k = 0; k < 300; ++k) w.advance(stand());
    double load = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const sim::foot_account now = w.foot(i), then = before.foot(i);
      const double slip = now.slip - then.slip;
      load += now.load - then.load;
      CHECK(slip > 0);
      CHECK(now.friction_work - then.friction_work > 0.9 * mu * slip);
      CHECK(now.friction_work - then.friction_work < 1.45 * mu * slip);  // a pyramid: up to sqrt(2)
      CHECK(slip / (now.load - then.load) < 0.5);                        // m/s
    }
    CHECK(load == doctest::Approx(w.mass() * gravity * 0.3).epsilon(0.05));
  }

  TEST_CASE("standing, the feet don't slip") {
    const sim::world before = standing();
    sim::world w = before;
    for (int k = 0; k < 1000; ++k) w.advance(stand());
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(w.foot(i).slip - before.foot(i).slip < 0.002 * (w.foot(i).load - before.foot(i).load));
  }

  TEST_CASE("the ground has no end: ten kilometres away the robot stands as at the start") {
    struct place {
      sim::terrain ground;
      double x;  // from the start
    };
    const double pitch = sim::degrees(6);
    for (const auto& [ground, x] :
         {place{sim::terrain::flat(), 1e4}, place{sim::terrain::flat(), -1e4},
          place{sim::terrain::slope(pitch), 1e4}, place{sim::terrain::slope(-pitch), 1e4},
          place{sim::terrain::steps(0.006, 0.6), 1e4}, place{sim::terrain::steps(-0.006, 0.6), 1e4}}) {
      CAPTURE(ground.name());
      CAPTURE(x);
      sim::world w(m, ground, crouched());
      sim::robot_state state = w.save();
      const double up = std::max({ground.height(x - 0.2), ground.height(x), ground.height(x + 0.2)});
      for (auto& body : state.bodies) {
        body.position[0] += x;
        body.position[1] -= x;
        body.position[2] += up;
      }
      w.restore(state);
      for (int k = 0; k < 1500; ++k) w.advance(stand());
      CHECK(!w.fallen());
      CHECK(w.hip_height() == doctest::Approx(0.17).epsilon(0.15));
      double load = 0;
      for (const sim::robot_reading r = w.reading(); const auto& l : r.legs) load += l.foot_force[2];
      CHECK(load == doctest::Approx(w.mass() * gravity).epsilon(0.3));  // on a slope it still swings
    }
  }

  TEST_CASE("on a slope that falls away, every foot finds the ground") {
    const sim::terrain ramp = sim::terrain::slope(sim::degrees(-6), 0.0);
    sim::world w(m, ramp, crouched());
    for (int k = 0; k < 1000; ++k) w.advance(stand());
    for (std::size_t i = 0; i < 4; ++i) {
      const sim::vector3 foot = w.foot_position(i);
      CHECK(foot[2] - ramp.height(foot[0]) == doctest::Approx(m.foot_radius).epsilon(0.25));
    }
  }

  TEST_CASE("terrain: heights, names and refused names") {
    CHECK(sim::terrain::flat().height(7) == 0);
    const sim::terrain slope = sim::terrain::named("slope:5");
    CHECK(slope.height(1.0) == 0);
    CHECK(slope.height(2.5) == doctest::Approx(std::tan(sim::degrees(5))));
    CHECK(sim::terrain::named("slope:-5").height(0) == 0);
    const sim::terrain steps = sim::terrain::named("steps:10");
    CHECK(steps.height(1.4) == 0);
    CHECK(steps.height(1.6) == doctest::Approx(0.010));
    CHECK(steps.height(2.2) == doctest::Approx(0.020));
    CHECK(steps.height(1.5 + 0.6 * 1e6 + 0.3) == doctest::Approx(0.010 * (1e6 + 1)));  // they go on
    CHECK(sim::terrain::steps(0.006, 0.6, 12).height(1e6) == doctest::Approx(0.072));
    CHECK(sim::terrain::named("steps:-10").height(1.6) == doctest::Approx(-0.010));
    CHECK(sim::terrain::flat().height(-1e9) == 0);
    double ground = 1.4;  // strips meet
    steps.strips_between(1.4, 5.0, [&](const sim::ground_strip& s) {
      CHECK(s.begin <= ground);
      ground = s.end;
    });
    CHECK(ground >= 5.0);
    for (const char* bad : {"", "hill", "slope:", "slope:x", "slope:5x", "slope:60", "flat:1", "steps:nan"})
      CHECK_THROWS_AS(sim::terrain::named(bad), std::invalid_argument);
  }

  TEST_CASE("disturbances come from their seed and stay in their ranges") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const auto d = sim::disturbance::from_seed(seed, 20), again = sim::disturbance::from_seed(seed, 20);
      CHECK(d.friction == again.friction);
      CHECK(d.pushes[2].force == again.pushes[2].force);
      CHECK(d.friction >= 0.6);
      CHECK(d.friction < 0.9);
      for (const sim::push& p : d.pushes) {
        const double strength = std::hypot(p.force[0], p.force[1]);
        CHECK(strength >= 8 - 1e-12);
        CHECK(strength <= 16);
        CHECK(p.start >= 2);
        CHECK(p.start < 19);
      }
      for (double x : d.hip_offset) CHECK(std::abs(x) <= 0.06);
      for (double x : d.knee_offset) CHECK(std::abs(x) <= 0.08);
    }
  }
}
