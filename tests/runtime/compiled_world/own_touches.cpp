// A robot that touches itself: which shapes may, what it does to its motion, and the engine beside it.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>

#include <cca/sim/robot/world/robot_world.hpp>

#include "hugging.hpp"
#include "robots.hpp"

using namespace compiled_test;

namespace {

// Two bars on slides along y that turn about x.
template <int Side, class Hand, class Axes>
struct bar_chain : cca::serial_chain<trunk_frame, Hand, Axes> {
  static constexpr std::array joints{cca::prismatic(cca::along_y, cca::at(0, 0.2 * Side - 0.1, 0)),
                                     cca::revolute(cca::along_x)};
  static constexpr auto tip = cca::at(0, 0, 0);
  static constexpr std::array links{cca::link_inertia{0.2, {0, 0, 0}, {1e-4, 1e-4, 1e-4, 0, 0, 0}},
                                    cca::link_inertia{0.5, {0, 0, 0}, {2e-3, 2e-3, 5e-4, 0, 0, 0}}};
};
struct two_bars : hugging {
  using left = bar_chain<0, left_hand, cca::axes<left_shoulder, left_elbow>>;
  using right = bar_chain<1, right_hand, cca::axes<right_shoulder, right_elbow>>;
  struct body : cca::body<trunk_frame, cca::part<"left", left>, cca::part<"right", right>> {
    static constexpr cca::link_inertia base = hugging::body::base;
  };
  using sensors = robots::sensors<>;
  static constexpr auto drives = [] {
    std::array<robots::joint_drive, 4> all{};
    for (auto& d : all) d.motor = {50, 50}, d.stops = false;
    return all;
  }();
  static constexpr std::array shapes{robots::on_base(robots::sphere(0.01)),
                                     robots::on_link("left", 1, robots::capsule(0.03, 0.2)),
                                     robots::on_link("right", 1, robots::capsule(0.03, 0.2))};
};
struct shy : hugging {
  static constexpr bool touches_itself = false;
};

sim::robot_world_settings weightless(int steps) {
  sim::robot_world_settings s;
  s.engine.gravity = 0, s.steps_per_beat = steps;
  return s;
}
std::array<sim::joint_law, 6> torques(const std::array<double, 6>& all) {
  std::array<sim::joint_law, 6> laws;
  for (std::size_t c = 0; c < 6; ++c) laws[c].torque = all[c];
  return laws;
}
constexpr std::array<double, 6> q_of_rest{-0.9, 0, 0, 0.9, 0, 0};
template <class World>
double most_pressing(const World& w) {
  double most = 0;
  for (std::size_t s = 0; s < hugging::shapes.size(); ++s) most = std::max(most, w.contact(s).pressing);
  return most;
}
template <class R>
auto thrown(laws::source& random, double friction, int steps) {
  sim::scene s;
  s.contact.friction = friction;
  sim::compiled_world<R> w(s, weightless(steps));
  numbers<R> q = random_numbers<R>(random, 1.2);
  q[0] -= 0.5, q[3] += 0.5;  // arms away from the trunk
  w.place(q, random_numbers<R>(random, 4), random_place(random), {}, {});
  return w;
}

// About the world's origin: angular, then linear.
template <class R>
Eigen::Matrix<double, 6, 1> momentum(const sim::compiled_world<R>& w) {
  Eigen::Matrix<double, 12, 1> v;
  const auto base = w.frame(-1);
  v << base.where.turn.transpose() * base.angular_velocity, base.where.turn.transpose() * base.velocity,
      speeds_of(w);
  const Eigen::Matrix<double, 6, 1> own = cca::floating_centroidal_momentum_matrix(pose_of(w)) * v;
  const Eigen::Vector3d linear = base.where.turn * own.tail<3>();
  const auto c = w.centre_of_mass();
  Eigen::Matrix<double, 6, 1> all;
  all << base.where.turn * own.head<3>() + Eigen::Vector3d(c[0], c[1], c[2]).cross(linear), linear;
  return all;
}

}  // namespace

TEST_SUITE("compiled world: a robot that touches itself") {
  TEST_CASE("neighbours don't touch, all others may") {
    using probes = sim::detail::probes_of<hugging>;
    const auto has = [](std::size_t i, std::size_t j) {
      for (const auto& p : probes::own_pairs)
        if (p[0] == i && p[1] == j) return true;
      return false;
    };
    CHECK(!has(0, 1));  // trunk and upper arm
    CHECK(has(0, 2));   // trunk and forearm
    CHECK(has(0, 3));
    CHECK(!has(1, 2));  // the link between them has no shape
    CHECK(!has(2, 3));  // the hand is on the forearm's link
    CHECK(!has(1, 3));
    CHECK(has(1, 4));  // the upper arms: the trunk is between them
    CHECK(has(3, 6));
    CHECK(probes::own_pairs.size() == 2 * 2 + 9);
    CHECK(sim::detail::probes_of<shy>::own_pairs.empty());
    const sim::robot_model m = sim::model_of<hugging>();
    REQUIRE(m.own_pairs.size() == probes::own_pairs.size());
    for (std::size_t k = 0; k < m.own_pairs.size(); ++k) CHECK(m.own_pairs[k] == probes::own_pairs[k]);
    CHECK(sim::model_of<shy>().own_pairs.empty());
  }

  TEST_CASE("hands that press the trunk rest where the engine has them, and feel it") {
    sim::scene floor;
    floor.floor = 0;
    sim::scene space;  // the friction of the engine is a pyramid, and hands would drift there
    space.contact.friction = 0;
    sim::robot_world_settings heavy = weightless(8);
    heavy.engine.gravity = 9.81;
    for (const bool stands : {false, true}) {
      const sim::scene around = stands ? floor : space;
      const sim::robot_world_settings settings = stands ? heavy : weightless(8);
      sim::compiled_world<hugging> w(around, settings);
      sim::robot_world e(sim::model_of<hugging>(), around, settings);
      const numbers<hugging> q{-0.9, 0, 0.3, 0.9, 0, -0.3};
      sim::moving_frame base;
      base.where.at = Eigen::Vector3d(0, 0, 0.2);
      w.place(q, {}, cca::at(0, 0, 0.2), {}, {});
      e.place(q, numbers<hugging>{}, base);
      // Shoulders and elbows turn inwards; the twists are held.
      const auto inwards = [](const auto& world) {
        std::array<double, 6> t{-0.2, 0, 0.8, 0.2, 0, -0.8};
        for (std::size_t c = 0; c < 6; ++c)
          t[c] -= 0.3 * world.joints()[c].velocity +
                  (c % 3 == 1 ? 2 : 1) * (c % 3 == 2 ? 0 : world.joints()[c].angle - q_of_rest[c]);
        return torques(t);
      };
      for (int i = 0; i < 4000; ++i) w.advance(inwards(w)), e.advance(inwards(e));
      REQUIRE(!w.trouble());
      for (std::size_t c = 0; c < 6; ++c) {
        CHECK(std::abs(w.joints()[c].velocity) < 1e-2);
        CHECK(std::abs(w.joints()[c].angle - e.joints()[c].angle) < 1e-2);
      }
      CHECK((w.frame(-1).where.at - e.frame(-1).where.at).norm() < 5e-3);
      for (const std::size_t hand : {3u, 6u}) {
        MESSAGE("pressing ", w.contact(hand).pressing, " N, in the engine ", e.contact(hand).pressing);
        CHECK(w.contact(hand).pressing > 1);
        CHECK(w.contact(hand).pressing == doctest::Approx(e.contact(hand).pressing).epsilon(0.02));
      }
      const auto felt = Eigen::Matrix<double, 6, 1>::Map(w.load(0).data()),
                 there = Eigen::Matrix<double, 6, 1>::Map(e.load(0).data());
      MESSAGE("felt ", felt.transpose(), ", in the engine ", there.transpose());
      CHECK(felt.tail<3>().norm() > 1);
      CHECK((felt - there).norm() < 0.05 * felt.norm());
    }
  }

  TEST_CASE(
      "in free flight a touch changes no momentum, to the first order of the step, and brings no energy") {
    std::array<double, 2> worst{};
    int flights = 0, touched = 0, differs = 0;
    double most_energy = 0;
    for (std::size_t fine = 0; fine < 2; ++fine) {
      laws::source random{};
      for (int flight = 0; flight < 60; ++flight) {
        const double friction = flight % 2 == 0 ? 0.0 : 0.8;
        const int steps = fine ? 16 : 4;
        const auto seed = random;
        auto w = thrown<hugging>(random, friction, steps);
        random = seed;
        auto free = thrown<shy>(random, friction, steps);
        w.advance(torques({})), free.advance(torques({}));
        if (w.save().motion.dq != free.save().motion.dq) continue;  // it begins within itself
        const auto before = momentum(w);
        const double energy = w.energy();
        bool passes = true;
        for (int i = 0; i < 400; ++i) {
          w.advance(torques({})), free.advance(torques({}));
          touched += most_pressing(w) > 1;
          passes = passes && most_pressing(free) == 0;
        }
        CHECK(passes);
        REQUIRE(!w.trouble());
        ++flights;
        worst[fine] = std::max(worst[fine], (momentum(w) - before).norm());
        most_energy = std::max(most_energy, w.energy() / energy);
        differs += std::abs(w.joints()[0].angle - free.joints()[0].angle) > 0.01;
      }
    }
    MESSAGE(flights, " flights, ", touched, " beats with a touch, ", differs,
            " end elsewhere than without; momentum off by ", worst[0], " and ", worst[1], "; energy at most ",
            most_energy);
    CHECK(worst[1] < 5e-4);
    CHECK(worst[1] < 0.4 * worst[0]);
    // Where a capsule lies down on a box, its second point begins at a depth.
    CHECK(most_energy < 1.02);
    CHECK(touched > 300);
    CHECK(differs > 20);
  }

  TEST_CASE("capsules that are pressed together rest side by side, as in the engine") {
    sim::scene space;
    space.contact.friction = 0;
    sim::compiled_world<two_bars> w(space, weightless(2));
    sim::robot_world e(sim::model_of<two_bars>(), space, weightless(2));
    const numbers<two_bars> q{0.02, 0.2, -0.02, -0.2};
    w.place(q, {}, {}, {}, {});
    e.place(q, numbers<two_bars>{}, sim::moving_frame{});
    const auto pressed = [](const auto& world) {
      std::array<sim::joint_law, 4> all{};
      const std::array<double, 4> torque{5, 0.3, -5, 0}, damping{5, 0.05, 5, 0.05};
      for (std::size_t c = 0; c < 4; ++c) all[c].torque = torque[c] - damping[c] * world.joints()[c].velocity;
      return all;
    };
    for (int i = 0; i < 3000; ++i) w.advance(pressed(w)), e.advance(pressed(e));
    for (std::size_t c = 0; c < 4; ++c) {
      CHECK(std::abs(w.joints()[c].velocity) < 1e-6);
      CHECK(std::abs(w.joints()[c].angle - e.joints()[c].angle) < 1e-3);
    }
    MESSAGE("pressing ", w.contact(1).pressing, " N, in the engine ", e.contact(1).pressing);
    CHECK(w.contact(1).contacts == 2);
    CHECK(w.contact(1).pressing == doctest::Approx(e.contact(1).pressing).epsilon(1e-3));
  }

  TEST_CASE("capsules that begin with their lines crossing are pushed apart, across both") {
    using triple = sim::detail::triple<double>;
    sim::compiled_world<two_bars> w(sim::scene{}, weightless(2));
    w.place({0.1, 0.6, -0.1, -0.6}, {}, {}, {}, {});
    for (int i = 0; i < 100; ++i) w.advance({});
    CHECK(w.contact(1).pressing > 100);
    CHECK(w.energy() < 1e-12);  // nothing moves that way
    const auto judge = [](const triple& a, const triple& b) {
      const triple n = sim::detail::across_lines(a, b);
      CHECK(sim::detail::dot(n, n) == doctest::Approx(1));
      CHECK(std::abs(sim::detail::dot(n, a)) + std::abs(sim::detail::dot(n, b)) < 1e-12);
    };
    judge({1, 0, 0}, {0, 2, 0}), judge({1, 2, 3}, {1, 2, 3}), judge({0, 0, 1}, {0, 0, -2});
    judge({0, 3, 0}, {}), judge({}, {2, 0, 0}), judge({}, {});
  }

  TEST_CASE("the ends of what two lines have in common") {
    using triple = sim::detail::triple<double>;
    laws::source random{};
    for (int i = 0; i < 1000; ++i) {
      const auto drawn = [&](double size) {
        return triple{random(-size, size), random(-size, size), random(-size, size)};
      };
      const triple m = drawn(1), h = drawn(1), o = drawn(1), k = drawn(1);
      const auto nearest = sim::detail::nearest_of_lines(m, h, o, k),
                 last = sim::detail::last_of_lines(m, h, o, k),
                 turned = sim::detail::last_of_lines(m, h, o, -1.0 * k);
      const auto far = [](const auto& p) {
        const triple off = p.there - p.here;
        return sim::detail::dot(off, off);
      };
      CHECK(far(last) >= far(nearest) - 1e-12);
      CHECK(far(last) == doctest::Approx(far(turned)));
      // Each is on its line, and one of them is an end.
      const auto share = [](const triple& p, const triple& middle, const triple& half) {
        const double s = sim::detail::dot(p - middle, half) / sim::detail::dot(half, half);
        const triple off = p - middle - s * half;
        CHECK(sim::detail::dot(off, off) < 1e-20);
        CHECK(std::abs(s) < 1 + 1e-12);
        return std::abs(s);
      };
      CHECK(std::max(share(last.here, m, h), share(last.there, o, k)) == doctest::Approx(1));
    }
    const auto both = sim::detail::last_of_lines<double>({0, 0, 0}, {1, 0, 0}, {1.5, 1, 0}, {-1, 0, 0});
    CHECK(both.here[0] == 1);
    CHECK(both.there[0] == 1);
  }

  TEST_CASE("copies go on bit for bit") {
    laws::source random{};
    auto w = thrown<hugging>(random, 0.5, 2);
    sim::compiled_world<hugging> copy = w;
    for (int i = 0; i < 300; ++i) {
      w.advance(torques({-0.3, 0, 0.5, 0.3, 0, -0.5}));
      copy.advance(torques({-0.3, 0, 0.5, 0.3, 0, -0.5}));
    }
    CHECK(w.save().motion.q == copy.save().motion.q);
    CHECK(w.save().motion.dq == copy.save().motion.dq);
  }
}
