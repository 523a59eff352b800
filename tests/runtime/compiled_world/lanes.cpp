// Worlds side by side in the lanes of a vector: each ends with the bits of a world alone.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include <cca/sim/compiled/lanes/lanes.hpp>

#include "robots.hpp"

using namespace compiled_test;

namespace {

using walking = robots::oncilla::description;
constexpr int width = 2;

sim::scene flat() {
  sim::scene s;
  s.floor = 0;
  return s;
}
sim::scene bumpy() {
  sim::scene s;
  s.ground = sim::terrain::steps(0.006);
  return s;
}
// Of lane `l`: each treads in its own way and begins in its own posture.
std::array<sim::joint_law, 16> treading(int l, int beat) {
  std::array<sim::joint_law, 16> laws;
  for (std::size_t c = 0; c < 16; ++c) {
    const auto& d = walking::drives[c];
    const double side = c / 4 % 3 == 0 ? 1 : -1, phase = 0.025 * beat + 0.7 * l;
    const double swing = c % 4 == 1   ? (0.25 + 0.05 * l) * side * std::sin(phase)
                         : c % 4 == 2 ? 0.3 * (1 - std::cos(phase))
                                      : 0;
    laws[c] = {
        .position = walking::start[c] + swing, .stiffness = d.position_stiffness(), .damping = d.damping};
  }
  return laws;
}
double first_angle(int l, std::size_t c) { return walking::start[c] + 0.02 * l; }

template <class World, class Set>
void put_down(World& w, Set set) {
  using number = std::remove_cvref_t<decltype(w.joints()[0].angle)>;
  std::array<number, 16> q;
  for (std::size_t c = 0; c < 16; ++c) set(q[c], c);
  w.place(q, {}, cca::at(0, 0, 0.19), {}, {});
}

void same_as_alone(const sim::scene& ground) {
  using several = sim::lanes<width>;
  sim::compiled_world<walking, several> all(ground);
  put_down(all, [](several& x, std::size_t c) {
    for (int l = 0; l < width; ++l) x.set(l, first_angle(l, c));
  });
  std::vector<sim::compiled_world<walking>> alone(width, sim::compiled_world<walking>(ground));
  for (int l = 0; l < width; ++l)
    put_down(alone[static_cast<std::size_t>(l)], [l](double& x, std::size_t c) { x = first_angle(l, c); });
  int differs = 0, touches = 0;
  for (int beat = 0; beat < 800; ++beat) {
    std::vector<sim::joint_law> laws;
    for (int l = 0; l < width; ++l) {
      const auto own = treading(l, beat);
      laws.insert(laws.end(), own.begin(), own.end());
      alone[static_cast<std::size_t>(l)].advance(own);
    }
    all.advance(laws);
    for (int l = 0; l < width; ++l) {
      const auto& w = alone[static_cast<std::size_t>(l)];
      const auto &own = w.save().motion, one = own;
      const auto& of = all.save().motion;
      for (std::size_t c = 0; c < 16; ++c) differs += one.q[c] != of.q[c][l] || one.dq[c] != of.dq[c][l];
      for (std::size_t k = 0; k < 3; ++k) differs += one.at[k] != of.at[k][l];
      for (std::size_t part = 0; part < 4; ++part) {
        differs += w.force_on_end(part)[2] != all.force_on_end(part)[2][l];
        touches += w.force_on_end(part)[2] > 0;
      }
    }
  }
  CHECK(differs == 0);
  CHECK(touches > 500);
  CHECK(touches < 5900);  // feet leave the ground, too
  CHECK(!all.trouble());
  CHECK(all.save().motion.at[0][0] != all.save().motion.at[0][1]);
}

}  // namespace

TEST_SUITE("compiled world: lanes") {
  TEST_CASE("each lane has the bits of a world alone, on a floor") { same_as_alone(flat()); }
  TEST_CASE("each lane has the bits of a world alone, on steps") { same_as_alone(bumpy()); }
  TEST_CASE("laws for one robot are those of all lanes") {
    sim::compiled_world<walking, sim::lanes<width>> w(flat());
    w.advance(treading(0, 7));
    CHECK(w.laws()[1].position[0] == treading(0, 7)[1].position);
    CHECK(w.laws()[1].position[1] == treading(0, 7)[1].position);
  }
  TEST_CASE("worlds in lanes have no boxes and no balls") {
    using several = sim::compiled_world<walking, sim::lanes<width>>;
    sim::scene table, ball;
    table.boxes.push_back({});
    ball.balls.push_back({});
    for (const sim::scene& s : {table, ball})
      CHECK_THROWS_WITH_AS(several{s}, doctest::Contains("no boxes and no balls"), std::invalid_argument);
  }
  TEST_CASE("a group stands still when one of it can't be right any more") {
    sim::compiled_world<walking, sim::lanes<width>> w;
    std::array<sim::lanes<width>, 16> q{}, dq{};
    dq[1].set(1, 1e5);
    w.place(q, dq, cca::at(0, 0, 1), {}, {});
    CHECK(w.trouble());
  }
}
