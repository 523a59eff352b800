// A run of the trot in steps has the bits of the plain loop, beat by beat: alone and side by side with
// others, however it ends.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "../../../examples/trot/idle_robot.hpp"
#include "../../../examples/trot/own_run.hpp"
#include "../../../examples/trot/rollout.hpp"
#include "../../../examples/trot/uncertain.hpp"

#include <cca/sim/rollouts.hpp>

namespace {

namespace sim = cca::sim;

using alone = cca::controller<trot::uncertain_trot<sim::compiled_oncilla_world>>;
using beside = cca::controller<trot::uncertain_trot<trot::beside<sim::compiled_oncilla_world>>>;

constexpr double for_ever = std::numeric_limits<double>::infinity();

struct circumstances {
  std::uint64_t seed = 1;
  sim::terrain ground = sim::terrain::flat();
  double seconds = 1, aside = 0;  // m/s, of the trunk at first
  double stops_at = for_ever;     // s; `between` ends it there
  double plausible = for_ever;    // m/s; the world is in trouble beyond
  bool is_uncertain = false;
};

// What is to be compared. Each beat tells `between` which part of the run is over.
struct outcome {
  std::vector<double> numbers, parts;
  std::size_t beats = 0;
  bool fell = false, has_trouble = false;
  bool operator==(const outcome&) const = default;
};

outcome outcome_of(const trot::recording& run, std::vector<double> parts, bool has_trouble) {
  outcome o{.numbers = {run.work, run.mass, run.start[0], run.start[1], run.start[2]},
            .parts = std::move(parts),
            .beats = run.moments.size(),
            .fell = run.fell,
            .has_trouble = has_trouble};
  const auto add = [&](const auto& all) { o.numbers.insert(o.numbers.end(), all.begin(), all.end()); };
  for (const trot::moment& m : run.moments) {
    for (const double x : {m.time, m.position[0], m.position[1], m.position[2], m.attitude.roll,
                           m.attitude.pitch, m.attitude.yaw})
      o.numbers.push_back(x);
    add(m.hip), add(m.knee), add(m.hip_command), add(m.knee_command), add(m.foot_force), add(m.contact);
  }
  for (const auto& feet : {run.feet, run.feet_when_settled})
    for (const auto& f : feet) o.numbers.insert(o.numbers.end(), {f.slip, f.friction_work, f.load});
  return o;
}

// Puts the robot down; `rolled(controller, recording, between)` makes the run.
template <class Controller, class Rolled>
auto begun(Controller& c, const circumstances& k, std::vector<double>& parts, Rolled rolled) {
  sim::disturbance d = sim::disturbance::from_seed(k.seed, k.seconds);
  d.trunk_velocity[1] += k.aside;
  return trot::on_drawn_ground(
      c, k.is_uncertain ? trot::drawn_uncertainty(k.seed) : sim::uncertainty{}, d, k.ground,
      [&](auto& of, const auto& ground, const auto& disturbance, auto settings) {
        settings.plausible.speed = std::min(settings.plausible.speed, k.plausible);
        const auto between = [&parts, stop = k.stops_at](const auto& w, double part) {
          parts.push_back(part);
          return w.time() < stop;
        };
        return rolled(of, trot::begin(of, ground, disturbance, k.seconds, settings), between);
      });
}

// The loop as it is without steps: each beat has its physics.
template <class Controller>
outcome plain(const Controller& start, const circumstances& k) {
  Controller c = start;
  const auto& world = c.template get<"robot.simulator">().world();
  std::vector<double> parts;
  const trot::recording run = begun(c, k, parts, [&](auto& of, trot::recording r, auto between) {
    const std::size_t beats = trot::beats_in<Controller>(k.seconds);
    of.start();
    for (std::size_t i = 1; i <= beats && !r.fell && of.step(); ++i) {
      r.note(world);
      if (!between(world, static_cast<double>(i) / static_cast<double>(beats))) break;
    }
    return r;
  });
  return outcome_of(run, parts, bool(world.trouble()));
}

template <class Controller>
outcome walked(const Controller& start, const circumstances& k) {
  Controller c = start;
  std::vector<double> parts;
  const trot::recording run = begun(c, k, parts, [&](auto& of, trot::recording r, auto between) {
    return trot::walked(of, std::move(r), k.seconds, between);
  });
  return outcome_of(run, parts, bool(c.template get<"robot.simulator">().world().trouble()));
}

template <class Controller>
std::vector<outcome> together(const Controller& start,
                              const std::vector<circumstances>& all,
                              unsigned threads) {
  std::vector<std::vector<double>> parts(all.size());
  const auto run = [&](std::size_t i) {
    const auto begin = [&, i](Controller& c) {
      return begun(c, all[i], parts[i], [&](auto& of, trot::recording r, auto between) {
        return trot::run_in_steps(of, std::move(r), all[i].seconds, between);
      });
    };
    const auto judge = [&, i](const trot::recording& r, const Controller& c) {
      return outcome_of(r, parts[i], bool(c.template get<"robot.simulator">().world().trouble()));
    };
    return trot::own_run<Controller, decltype(begin), decltype(judge)>(start, begin, judge);
  };
  return sim::rollouts(all.size(), run, {.threads = threads});
}

std::vector<circumstances> many() {
  const sim::terrain steps = sim::terrain::steps(0.006, 0.45, 20, 1.0);
  return {{.seed = 1},
          {.seed = 2, .seconds = 2, .aside = 3},  // falls
          {.seed = 3, .stops_at = 0.3},
          {.seed = 4, .plausible = 2.5},  // trouble
          {.seed = 5, .ground = steps, .is_uncertain = true},
          {.seed = 6, .seconds = 0},
          {.seed = 7, .ground = sim::terrain::slope(0.1), .seconds = 0.7, .is_uncertain = true},
          {.seed = 8, .aside = 0.2, .stops_at = 0},
          {.seed = 9, .plausible = 2.8},
          {.seed = 10, .seconds = 0.001}};
}

template <class Controller>
Controller loaded() {
  Controller c;
  c.load();
  return c;
}

}  // namespace

TEST_SUITE("compiled world: trot in steps") {
  TEST_CASE("side by side with others, however each ends, a run has the bits of the plain loop") {
    const alone start = loaded<alone>();
    const beside start_beside = loaded<beside>();
    const std::vector<circumstances> all = many();
    std::vector<outcome> expected;
    for (const circumstances& k : all) expected.push_back(plain(start, k));
    for (const outcome& o : expected) MESSAGE(o.beats, " beats, fell ", o.fell, ", trouble ", o.has_trouble);
    CHECK_EQ(expected[0].beats, 1000);
    CHECK(expected[1].fell);
    CHECK_LT(expected[1].beats, 2000);
    CHECK_EQ(expected[2].beats, 300);
    CHECK(expected[3].has_trouble);
    CHECK_GT(expected[3].beats, 10);
    CHECK_EQ(expected[5].beats, 0);
    CHECK_EQ(expected[7].beats, 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
      INFO("run ", i);
      CHECK(walked(start, all[i]) == expected[i]);
      CHECK(walked(start_beside, all[i]) == expected[i]);
    }
    for (const unsigned threads : {1u, 2u}) {
      CHECK(together(start, all, threads) == expected);
      CHECK(together(start_beside, all, threads) == expected);
    }
  }

  TEST_CASE("trouble in the last beat: it is noted, as in the plain loop") {
    const alone start = loaded<alone>();
    circumstances k{.seed = 4, .plausible = 2.5};
    const std::size_t noted = plain(start, k).beats;
    k.seconds = 0.001 * static_cast<double>(noted);
    const outcome expected = plain(start, k);
    CHECK(expected.has_trouble);
    CHECK_EQ(expected.beats, noted);
    CHECK(together(loaded<beside>(), {k, k, k}, 1) == std::vector<outcome>(3, expected));
  }

  TEST_CASE("in the engine a run has the bits of the plain loop, too") {
    const auto start = loaded<cca::controller<trot::uncertain_trot<sim::world>>>();
    std::vector<circumstances> all = many();
    all.resize(5);
    std::vector<outcome> expected;
    for (const circumstances& k : all) expected.push_back(plain(start, k));
    CHECK(expected[1].fell);
    CHECK(expected[3].has_trouble);
    CHECK(together(start, all, 2) == expected);
  }
}
