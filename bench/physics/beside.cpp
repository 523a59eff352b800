// The same trot in three engines in one run: ns for a step of 0.5 ms on one core.
//
//   physics_beside check    whether the model of MuJoCo is that of the description: mass, mass matrix, standing height, load
//   physics_beside time     the compiled world, the Open Dynamics Engine, and MuJoCo with each solver
//   physics_beside mjcf     the model as MuJoCo's XML
//
// MuJoCo is there if BENCH_MUJOCO is defined.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <random>
#include <string_view>

#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

#include "commands_of_trot.hpp"
#include "figures.hpp"
#include "mujoco_world.hpp"

namespace bench {

namespace sim = cca::sim;

sim::scene level() {
  sim::scene s;
  s.floor = 0;
  return s;
}

#ifdef BENCH_MUJOCO
// Its mass matrix over the 22 variables of the library: followers follow.
double error_of_mass_matrix() {
  mujoco_world w("Newton", "pyramidal");
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  double worst = 0;
  for (int round = 0; round < 20; ++round) {
    std::array<double, 16> q;
    for (double& x : q) x = any(random);
    w.place(q, 1);
    const int n = w.m->nv;
    std::vector<double> full(static_cast<std::size_t>(n * n));
    mj_fullM(w.m, full.data(), w.d->qM);
    const auto own = Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(full.data(), n, n);
    Eigen::MatrixXd way = Eigen::MatrixXd::Zero(n, 22);
    way.block<3, 3>(0, 3).setIdentity(), way.block<3, 3>(3, 0).setIdentity();
    for (int i = 0; i < static_cast<int>(w.links.size()); ++i) {
      const auto& l = w.links[static_cast<std::size_t>(i)];
      way(w.m->jnt_dofadr[w.joint_of(i)], 6 + l.coordinate) = l.ratio;
    }
    using pose = cca::body_pose<walking::body>;
    const Eigen::MatrixXd wanted = cca::floating_mass_matrix(pose(pose::vector_type::Map(q.data())));
    worst = std::max(worst, (way.transpose() * own * way - wanted).norm() / wanted.norm());
  }
  return worst;
}
#endif

void check() {
#ifdef BENCH_MUJOCO
  sim::compiled_world<walking> c(level());
  mujoco_world w("Newton", "pyramidal");
  double mass = 0;
  for (int i = 0; i < w.m->nbody; ++i) mass += w.m->body_mass[i];
  figure("mujoco mass", mass / c.mass() - 1);
  figure("mujoco mass matrix", error_of_mass_matrix());
  const recorded_trot t = trot_of(0.01);
  put_down(c, t), w.place(t.start, t.height);
  for (int k = 0; k < 5000; ++k) c.advance(t.beats[0]), w.advance(t.beats[0]);
  figure("mujoco height", w.height() - c.frame(-1).where.at[2]);
  figure("mujoco load", w.load() / (c.mass() * 9.81) - 1);
#else
  std::printf("MuJoCo is not installed (Debian: libmujoco-dev), so nothing is compared with it\n");
#endif
}

// ns of a step: the least of five runs of the beats from the second second on, when it trots.
template <class World, class Begin>
double run(World& w, const recorded_trot& t, Begin begin) {
  constexpr std::size_t from = 1500;
  begin(w);
  for (std::size_t k = 0; k < from; ++k) w.advance(t.beats[k]);
  const std::clock_t start = std::clock();
  for (std::size_t k = from; k < t.beats.size(); ++k) w.advance(t.beats[k]);
  return 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC /
         static_cast<double>(2 * (t.beats.size() - from));
}

void time() {
  const recorded_trot t = trot_of(3);
  double compiled = 1e9, ode = 1e9;
  const auto down = [&](auto& w) { put_down(w, t); };
  sim::compiled_world<walking> c(level());
  sim::robot_world e(sim::model_of<walking>(), level());
#ifdef BENCH_MUJOCO
  constexpr std::array<std::array<const char*, 2>, 5> ways{{{"Newton", "pyramidal"},
                                                            {"Newton", "elliptic"},
                                                            {"CG", "pyramidal"},
                                                            {"CG", "elliptic"},
                                                            {"PGS", "pyramidal"}}};
  std::array<double, ways.size()> mujoco;
  mujoco.fill(1e9);
#endif
  for (int round = 0; round < 5; ++round) {
    compiled = std::min(compiled, run(c, t, down));
    ode = std::min(ode, run(e, t, down));
#ifdef BENCH_MUJOCO
    for (std::size_t k = 0; k < ways.size(); ++k) {
      mujoco_world w(ways[k][0], ways[k][1]);
      mujoco[k] = std::min(mujoco[k], run(w, t, [&](auto& x) { x.place(t.start, t.height); }));
      if (round == 0)
        std::fprintf(stderr, "MuJoCo, %s %s: after %zu beats at %.3f m, %.3f m high\n", ways[k][0],
                     ways[k][1], t.beats.size(), w.forward(), w.height());
    }
#endif
  }
  std::fprintf(stderr, "compiled at %.3f m, engine at %.3f m\n", c.frame(-1).where.at[0],
               e.frame(-1).where.at[0]);
  figure("compiled ns", compiled), figure("ode ns", ode);
#ifdef BENCH_MUJOCO
  for (std::size_t k = 0; k < ways.size(); ++k)
    figure((std::string("mujoco ") + ways[k][0] + " " + ways[k][1] + " ns").c_str(), mujoco[k]);
#else
  std::printf("MuJoCo is not installed (Debian: libmujoco-dev), so it is not timed\n");
#endif
}

}  // namespace bench

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "check") bench::check();
  else if (what == "time") bench::time();
  else if (what == "mjcf") std::puts(bench::mjcf<bench::walking>(0.0005, "Newton", "pyramidal").text.c_str());
  else return std::fprintf(stderr, "usage: physics_beside check | time | mjcf\n"), 2;
}
