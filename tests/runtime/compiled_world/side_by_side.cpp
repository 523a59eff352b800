// Worlds that advance together have the bits that they have alone: with other grounds, masses, drives,
// pushes, frictions; when one falls out; in groups of any size.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/compiled/together/side_by_side.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>
#include <cca/sim/uncertain/uncertainty.hpp>

#include "robots.hpp"

namespace sim = cca::sim;

namespace {

using alone = sim::compiled_oncilla_world;
using beside = sim::side_by_side<alone>;

// Each world treads in its own phase. Now and then a law is not finite.
std::array<sim::joint_law, 16> laws_of(std::size_t which, int beat) {
  std::array<sim::joint_law, 16> all;
  const double phase = 0.02 * beat + 0.7 * static_cast<double>(which);
  for (std::size_t leg = 0; leg < 4; ++leg) {
    const double p = phase + (leg == 1 || leg == 2 ? 3.14159 : 0);
    const auto& d = cca::robots::oncilla::as_built::drives;
    const auto law = [&](std::size_t i, double position) {
      const std::size_t c = 4 * leg + i;
      all[c] = {.position = position, .stiffness = d[c].position_stiffness(), .damping = d[c].damping};
    };
    law(0, 0), law(1, 0.7 + 0.3 * std::sin(p)), law(2, 1.4 + 0.3 * std::cos(p)), law(3, 0);
  }
  if (beat % 97 == 5) all[1].position = std::nan("");
  return all;
}

sim::terrain ground_of(std::size_t which) {
  constexpr double start = -0.3;
  switch (which % 5) {
    case 0:
      return sim::terrain::flat();
    case 1:
      return sim::terrain::steps(0.006, 0.1, 40, start).with_friction(0.6);
    case 2:
      return sim::terrain::slope(0.1, start).with_friction(0.9);
    case 3:
      return sim::terrain::slope(-0.1, start).with_friction(0.3);
    default:
      return sim::terrain::steps(-0.01, 0.07, 40, start);
  }
}

sim::uncertainty drawn(std::size_t which) {
  sim::uncertainty u{};
  u.seed = static_cast<std::int64_t>(which);
  if (which % 3 > 0) u.body.mass = 0.1;
  return u;
}

template <class World>
World begun(std::size_t which) {
  sim::initial_posture posture = sim::standing_posture();
  posture.trunk_velocity = {0.1 * static_cast<double>(which % 4), 0.05, 0};
  return World(ground_of(which), posture, sim::drawn_settings(drawn(which)));
}

template <class World>
void disturb(World& w, std::size_t which, int beat) {
  if (beat == 100 + 10 * static_cast<int>(which)) w.push({20, -10.0 * static_cast<double>(which % 3), 5});
  if (beat == 160 + 10 * static_cast<int>(which)) w.push({});
  if (beat == 200 && which % 2 == 1) w.pull("left_front_leg", {1, 2, 3}, {0.01, 0, 0.02});
  if (beat == 50 && which % 4 > 0) {  // other drives in each, and the first of four as described
    cca::random_numbers random(which);
    std::array<sim::drive_condition, 16> worn;
    for (std::size_t c = 0; c < 16; ++c)
      worn[c] = {.strength = 1 - 0.3 * random.uniform(),
                 .supply = 1 - 0.1 * random.uniform(),
                 .friction = which % 4 == 3 ? 0 : 0.05 * random.uniform(),
                 .dry_friction = which % 4 == 2 && c % 2 == 0 ? 0 : 0.1 * random.uniform()};
    w.set_condition(worn);
  }
}

// What a program can see of a world and what its next beat depends on, but for the order and number of
// impulses that are zero.
int differences(const alone& a, const alone& b) {
  int differ = 0;
  const auto same = [&](double x, double y) { differ += !(x == y || (x != x && y != y)); };
  const auto each = [&](const auto& x, const auto& y) {
    for (std::size_t k = 0; k < x.size(); ++k) same(x[k], y[k]);
  };
  const auto &s = a.save(), &t = b.save();
  sim::detail::each_number_of_motion(s.motion, t.motion, same);
  for (std::size_t c = 0; c < 16; ++c) {
    same(s.joints[c].angle, t.joints[c].angle), same(s.joints[c].velocity, t.joints[c].velocity);
    same(s.joints[c].torque, t.joints[c].torque), same(s.drives.torque[c], t.drives.torque[c]);
    const auto &p = s.drives.pulleys[c], &q = t.drives.pulleys[c];
    same(p.wound, q.wound), same(p.wanted, q.wanted), same(p.speed, q.speed), same(p.torque, q.torque);
    same(s.drives.laws[c].position, t.drives.laws[c].position);
    same(s.drives.laws[c].stiffness, t.drives.laws[c].stiffness);
  }
  for (std::size_t i = 0; i < s.loads.size(); ++i) each(s.loads[i], t.loads[i]);
  for (std::size_t i = 0; i < s.end_forces.size(); ++i) each(s.end_forces[i], t.end_forces[i]);
  for (std::size_t i = 0; i < s.contacts.size(); ++i) {
    const auto &x = s.contacts[i], &y = t.contacts[i];
    same(x.pressing, y.pressing), same(x.load, y.load), same(x.slip, y.slip);
    same(x.friction_work, y.friction_work), same(x.touching, y.touching), same(x.contacts, y.contacts);
  }
  for (std::size_t i = 0; i < s.inertial.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      same(s.inertial[i].specific_force[k], t.inertial[i].specific_force[k]);
      same(s.inertial[i].angular_velocity[k], t.inertial[i].angular_velocity[k]);
    }
  }
  same(a.positive_work(), b.positive_work()), same(a.absolute_work(), b.absolute_work());
  same(a.time(), b.time()), same(a.mass(), b.mass());
  differ += s.trouble.what != t.trouble.what || s.trouble.body != t.trouble.body;
  same(s.trouble.value, t.trouble.value);
  return differ;
}

// More balls under it than a world alone keeps contacts.
struct bed_of_balls : compiled_test::sledge {
  using shape = decltype(cca::robots::on_base(cca::robots::sphere(compiled_test::radius), cca::at(0, 0, 0)));
  static constexpr std::array shapes = [] {
    std::array<shape, 45> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto k = static_cast<double>(i);
      all[i] = cca::robots::on_base(cca::robots::sphere(compiled_test::radius),
                                    cca::at(0.05 * static_cast<double>(i % 9) - 0.2,
                                            0.05 * static_cast<double>(i / 9) - 0.1, -0.05 - 1e-5 * k));
    }
    return all;
  }();
};

struct pair {
  alone one;
  beside other;
  explicit pair(std::size_t which) : one(begun<alone>(which)), other(begun<beside>(which)) {}
};

int differences_of(std::size_t count, int beats) {
  std::vector<pair> all;
  for (std::size_t i = 0; i < count; ++i) all.emplace_back(i);
  std::vector<beside*> worlds;
  for (pair& p : all) worlds.push_back(&p.other);
  int differ = 0;
  for (int beat = 0; beat < beats; ++beat) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto laws = laws_of(i, beat);
      disturb(all[i].one, i, beat), disturb(all[i].other, i, beat);
      all[i].one.advance(laws), all[i].other.advance(laws);
    }
    sim::advance_together(worlds);
    for (const pair& p : all) differ += differences(p.one, p.other);
  }
  double slips = 0;
  for (const pair& p : all) slips += p.one.foot(0).slip;
  CHECK_GT(slips, 0);
  return differ;
}

}  // namespace

TEST_SUITE("compiled world: side by side") {
  TEST_CASE("each has the bits that it has alone") {
    for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 11u}) CHECK_EQ(differences_of(count, 400), 0);
  }
  TEST_CASE("a world that can't be right any more is as it was, and the others go on") {
    for (std::size_t bad = 0; bad < 3; ++bad) {
      std::vector<pair> all;
      for (std::size_t i = 0; i < 3; ++i) all.emplace_back(i);
      std::vector<beside*> worlds;
      for (pair& p : all) worlds.push_back(&p.other);
      for (int beat = 0; beat < 60; ++beat) {
        for (std::size_t i = 0; i < 3; ++i) {
          if (beat == 30 && i == bad) { all[i].one.push({0, 0, 1e12}), all[i].other.push({0, 0, 1e12}); }
          all[i].one.advance(laws_of(i, beat)), all[i].other.advance(laws_of(i, beat));
        }
        sim::advance_together(worlds);
        for (const pair& p : all) CHECK_EQ(differences(p.one, p.other), 0);
      }
      for (std::size_t i = 0; i < 3; ++i) CHECK_EQ(bool(all[i].other.trouble()), i == bad);
      CHECK_EQ(all[bad].other.trouble_text(), all[bad].one.trouble_text());
      CHECK(!all[bad].other.waits());
    }
  }
  TEST_CASE("worlds that can't be lanes of one vector advance one by one") {
    sim::robot_world_settings fine;
    fine.steps_per_beat = 4;
    const auto world = [&](int which) {
      sim::robot_world_settings s = which == 1 ? fine : sim::robot_world_settings{};
      return beside(sim::terrain::flat(), sim::standing_posture(), s);
    };
    std::vector<beside> all{world(0), world(1), world(2)};
    std::array<sim::drive_condition, 16> dead;
    dead[1].strength = 0;
    all[2].set_condition(dead);
    std::vector<alone> one(all.begin(), all.end());
    std::vector<beside*> worlds{&all[0], &all[1], &all[2]};
    for (int beat = 0; beat < 50; ++beat) {
      for (std::size_t i = 0; i < 3; ++i) one[i].advance(laws_of(0, beat)), all[i].advance(laws_of(0, beat));
      sim::advance_together(worlds);
    }
    for (std::size_t i = 0; i < 3; ++i) CHECK_EQ(differences(one[i], all[i]), 0);
    CHECK_NE(one[0].joints()[1].angle, one[2].joints()[1].angle);
  }
  TEST_CASE("one with more contacts than a world alone has room for has the bits that it has alone") {
    using one = sim::compiled_world<bed_of_balls>;
    sim::scene level;
    level.floor = 0;
    std::vector<one> plain(4, one(level));
    std::vector<sim::side_by_side<one>> all(4, sim::side_by_side<one>(level));
    std::vector<sim::side_by_side<one>*> worlds;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const std::array<double, 3> turns{i % 2 == 0 ? 0.0 : 3.0, 0.1 * static_cast<double>(i), 0.2};
      plain[i].place({}, {}, cca::at(0, 0, 0.055), turns, {0.3, 0, 0});
      all[i].place({}, {}, cca::at(0, 0, 0.055), turns, {0.3, 0, 0});
      worlds.push_back(&all[i]);
    }
    std::size_t most = 0, differ = 0, crowded = 0;
    for (int beat = 0; beat < 200; ++beat) {
      for (std::size_t i = 0; i < plain.size(); ++i) plain[i].advance({}), all[i].advance({});
      sim::advance_together(worlds);
      for (std::size_t i = 0; i < plain.size(); ++i) {
        const auto &a = plain[i].save(), &b = all[i].save();
        sim::detail::each_number_of_motion(a.motion, b.motion, [&](double x, double y) { differ += x != y; });
        most = std::max(most, a.impulses.count), crowded += a.impulses.count == 32;
      }
    }
    CHECK_EQ(differ, 0);
    CHECK_EQ(most, 32);
    CHECK_LT(crowded, 780);  // in some beats a world has fewer
  }
  TEST_CASE("a world that gets a state back does not wait") {
    beside a, b;
    a.advance(laws_of(0, 0));
    a.restore(b.save());
    CHECK(!a.waits());
    CHECK_EQ(differences(a, b), 0);
  }
  TEST_CASE("one that has no laws does not advance") {
    beside a, b;
    std::vector<beside*> worlds{&a, &b};
    a.advance(laws_of(0, 0));
    CHECK(a.waits());
    CHECK_EQ(a.time(), 0);
    sim::advance_together(worlds);
    CHECK(!a.waits());
    CHECK_EQ(a.time(), 0.001);
    CHECK_EQ(b.time(), 0);
  }
}
