// The learned gait from many disturbances, on all cores: how often it falls, how fast and how straight it is,
// how far its feet slip. It ends with 0 only if every run walks (worth.hpp).
//
//   walking_policy_seeds --weights walk.policy --summary seeds.json
//
// The training has used the disturbances from 1 up; walking_policy_learn says how many. These are others.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/main/end_of_run.hpp>
#include <cca/runtime/interruption.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../trot/report/command_line.hpp"
#include "../trot/report/engine.hpp"
#include "../trot/report/file.hpp"
#include "../trot/report/finished_runs.hpp"
#include "../trot/report/json.hpp"
#include "../trot/report/statistics.hpp"
#include "rollout.hpp"
#include "worth.hpp"

namespace {

struct compiled_walk : walking::architecture<cca::sim::compiled_oncilla> {};

struct options {
  std::string weights = "walk.policy", config, summary;
  std::uint64_t first = 1000, count = 20;
  double seconds = 20;
  std::optional<double> speed;
  cca::sim::terrain ground = cca::sim::terrain::flat();
  trot::engine engine = trot::engine::ode;

  void offer(cca::command_line& line) {
    line.text("--weights FILE", weights, "of the policy (walk.policy)");
    line.text("--config FILE", config, "parameters (the defaults in the code)");
    line.whole_number("--first N", first, 0, "the first seed (1000)");
    line.whole_number("--count N", count, 1, "how many (20)");
    line.number("--seconds S", seconds, 3, 3600, "of each, simulated (20)");
    line.number("--speed V", speed, 0.1, 1, "m/s (the parameters' speed)");
    trot::offer_terrain(line, ground);
    trot::offer_engine(line, engine);
    line.text("--summary FILE", summary,
              "falls, speed, drift and slip, of all and of each, as one JSON object");
    cca::offer_descriptions<walking::controller>(line, [this](walking::controller& c) {
      walking::name_weights(c, weights);
      if (!config.empty()) cca::read_parameters(c, config);
    });
  }
};

struct run_of_seed {
  std::uint64_t seed;
  trot::statistics figures;
};

template <class Figure>
double mean(const std::vector<run_of_seed>& runs, Figure figure) {
  double sum = 0;
  for (const auto& run : runs) sum += figure(run.figures);
  return runs.empty() ? 0 : sum / static_cast<double>(runs.size());
}
template <class Figure>
double greatest(const std::vector<run_of_seed>& runs, Figure figure) {
  double most = runs.empty() ? 0 : figure(runs[0].figures);
  for (const auto& run : runs) most = std::max(most, figure(run.figures));
  return most;
}

template <class Architecture>
int judge(const options& o) {
  std::vector<std::string> limited;     // in the first run
  const cca::interruption interrupted;  // ctrl-c: the figures are of the runs that are over
  cca::controller<Architecture> start;
  walking::name_weights(start, o.weights);
  if (o.config.empty()) start.load();
  else start.load(o.config);
  if (o.speed) walking::command_speed(start, *o.speed);
  const double commanded = start.template get<"gait.throttle">().p.speed;

  const std::vector<run_of_seed> runs =
      trot::finished_runs("walking_policy_seeds", o.count, interrupted, [&](std::size_t i) {
        auto c = start;
        const auto disturbance = cca::sim::disturbance::from_seed(o.first + i, o.seconds);
        const auto figures = trot::evaluate(
            walking::roll_out(c, o.ground, disturbance, o.seconds, [&] { return !interrupted; }));
        if (i == 0) limited = cca::summaries_of(c);
        return run_of_seed{o.first + i, figures};
      });

  std::size_t falls = 0, walked = 0;
  trot::json list = trot::json::array();
  for (const auto& [seed, s] : runs) {
    const bool good = walking::walks(s, commanded);
    falls += s.fell;
    walked += good;
    std::printf(
        "  seed %4llu  %6.2f m  cruise %.3f m/s  drift %+.3f m  roll %4.1f  pitch %4.1f deg  slip %.3f "
        "m/s  transport %.2f%s%s\n",
        static_cast<unsigned long long>(seed), s.distance, s.cruise, s.drift, s.max_roll * 57.2958,
        s.max_pitch * 57.2958, s.foot_slip, s.cost_of_transport, s.fell ? "  FELL" : "",
        good ? "" : "  beyond the bounds");
    list.push_back({{"seed", seed},
                    {"fell", s.fell},
                    {"seconds", s.seconds},
                    {"distance_m", s.distance},
                    {"speed_m_s", s.speed},
                    {"cruise_speed_m_s", s.cruise},
                    {"drift_m", s.drift},
                    {"foot_slip_m_s", s.foot_slip},
                    {"duty_factors", s.duty_factor},
                    {"cost_of_transport", s.cost_of_transport},
                    {"within_bounds", good}});
  }
  const double speed = mean(runs, [](const auto& s) { return s.speed; }),
               cruise = mean(runs, [](const auto& s) { return s.cruise; }),
               least = -greatest(runs, [](const auto& s) { return -s.cruise; }),
               slip = mean(runs, [](const auto& s) { return s.foot_slip; }),
               most_slip = greatest(runs, [](const auto& s) { return s.foot_slip; }),
               transport = mean(runs, [](const auto& s) { return s.cost_of_transport; }),
               aside = greatest(runs, [](const auto& s) { return std::abs(s.drift) / s.distance; });
  std::printf(
      "%zu of %zu seeds walk, %.0f s each, %s, commanded %.2f m/s: %zu fell; speed %.3f m/s on average; "
      "cruise %.3f, %.3f at least; drift up to %.1f %%; slip %.3f m/s on average, %.3f at most; cost of "
      "transport %.2f\n",
      walked, runs.size(), o.seconds, o.ground.name().c_str(), commanded, falls, speed, cruise, least,
      100 * aside, slip, most_slip, transport);
  for (const std::string& line : limited) std::printf("first run: %s\n", line.c_str());
  if (!o.summary.empty())
    trot::write(o.summary, [&](std::ostream& file) {
      trot::write(file, trot::json{{"seeds", runs.size()},
                                   {"walked", walked},
                                   {"falls", falls},
                                   {"commanded_speed_m_s", commanded},
                                   {"terrain", o.ground.name()},
                                   {"mean_speed_m_s", speed},
                                   {"mean_cruise_speed_m_s", cruise},
                                   {"least_cruise_speed_m_s", least},
                                   {"greatest_drift_share", aside},
                                   {"mean_foot_slip_m_s", slip},
                                   {"greatest_foot_slip_m_s", most_slip},
                                   {"mean_cost_of_transport", transport},
                                   {"runs", list}});
    });
  if (interrupted) return interrupted.exit_code();
  return walked == runs.size() ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  options o;
  cca::command_line line(
      "the learned gait from many disturbances that were not used in training, on all cores");
  o.offer(line);
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? judge<compiled_walk>(o) : judge<walking::simulated>(o);
  });
}
