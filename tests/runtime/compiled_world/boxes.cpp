// Boxes around a robot in a compiled world: as a floor, tilted, with edges, moved by the program; and the
// engine beside it.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <string>

#include <cca/robot/body_dynamics.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

#include "../dual.hpp"
#include "robots.hpp"

namespace laws {
std::size_t allocations();  // in tests/laws/allocations.cpp
}

using namespace compiled_test;
using test::dual;

namespace {

sim::scene with_box(const sim::fixed_box& b, double friction = 0.75) {
  sim::scene s;
  s.contact.friction = friction;
  s.add(b);
  return s;
}
// Its top is at z = 0.
sim::scene with_table(double x, double y, double friction = 0.75) {
  return with_box({{x, y, 0.2}, cca::at(0, 0, -0.1)}, friction);
}
sim::scene with_floor(double friction = 0.75) {
  sim::scene s;
  s.floor = 0, s.contact.friction = friction;
  return s;
}
template <class R>
sim::compiled_world<R> put(const sim::scene& s,
                           const cca::placement& where,
                           std::array<double, 3> velocity = {}) {
  sim::compiled_world<R> w(s);
  w.place({0}, {0}, where, {}, velocity);
  return w;
}
template <class World>
bool same_bits(const World& a, const World& b) {
  return std::memcmp(&a.save().motion, &b.save().motion, sizeof a.save().motion) == 0 &&
         std::memcmp(&a.save().around, &b.save().around, sizeof a.save().around) == 0;
}

using arm_world = sim::compiled_world<robots::arm::description>;

// Compensates gravity, damps, and presses the flange with `force`.
template <class World>
void press(World& w, const Eigen::Vector3d& force) {
  using pose = cca::body_pose<robots::arm::body>;
  pose::vector_type q;
  for (int i = 0; i < 7; ++i) q[i] = w.joints()[static_cast<std::size_t>(i)].angle;
  const pose now(q);
  const pose::vector_type torques =
      cca::gravity_torques(now) + now.jacobian<"arm">().bottomRows<3>().transpose() * force;
  std::array<sim::joint_law, 7> laws;
  for (std::size_t i = 0; i < 7; ++i)
    laws[i] = {.torque = torques[static_cast<Eigen::Index>(i)], .damping = 4};
  w.advance(laws);
}
template <class World>
Eigen::Vector3d felt(const World& w) {
  return w.end(0).where.turn * Eigen::Vector3d::Map(w.load(0).data() + 3);
}

// How far a sledge on a table slides in 0.1 s, by the speed that it starts with.
template <class Real>
Real slid(const Real& speed) {
  sim::compiled_world<sledge, Real> w(with_table(4, 4));
  w.place({}, {}, cca::at(0, 0, 0.05 + radius - deep(3)), {}, {speed, Real(0.0), Real(0.0)});
  for (int i = 0; i < 100; ++i) w.advance({});
  return w.centre_of_mass()[0];
}

}  // namespace

TEST_SUITE("compiled world: boxes") {
  TEST_CASE_TEMPLATE("a table is as a floor of that height", R, sledge, crate, roller) {
    const double height = std::is_same_v<R, sledge> ? 0.06 : std::is_same_v<R, crate> ? 0.05 : 0.02;
    for (const std::array<double, 3> speed : {std::array{0.0, 0.0, 0.0}, std::array{1.0, -0.4, -0.5}}) {
      auto on_table = put<R>(with_table(8, 8), cca::at(0, 0, height), speed);
      auto on_floor = put<R>(with_floor(), cca::at(0, 0, height), speed);
      double most = 0;
      for (int i = 0; i < 400; ++i) {
        on_table.advance({}), on_floor.advance({});
        most = std::max(most, (on_table.frame(-1).where.at - on_floor.frame(-1).where.at).norm());
      }
      MESSAGE("largest distance: ", most, " m");
      // Corners come in another order, and contacts are solved to 1e-6 m/s.
      CHECK(most < (std::is_same_v<R, crate> ? 1e-6 : 1e-9));
      CHECK(on_table.contact(0).load == doctest::Approx(on_floor.contact(0).load).epsilon(1e-4));
      CHECK(on_table.contact_of_base().load > 0.3 * mass * gravity);
    }
  }

  TEST_CASE("on a tilted box a sledge sticks below the angle of friction, and slides as Coulomb says above") {
    const auto tilted = [](double pitch) {
      const auto tilt = cca::turned_about(cca::along_y, -pitch);
      auto w = put<sledge>(with_box({{40, 4, 0.2}, tilt * cca::at(0, 0, -0.1)}),
                           tilt * cca::at(0, 0, 0.05 + radius - deep(3)));
      return w;
    };
    for (const double degrees : {20.0, 36.0}) {
      auto w = tilted(degrees * half_turn / 180);
      run(w, 1000);
      const Eigen::Vector3d before = w.frame(-1).where.at;
      run(w, 1000);
      CHECK(speed(w) < 1e-9);
      CHECK((w.frame(-1).where.at - before).norm() < 1e-9);
    }
    auto w = tilted(0.8);
    run(w, 200);
    const double from = speed(w);
    run(w, 200);
    CHECK(speed(w) - from ==
          doctest::Approx(0.2 * gravity * (std::sin(0.8) - 0.75 * std::cos(0.8))).epsilon(1e-5));
  }

  TEST_CASE("an arm presses a table as in the engine") {
    const Eigen::Vector3d tip =
        cca::body_pose<robots::arm::body>(
            cca::body_pose<robots::arm::body>::vector_type::Map(robots::arm::description::start.data()))
            .tip<"arm">()
            .at;
    const double under = tip[2] - 2 * robots::arm::description::tool_radius - 0.002;
    const sim::scene room = with_box({{0.4, 0.6, 0.04}, cca::at(tip[0], 0, under - 0.02)});
    arm_world w(room);
    sim::robot_world e(sim::model_of<robots::arm::description>(), room);
    press(w, {0, 0, -10});
    CHECK(felt(w).norm() == 0);  // not there yet
    for (const Eigen::Vector3d& force : {Eigen::Vector3d(0, 0, -10), Eigen::Vector3d(3, 4, -20)}) {
      for (int i = 0; i < 3000; ++i) press(w, force), press(e, force);
      MESSAGE("force: ", felt(w).transpose(), ", in the engine ", felt(e).transpose());
      CHECK((felt(w) + force).norm() < 0.05 * force.norm());
      CHECK((felt(w) - felt(e)).norm() < 0.03 * force.norm());
      CHECK((w.end(0).where.at - e.end(0).where.at).norm() < 1e-3);
    }
  }

  TEST_CASE("a crate lies across the edge of a table, and falls off once its middle is beyond it") {
    const double height = 0.05 - deep(4);
    auto w = put<crate>(with_table(0.4, 0.4), cca::at(0.18, 0, height));
    run(w, 1000);
    CHECK(w.frame(-1).where.at[2] == doctest::Approx(height).epsilon(0.01));
    CHECK(std::abs(w.frame(-1).where.turn(2, 0)) < 0.005);
    CHECK(w.contact(0).pressing == doctest::Approx(mass * gravity).epsilon(1e-3));
    auto beyond = put<crate>(with_table(0.4, 0.4), cca::at(0.23, 0, height));
    run(beyond, 1000);
    CHECK(beyond.frame(-1).where.at[2] < -0.1);
    CHECK(std::abs(beyond.frame(-1).where.turn(2, 0)) > 0.3);
  }

  TEST_CASE("corners of a box carry a robot's box: a crate on a post") {
    const double height = 0.05 - deep(4);
    auto w = put<crate>(with_table(0.05, 0.05), cca::at(0.01, 0, height));
    run(w, 1000);
    CHECK(w.frame(-1).where.at[2] == doctest::Approx(height).epsilon(0.01));
    CHECK(w.contact(0).contacts == 4);
  }

  TEST_CASE("edges that cross carry each other") {
    // A crate on one of its long edges, on the edge of a beam: it is balanced for a moment.
    const auto on_edge = cca::turned_about(cca::along_x, half_turn / 4);
    const double low = (0.2 + 0.1) / 2 / std::sqrt(2.0), beam = 0.1 / std::sqrt(2.0);
    auto w = put<crate>(with_box({{0.1, 1, 0.1}, cca::turned_about(cca::along_y, half_turn / 4)}),
                        cca::at(0, 0, beam + low - deep(1)) * on_edge);
    const double before = w.frame(-1).where.at[2];
    run(w, 50);
    CHECK(w.contact(0).contacts == 1);
    CHECK(std::abs(w.frame(-1).where.at[2] - before) < 2e-3);
    CHECK(w.contact(0).load > 0.5 * mass * gravity * 0.05);
  }

  TEST_CASE("the middle of a capsule touches: it lies across a beam, and hangs over the edge of a table") {
    const double height = 0.02 - deep(2);
    auto on_beam = put<roller>(with_table(0.06, 1), cca::at(0, 0, height));
    auto over_edge = put<roller>(with_table(0.5, 0.4), cca::at(0.2, 0, height));
    for (auto* w : {&on_beam, &over_edge}) {
      run(*w, 1000);
      CHECK(w->frame(-1).where.at[2] == doctest::Approx(height).epsilon(0.02));
      CHECK(w->contact(0).contacts == 2);
      CHECK(w->contact(0).pressing == doctest::Approx(mass * gravity).epsilon(1e-3));
    }
    auto beyond = put<roller>(with_table(0.5, 0.4), cca::at(0.27, 0, height));
    run(beyond, 1000);
    CHECK(beyond.frame(-1).where.at[2] < -0.1);
    // It leans on an edge with its middle: pushed away across both, here without friction.
    const auto lean = cca::turned_about(cca::along_y, half_turn / 4);
    auto leaning =
        put<roller>(with_table(0.5, 0.4, 0), cca::at(0.25, 0, 0) * lean * cca::at(0, 0, 0.02 - 0.001));
    leaning.advance({});
    const auto v = leaning.frame(-1).velocity;
    CHECK(v[0] > 1e-3);
    CHECK(std::abs(v[0] - (v[2] + gravity * 1e-3)) < 1e-5);
  }

  TEST_CASE("a table that moves carries what stands on it, up to its friction") {
    const auto at = [](double t, double acceleration) {
      return cca::at(acceleration * t * t / 2, 0.1 * t, -0.1 + 0.05 * t);
    };
    for (const double acceleration : {2.0, 4.0}) {  // friction bears 2.943 m/s^2
      auto w = put<sledge>(with_table(10, 4, 0.3), cca::at(0, 0, 0.05 + radius - deep(3)));
      for (int i = 0; i < 100; ++i) w.advance({});
      for (int i = 1; i <= 500; ++i) w.move(0, at(1e-3 * i, acceleration)), w.advance({});
      const Eigen::Vector3d v = w.frame(-1).velocity;
      MESSAGE("velocity: ", v.transpose());
      CHECK(v[2] == doctest::Approx(0.05).epsilon(1e-3));
      if (acceleration < 3) {
        CHECK(v[0] == doctest::Approx(acceleration * 0.5).epsilon(2e-3));
        CHECK(v[1] == doctest::Approx(0.1).epsilon(1e-2));
      } else {
        CHECK(v.head<2>().norm() == doctest::Approx(0.3 * gravity * 0.5).epsilon(2e-2));
        CHECK(w.contact_of_base().friction_work > 0.1);
      }
    }
    // One that turns takes it round.
    auto w = put<sledge>(with_table(2, 2), cca::at(0, 0, 0.05 + radius - deep(3)));
    const auto turned = [](double angle) {
      return cca::turned_about(cca::along_z, angle) * cca::at(0, 0, -0.1);
    };
    for (int i = 1; i <= 1000; ++i) w.move(0, turned(5e-7 * i * i)), w.advance({});
    CHECK(w.frame(-1).angular_velocity[2] == doctest::Approx(1).epsilon(5e-3));
    // It is where the program has put it: the next move begins there, and without one it rests.
    for (int i = 0; i < 500; ++i) w.advance({});
    CHECK(w.frame(-1).angular_velocity.norm() < 1e-6);
    CHECK(w.save().around.boxes[0].attitude.q[2] == doctest::Approx(std::sin(0.25)).epsilon(1e-12));
  }

  TEST_CASE("a table that is elsewhere at once takes nothing with it") {
    auto w = put<sledge>(with_table(1, 1), cca::at(0, 0, 0.05 + radius - deep(3)));
    run(w, 500);
    w.move(0, cca::at(3, 0, -0.1));
    run(w, 100);
    const Eigen::Vector3d v = w.frame(-1).velocity;
    CHECK(v[2] == doctest::Approx(-0.1 * gravity).epsilon(1e-6));
    CHECK(v.head<2>().norm() < 1e-9);
    // One that comes up into it pushes it out as fast as contacts correct.
    auto up = put<sledge>(with_table(1, 1), cca::at(0, 0, 0.05 + radius - deep(3)));
    run(up, 500);
    up.move(0, cca::at(0, 0, -0.08));
    for (int i = 0; i < 1000; ++i) up.advance({}), CHECK(speed(up) < 1.1);
    CHECK(up.frame(-1).where.at[2] == doctest::Approx(0.02 + 0.05 + radius - deep(3)).epsilon(1e-3));
  }

  TEST_CASE("copy, save and restore go on bit for bit with a table that moves, and nothing allocates") {
    auto w = put<crate>(with_table(1, 1), cca::at(0, 0, 0.06));
    const auto go = [](auto& world, int i) {
      world.move(0, cca::at(1e-5 * i * i, 0, -0.1) * cca::turned_about(cca::along_y, 1e-3 * i));
      world.advance({});
    };
    for (int i = 0; i < 50; ++i) go(w, i);
    auto copy = w;
    const auto saved = w.save();
    const std::size_t before = laws::allocations();
    for (int i = 50; i < 100; ++i) go(w, i), go(copy, i);
    CHECK(laws::allocations() == before);
    CHECK(same_bits(w, copy));
    w.restore(saved);
    CHECK_FALSE(same_bits(w, copy));
    for (int i = 50; i < 100; ++i) go(w, i);
    CHECK(same_bits(w, copy));
    static_assert(std::is_trivially_copyable_v<sim::compiled_world<crate>>);
  }

  TEST_CASE("a dual number as scalar gives the derivative, with boxes, too") {
    const dual by_speed = slid(dual(1.2, 1));
    CHECK(by_speed.value == slid(1.2));
    const double d = 1e-5, difference = (slid(1.2 + d) - slid(1.2 - d)) / (2 * d);
    MESSAGE("by dual numbers ", by_speed.slope, ", by differences ", difference);
    CHECK(by_speed.slope == doctest::Approx(difference).epsilon(1e-4));
    CHECK(std::abs(by_speed.slope) > 0.05);
  }

  TEST_CASE("a robot on a step of a box stands as in the engine") {
    sim::scene s = with_floor();
    s.add(sim::fixed_box{{0.4, 1, 0.04}, cca::at(0.3, 0, 0.02)});  // under the foot in front
    auto w = put<sledge>(s, cca::at(0, 0, 0.09));
    sim::robot_world e(sim::model_of<sledge>(), s);
    sim::moving_frame base;
    base.where.at = Eigen::Vector3d(0, 0, 0.09);
    e.place(std::vector{0.0}, std::vector{0.0}, base);
    run(w, 3000), run(e, 3000);
    const auto &a = w.frame(-1).where, b = e.frame(-1).where;
    MESSAGE("pitch ", a.turn(2, 0), " ", b.turn(2, 0), ", height ", a.at[2], " ", b.at[2]);
    CHECK(std::abs(a.turn(2, 0) - b.turn(2, 0)) < 2e-3);
    CHECK(std::abs(a.at[2] - b.at[2]) < 5e-4);
    CHECK(a.turn(2, 0) > 0.1);
  }

  TEST_CASE("more boxes than there is room for, and a box or a place that is none, are refused") {
    sim::scene s;
    for (int i = 0; i < 8; ++i) s.add(sim::fixed_box{{1, 1, 1}, cca::at(3 + i, 0, 0)});
    sim::compiled_world<sledge> w(s);
    w.move(7, cca::at(20, 0, 0));
    CHECK_THROWS_WITH_AS(w.move(8, {}), doctest::Contains("there is no box 8"), std::out_of_range);
    CHECK_THROWS_WITH_AS(w.move(0, cca::at(0, NAN, 0)),
                         doctest::Contains("the place of box 0 of the scene along y"), std::invalid_argument);
    s.add(sim::fixed_box{{1, 1, 1}, cca::at(12, 0, 0)});
    CHECK_THROWS_WITH_AS(sim::compiled_world<sledge>{s},
                         doctest::Contains("9 boxes, and there is room for 8"), std::invalid_argument);
    CHECK_THROWS_WITH_AS(sim::compiled_world<sledge>{s}, doctest::Contains("cca::sim::robot_world"),
                         std::invalid_argument);
    s.boxes.resize(2), s.boxes[1].size[2] = -1;
    CHECK_THROWS_WITH_AS(sim::compiled_world<sledge>{s}, doctest::Contains("box 1"), std::invalid_argument);
  }
}
