// Searches parameters for the gait of examples/trot in the simulator, on all cores, and writes the best as a
// TOML file for `trot --config`. Several machines find the same, sooner (docs/cluster.md).
//
//   trot_search --config trot.toml --generations 40 --out found.toml
//   mpirun -n 4 trot_search --config trot.toml --generations 40 --out found.toml
//   trot_search --engine compiled --uncertain --draws 3 --out found.toml
//
// The value of a gait is its speed, less penalties for falling, drifting, rolling, pitching, for feet that
// slip, for feet that stand longer or shorter than commanded, and for a run beyond the bounds of trot_seeds.
// It is tried on flat ground, over steps, up a slope and down, with new disturbances in each generation; the
// worst of them counts as much as their mean. So a gait that is good by luck is not kept. With --uncertain
// each run has a robot and a ground of its own, too (examples/trot/uncertain.hpp). All gaits of a generation
// meet the same. To adapt the trot to another robot, change the robot (robots/oncilla/body.hpp,
// oncilla_model.hpp) and search again.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "cma_es.hpp"
#include "../../examples/trot/report/all_cores.hpp"
#include "../../examples/trot/report/bounds.hpp"
#include "../../examples/trot/report/engine.hpp"
#include "../../examples/trot/report/progress.hpp"
#include "../../examples/trot/report/statistics.hpp"
#include "../../examples/trot/idle_robot.hpp"
#include "../../examples/trot/own_run.hpp"
#include "../../examples/trot/rollout.hpp"
#include "../../examples/trot/uncertain.hpp"

namespace {

struct written_trot : trot::architecture<trot::idle_robot> {};  // its parameters are those of every robot

constexpr int parameter_count = 19;

// The parameters to search, each within a range.
struct searched {
  trot::stride_oscillator::parameters cpg;
  trot::gait::parameters gait;
  trot::posture::parameters posture;

  template <class Field>
  void each(Field field) {
    int i = 0;
    field(i++, cpg.frequency, 1.8, 4.0);
    field(i++, gait.duty, 0.4, 0.7);
    field(i++, gait.front.hip, 0.3, 1.1);
    field(i++, gait.hind.hip, 0.3, 1.1);
    field(i++, gait.front.knee, 1.1, 1.8);
    field(i++, gait.hind.knee, 1.1, 1.8);
    field(i++, gait.front.swing, 0.15, 0.6);
    field(i++, gait.hind.swing, 0.15, 0.6);
    field(i++, gait.front.lift, 0.2, 1.6);
    field(i++, gait.hind.lift, 0.2, 1.6);
    field(i++, gait.give, -0.2, 0.3);
    field(i++, gait.lead, -0.2, 0.15);
    double advance = 0.5 - gait.offsets[2];  // of the hind legs before the diagonal front legs
    field(i++, advance, -0.15, 0.2);
    gait.offsets = {0, 0.5, 0.5 - advance, -advance};
    field(i++, gait.even, 0.0, 1.0);
    field(i++, posture.heading, 0.3, 2.5);
    field(i++, posture.drift, 0.0, 1.5);
    field(i++, posture.upright, 0.4, 1.0);
    field(i++, posture.level, 0.0, 2.0);
    field(i++, posture.damp, 0.0, 0.06);
  }
};

// As points of the unit cube.
Eigen::VectorXd to_point(searched s) {
  Eigen::VectorXd point(parameter_count);
  s.each([&](int i, auto& value, double low, double high) { point[i] = (value - low) / (high - low); });
  return point;
}

searched at_point(searched s, const Eigen::VectorXd& point) {
  s.each([&](int i, auto& value, double low, double high) {
    value = low + (high - low) * std::clamp(point[i], 0.0, 1.0);
  });
  return s;
}

double outside(const Eigen::VectorXd& point) {
  return (point - point.cwiseMax(0.0).cwiseMin(1.0)).squaredNorm();
}

struct trial {
  cca::sim::terrain ground;
  double seconds, fast_enough;  // m/s; more speed adds no value
};

// Less slip than this, and a smaller error of the duty factor, add no value.
constexpr double steady_foot = 0.06, steadiest_foot = 0.10;  // m/s, of all feet and of the worst
constexpr double near_duty = 0.07;
constexpr double cost_of_beyond = 0.5;  // of a run that misses a bound: speed does not make up for it

constexpr std::uint64_t first_of_search = 1000;  // of its seeds; trot_seeds judges with lower ones

double worth(const trot::statistics& s, double duty, const trial& t) {
  if (s.fell) return s.seconds / t.seconds - 4;
  const double worst_slip = *std::max_element(s.slip_of_foot.begin(), s.slip_of_foot.end());
  double off_duty = 0;
  for (const double d : s.duty_factor) off_duty += std::max(0.0, std::abs(d - duty) - near_duty);
  return 3 * std::min(s.cruise, t.fast_enough) - 3 * std::max(0.0, s.foot_slip - steady_foot) -
         3 * std::max(0.0, worst_slip - steadiest_foot) - 1.5 * off_duty -
         0.3 * std::abs(s.drift) / s.seconds - 0.3 * (s.max_roll + s.max_pitch) - 0.05 * s.cost_of_transport -
         (trot::keeps(s, duty) ? 0 : cost_of_beyond);
}

// One run of a gait. `start` is a controller that is loaded and not started. The runs of a generation are
// those of the same robots and grounds, whatever gait they try.
template <class Controller, class Between>
auto run_of(const Controller& start,
            const searched& what,
            const trial& t,
            std::uint64_t seed,
            bool uncertain,
            Between between) {
  const auto begin = [=](Controller& c) {
    c.template set<"cpg">(what.cpg);
    c.template set<"gait">(what.gait);
    c.template set<"posture">(what.posture);
    return trot::on_drawn_ground(
        c, uncertain ? trot::drawn_uncertainty(seed) : cca::sim::uncertainty{},
        cca::sim::disturbance::from_seed(seed, t.seconds), t.ground,
        [&](auto& of, const auto& ground, const auto& disturbance, const auto& settings) {
          return trot::run_in_steps(of, trot::begin(of, ground, disturbance, t.seconds, settings), t.seconds,
                                    between);
        });
  };
  const auto judge = [t, duty = what.gait.duty](const trot::recording& run, const Controller&) {
    return worth(trot::evaluate(run), duty, t);
  };
  return trot::run_of(start, begin, judge);
}

// Of the values of one gait's runs: their mean and the worst count the same.
double worth_of_all(const std::vector<double>& values) {
  double sum = 0, worst = 1e9;
  for (const double value : values) {
    sum += value;
    worst = std::min(worst, value);
  }
  return 0.5 * sum / static_cast<double>(values.size()) + 0.5 * worst;
}

struct options {
  std::string config, out = "found.toml";
  int generations = 40, population = 12, draws = 1;
  double seconds = 7, step = 0.1;
  std::uint64_t seed = 1;
  bool uncertain = false;
  trot::engine engine = trot::engine::ode;
};

void offer(cca::command_line& line, options& o) {
  line.text("--config FILE", o.config, "parameters to begin with (the defaults in the code)");
  line.text("--out FILE", o.out, "the best parameters, for trot --config (found.toml)");
  line.number("--generations N", o.generations, 1, 1e5, "how long to search (40)");
  line.number("--population N", o.population, 4, 1e4, "gaits per generation (12)");
  line.number("--draws N", o.draws, 1, 1000, "runs of each gait on each ground (1)");
  line.number("--step X", o.step, 1e-3, 1, "how far it looks at first, as a share of the ranges (0.1)");
  line.flag("--uncertain", o.uncertain, "robots and grounds differ from their description, in each run");
  line.number("--seconds S", o.seconds, 3, 1000, "of each run, simulated (7)");
  line.whole_number("--seed N", o.seed, 0, "of the search (1)");
  trot::offer_engine(line, o.engine);
  using described = cca::controller<written_trot>;
  cca::offer_descriptions<described>(line, [&o](described& c) {
    if (!o.config.empty()) cca::read_parameters(c, o.config);
  });
}

template <class World>
int search(const options& o, trot::all_cores& cores) {
  const cca::interruption interrupted;  // ctrl-c: the best gait so far is written
  cca::controller<trot::uncertain_trot<trot::beside<World>>> start;
  if (o.config.empty()) start.load();
  else start.load(o.config);
  const searched first{start.template get<"cpg">().p, start.template get<"gait">().p,
                       start.template get<"posture">().p};
  std::vector<trial> trials;
  for (int draw = 0; draw < o.draws; ++draw) {
    trials.push_back({cca::sim::terrain::flat(), o.seconds, 0.72});
    trials.push_back({cca::sim::terrain::steps(0.006, 0.45, 20, 1.0), o.seconds, 0.66});
    trials.push_back({cca::sim::terrain::slope(trot::degrees(6)), o.seconds, 0.66});
    trials.push_back({cca::sim::terrain::slope(trot::degrees(-6)), o.seconds, 0.66});
  }

  // The worths of gaits; gait k meets the robots and grounds of generation draw(k). Runs that follow each
  // other are of one ground. With ctrl-c it returns none.
  const auto worths = [&](const std::vector<searched>& gaits, auto draw, auto over) {
    const auto run = [&](std::size_t i) {
      const std::size_t t = i / gaits.size(), k = i % gaits.size();
      const auto seed = first_of_search + static_cast<std::uint64_t>(draw(k) % 7) * trials.size() + t;
      return run_of(start, gaits[k], trials[t], seed, o.uncertain, [&] { return !interrupted; });
    };
    const std::size_t count = gaits.size() * trials.size();
    const std::vector<double> values =
        cores.rollouts(count, run, {.over = over, .stops = [&] { return bool(interrupted); }});
    std::vector<double> all;
    for (std::size_t k = 0; k < gaits.size() && values.size() == count; ++k) {
      std::vector<double> own;
      for (std::size_t t = 0; t < trials.size(); ++t) own.push_back(values[t * gaits.size() + k]);
      all.push_back(worth_of_all(own));
    }
    return all;
  };

  gait_search::cma_es evolution(to_point(first), o.step, o.population, o.seed);
  searched best = first;
  const std::vector<double> at_first = worths({first}, [](std::size_t) { return 0; }, nullptr);
  bool ends_early = at_first.empty();
  double best_worth = ends_early ? 0 : at_first[0];
  trot::progress_bar bar("search", cores.is_first());
  const double total = o.generations * static_cast<double>(o.population + 1);
  for (int generation = 0; generation < o.generations && !ends_early; ++generation) {
    // The last point is the mean of the generation before: only means become the result.
    std::vector<Eigen::VectorXd> points = evolution.ask();
    points.push_back(evolution.mean());
    std::vector<searched> gaits;
    for (const Eigen::VectorXd& point : points) gaits.push_back(at_point(first, point));
    const auto draw = [&](std::size_t k) {
      return k + 1 == points.size() ? 0 : generation;  // all means meet the same disturbances
    };
    const auto show = [&](std::size_t over) {
      char note[80];
      std::snprintf(note, sizeof note, "generation %d, best %.3f, step %.3f", generation + 1, best_worth,
                    evolution.step());
      const double gaits_over = static_cast<double>(over) / static_cast<double>(trials.size());
      bar.show((generation * static_cast<double>(points.size()) + gaits_over) / total, note);
    };
    std::vector<double> values = worths(gaits, draw, show);
    ends_early = values.empty();  // ctrl-c, here or on another rank
    if (ends_early) break;
    for (std::size_t k = 0; k < values.size(); ++k) values[k] -= outside(points[k]);
    if (values.back() > best_worth) {
      best_worth = values.back();
      best = at_point(first, points.back());
    }
    values.pop_back();
    evolution.tell(values);
  }
  bar.done();
  if (!cores.is_first()) return interrupted.exit_code();

  cca::controller<written_trot> found;
  found.load();
  found.set<"throttle">(start.template get<"throttle">().p);
  found.set<"posture">(best.posture);
  found.set<"cpg">(best.cpg);
  found.set<"gait">(best.gait);
  found.save(o.out);
  std::cout << "worth " << best_worth << "; written to " << o.out << '\n';
  if (ends_early) std::cerr << "trot_search: interrupted; this is the best so far\n";
  return interrupted.exit_code();
}

}  // namespace

int main(int count, char** words) {
  trot::all_cores cores(count, words);
  options o;
  cca::command_line line("searches gait parameters that make the robot fast and steady, on all cores");
  offer(line, o);
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? search<cca::sim::compiled_oncilla_world>(o, cores)
                                              : search<cca::sim::world>(o, cores);
  });
}
