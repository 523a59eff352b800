// How many steps of a policy at 50 Hz a second of one core makes: the trot of the Oncilla with its motor
// laws, 20 beats a step, as worlds of Python make them (cca/python/worlds.hpp); the same laws in MuJoCo; and
// the physics alone, in lanes of different phases of the trot if BENCH_LANES is defined, with everything else
// left out.
//
//   physics_worlds
//
// All in one run, processor time, the best of five rounds.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/python/score.hpp>
#include <cca/python/stand_in.hpp>
#include <cca/python/task.hpp>
#include <cca/python/worlds.hpp>
#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/compiled/lanes/lanes.hpp>
#include <cca/sim/compiled/robot.hpp>

#include "commands_of_trot.hpp"
#include "figures.hpp"
#include "mujoco_world.hpp"

namespace bench {

namespace sim = cca::sim;
namespace python = cca::python;
namespace oncilla = cca::robots::oncilla;

struct slow_angles : cca::space<cca::joint_angles, oncilla::leg_axes, cca::rate<50>> {};
using inputs = cca::policy_inputs<cca::in<"orientation", oncilla::trunk_orientation>,
                                  cca::in<"rates", oncilla::trunk_angular_velocity>,
                                  cca::in<"angles", oncilla::leg_angles>,
                                  cca::in<"velocities", oncilla::leg_velocities>>;
struct steady {
  auto process(cca::in<"angles", oncilla::leg_angles>) -> cca::out<"reward", python::reward> { return 1.0; }
};
struct in_python
    : cca::graph<cca::node<"policy", python::stand_in_of<inputs, slow_angles>, cca::timed<20>>,
                 cca::node<"smooth", cca::interpolate<slow_angles, oncilla::leg_angles>, cca::timed<1>>,
                 cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                 cca::node<"robot", sim::robot<walking, sim::compiled>>,
                 cca::node<"judge", steady>,
                 cca::node<"score", python::score>,
                 cca::wire<"robot.orientation", "policy.orientation", cca::latest>,
                 cca::wire<"robot.angular_velocity", "policy.rates", cca::latest>,
                 cca::wire<"robot.angles", "policy.angles", cca::latest>,
                 cca::wire<"robot.velocities", "policy.velocities", cca::latest>,
                 cca::wire<"policy.output", "smooth.input", cca::latest>,
                 cca::wire<"smooth.output", "limits.command">,
                 cca::wire<"robot.angles", "limits.measured">,
                 cca::wire<"limits.safe", "robot.command">,
                 cca::wire<"robot.angles", "judge.angles">,
                 cca::wire<"judge.reward", "score.reward">> {};

const recorded_trot& recorded() {
  static const recorded_trot t = trot_of(3);
  return t;
}
sim::scene level() {
  sim::scene s;
  s.floor = 0;
  return s;
}
template <int Steps>
struct trotting : python::task<in_python> {
  static void begin(controller& c, std::uint64_t) {
    sim::robot_world_settings s;
    s.steps_per_beat = Steps;
    sim::compiled_world<walking> w(level(), s);
    put_down(w, recorded());
    c.get<"robot.simulator">().put_down(std::move(w));
  }
};

constexpr std::size_t beats = 20, first = 1500 / beats, last = 3000 / beats;

// Policy steps a second of f(step), from the second second on.
template <class F>
double a_second(std::size_t worlds, F f) {
  for (std::size_t k = 0; k < first; ++k) f(k);
  const std::clock_t start = std::clock();
  for (std::size_t k = first; k < last; ++k) f(k);
  return static_cast<double>(worlds * (last - first)) * CLOCKS_PER_SEC /
         static_cast<double>(std::clock() - start);
}

template <int Steps>
double in_worlds() {
  constexpr std::size_t count = 16;
  python::worlds<trotting<Steps>> all(count, {.threads = 1});
  all.reset({});
  std::vector<double> actions(count * 8);
  const double found = a_second(count, [&](std::size_t k) {
    const laws_of_oncilla& laws = recorded().beats[beats * k];
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t leg = 0; leg < 4; ++leg) {
        actions[8 * i + leg] = laws[4 * leg + 1].position;
        actions[8 * i + 4 + leg] = laws[4 * leg + 2].position;
      }
    all.step(actions);
    for (const auto ended : all.now().ended)
      if (ended) std::fprintf(stderr, "a robot in Python has stopped\n"), std::exit(1);
  });
  return found;
}

// `all`: the laws of each beat.
template <class World>
double of_physics(World& w, std::size_t count, const auto& all) {
  return a_second(count, [&](std::size_t k) {
    for (std::size_t b = 0; b < beats; ++b) w.advance(all[beats * k + b]);
  });
}
template <class Real>
double physics_alone(int steps, std::size_t count) {
  sim::robot_world_settings s;
  s.steps_per_beat = steps;
  const auto w = std::make_unique<sim::compiled_world<walking, Real>>(level(), s);
  std::array<Real, 16> q;
  for (std::size_t c = 0; c < 16; ++c) q[c] = Real(recorded().start[c]);
  w->place(q, {}, cca::at(0, 0, recorded().height), {}, {});
  std::vector<std::vector<sim::joint_law>> all(beats * last);  // each lane is behind the one before it
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t l = 0; l < count; ++l) {
      const laws_of_oncilla& own = recorded().beats[k > 31 * l ? k - 31 * l : 0];
      all[k].insert(all[k].end(), own.begin(), own.end());
    }
  return of_physics(*w, count, all);
}

}  // namespace bench

int main() {
  using namespace bench;
  const auto best = [](const char* name, auto f) {
    double most = 0;
    for (int round = 0; round < 5; ++round) most = std::max(most, f());
    figure(name, most);
  };
  best("worlds, steps of 0.5 ms", [] { return in_worlds<2>(); });
  best("worlds, steps of 1 ms", [] { return in_worlds<1>(); });
  best("physics, steps of 0.5 ms", [] { return physics_alone<double>(2, 1); });
  best("physics, steps of 1 ms", [] { return physics_alone<double>(1, 1); });
#ifdef BENCH_LANES
  best("lanes, steps of 0.5 ms", [] { return physics_alone<sim::lanes<BENCH_LANES>>(2, BENCH_LANES); });
  best("lanes, steps of 1 ms", [] { return physics_alone<sim::lanes<BENCH_LANES>>(1, BENCH_LANES); });
#endif
#ifdef BENCH_MUJOCO
  for (const int steps : {2, 1})
    for (const auto& [solver, cone] :
         {std::pair{"Newton", "pyramidal"}, std::pair{"CG", "pyramidal"}, std::pair{"PGS", "pyramidal"}})
      best((std::string("mujoco ") + solver + (steps == 2 ? ", steps of 0.5 ms" : ", steps of 1 ms")).c_str(),
           [&] {
             mujoco_world w(solver, cone, steps);
             w.place(recorded().start, recorded().height);
             return of_physics(w, 1, recorded().beats);
           });
#endif
}
