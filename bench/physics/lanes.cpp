// Robots side by side in the lanes of a vector, beside one alone: the trot of the Oncilla, each with commands
// of its own time.
//
//   physics_lanes check         whether each lane has the bits of a world alone (without contraction), after a second,
//                               and of a robot that touches itself, in each beat of two seconds
//   physics_lanes time          ns for the step of a robot, alone and in lanes, in one run
//   physics_lanes run LANES BEATS   for callgrind; LANES 1: a world alone; 0: nothing
//
// Compiled with -DBENCH_LANES=4 -mavx2 or -DBENCH_LANES=8 -mavx512f -mavx512dq -mavx512vl, and
// -ffp-contract=off.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string_view>
#include <vector>

#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/compiled/lanes/lanes.hpp>

#include "../../tests/runtime/compiled_world/hugging.hpp"
#include "commands_of_trot.hpp"
#include "figures.hpp"

namespace bench {

namespace sim = cca::sim;
constexpr int width = BENCH_LANES;
using several = sim::lanes<width>;
using alone = sim::compiled_world<walking>;
using side_by_side = sim::compiled_world<walking, several>;

sim::scene level() {
  sim::scene s;
  s.floor = 0;
  return s;
}
// Robot `l` is behind by so many beats.
constexpr std::size_t behind(int l) { return static_cast<std::size_t>(31 * l); }

std::vector<std::vector<sim::joint_law>> commands_of_all(const recorded_trot& t, std::size_t beats) {
  std::vector<std::vector<sim::joint_law>> all(beats);
  for (std::size_t k = 0; k < beats; ++k)
    for (int l = 0; l < width; ++l) {
      const auto& own = t.beats[k > behind(l) ? k - behind(l) : 0];
      all[k].insert(all[k].end(), own.begin(), own.end());
    }
  return all;
}
std::span<const sim::joint_law> of_lane(const std::vector<sim::joint_law>& all, int l) {
  return std::span(all).subspan(static_cast<std::size_t>(16 * l), 16);
}
void begin(side_by_side& w, const recorded_trot& t) {
  std::array<several, 16> q;
  for (std::size_t c = 0; c < 16; ++c) q[c] = several(t.start[c]);
  w.place(q, {}, cca::at(0, 0, t.height), {}, {});
}

int check() {
  constexpr std::size_t beats = 1000;
  const recorded_trot t = trot_of(1);
  const auto commands = commands_of_all(t, beats);
  const auto w = std::make_unique<side_by_side>(level());
  begin(*w, t);
  for (const auto& all : commands) w->advance(all);
  int differ = 0;
  for (int l = 0; l < width; ++l) {
    alone one(level());
    put_down(one, t);
    for (const auto& all : commands) one.advance(of_lane(all, l));
    const auto& m = one.save().motion;
    const auto& of = w->save().motion;
    for (std::size_t c = 0; c < 16; ++c) differ += m.q[c] != of.q[c][l] || m.dq[c] != of.dq[c][l];
    for (std::size_t k = 0; k < 3; ++k) differ += m.at[k] != of.at[k][l];
  }
  const auto hugs = compiled_test::hugs_beside_alone<width>(level(), 9.81, 2000);
  figure("lanes differ", differ + hugs.differ);
  figure("touch themselves", hugs.touches);
  return differ + hugs.differ > 0 || hugs.stands_still || hugs.touches == 0;
}

constexpr std::size_t first = 1500;  // then it trots

template <class World, class Advance>
double ns_of(World& w, std::size_t beats, Advance advance) {
  for (std::size_t k = 0; k < first; ++k) advance(w, k);
  const std::clock_t start = std::clock();
  for (std::size_t k = first; k < beats; ++k) advance(w, k);
  return 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC /
         static_cast<double>(2 * (beats - first));
}
void time() {
  const recorded_trot t = trot_of(3);
  const std::size_t beats = t.beats.size();
  const auto commands = commands_of_all(t, beats);
  double one = 1e9, all = 1e9;
  for (int round = 0; round < 5; ++round) {
    alone a(level());
    put_down(a, t);
    one = std::min(one, ns_of(a, beats, [&](auto& w, std::size_t k) { w.advance(of_lane(commands[k], 0)); }));
    const auto b = std::make_unique<side_by_side>(level());
    begin(*b, t);
    all = std::min(all, ns_of(*b, beats, [&](auto& w, std::size_t k) { w.advance(commands[k]); }) / width);
  }
  figure("alone ns", one), figure("in lanes ns", all);
}
void run(int lanes, std::size_t beats) {
  const recorded_trot t = trot_of(3);
  const auto commands = commands_of_all(t, t.beats.size());
  if (lanes == 1) {
    alone a(level());
    put_down(a, t);
    for (std::size_t k = 0; k < beats; ++k) a.advance(of_lane(commands[k], 0));
    figure("height", a.frame(-1).where.at[2]);
  } else if (lanes == width) {
    const auto b = std::make_unique<side_by_side>(level());
    begin(*b, t);
    for (std::size_t k = 0; k < beats; ++k) b->advance(commands[k]);
    figure("height", b->save().motion.at[2][0]);
  }
}

}  // namespace bench

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "check") return bench::check();
  if (what == "time") return bench::time(), 0;
  if (what == "run" && argc > 3)
    return bench::run(std::atoi(argv[2]),
                      std::min<std::size_t>(3000, static_cast<std::size_t>(std::atoi(argv[3])))),
           0;
  return std::fprintf(stderr, "usage: physics_lanes check | time | run LANES BEATS\n"), 2;
}
