// Judges the learned gait on all cores: for each commanded speed and turn many disturbances, how often it
// walks as commanded, how far its feet slip and how much work it does. The trot that it learned from is
// judged in the same way (--gait trot). It ends with 0 only if every run walks (worth.hpp).
//
//   walking_policy_seeds --weights walk.policy --summary seeds.json       all speeds and turns
//   walking_policy_seeds --weights walk.policy --speed 0.4 --turn 0.3
//
// The training has used the disturbances from 1,000,000 up (trial.hpp). These are others.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
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
#include "../trot/own_run.hpp"
#include "teaching.hpp"
#include "trial.hpp"
#include "worth.hpp"

namespace {

// Without uncertainty these are the bits of the robot that is as described.
template <class World>
struct by_policy : walking::architecture<walking::uncertain_oncilla<World>> {};
template <class World>
struct by_trot : walking::school<walking::uncertain_oncilla<World>> {};

constexpr std::array all_speeds{0.2, 0.3, 0.4, 0.5, 0.6};  // m/s
constexpr std::array all_turns{0.0, 0.3, -0.3};            // rad/s
enum class gait : std::uint8_t { policy, trot };
constexpr std::array<std::string_view, 2> gait_names{"policy", "trot"};

struct options {
  std::string weights = "walk.policy", config, summary;
  std::uint64_t first = 1000, count = 20;
  double seconds = 20;
  std::optional<double> speed, turn;
  bool uncertain = false;
  gait driver = gait::policy;
  cca::sim::terrain ground = cca::sim::terrain::flat();
  trot::engine engine = trot::engine::ode;

  void offer(cca::command_line& line) {
    line.text("--weights FILE", weights, "of the policy (walk.policy)");
    line.text("--config FILE", config, "parameters (the defaults in the code)");
    line.whole_number("--first N", first, 0, "the first seed (1000)");
    line.whole_number("--count N", count, 1, "how many, for each command (20)");
    line.number("--seconds S", seconds, 3, 3600, "of each, simulated (20)");
    line.number("--speed V", speed, 0.1, 1, "m/s (0.2, 0.3, 0.4, 0.5 and 0.6)");
    line.number("--turn W", turn, -1, 1, "rad/s to the left (0, 0.3 and -0.3; with --speed 0)");
    line.flag("--uncertain", uncertain, "robots and grounds as uncertain as in the training");
    line.one_of("--gait G", driver, gait_names, "policy, or the trot that taught it (policy)");
    trot::offer_terrain(line, ground);
    trot::offer_engine(line, engine);
    line.text("--summary FILE", summary, "the figures of all commands and of each run, as one JSON object");
    cca::offer_descriptions<walking::controller>(line, [this](walking::controller& c) {
      walking::name_weights(c, weights);
      if (!config.empty()) cca::read_parameters(c, config);
    });
  }

  std::vector<walking::command> commands() const {
    std::vector<walking::command> all;
    for (const double w : all_turns)
      for (const double v : all_speeds) all.push_back({speed.value_or(v), turn.value_or(speed ? 0 : w)});
    const auto same = [](const walking::command& a, const walking::command& b) {
      return a.speed == b.speed && a.turn == b.turn;
    };
    std::vector<walking::command> once;
    for (const auto& c : all)
      if (std::none_of(once.begin(), once.end(), [&](const auto& o) { return same(o, c); }))
        once.push_back(c);
    return once;
  }
};

struct run_of_seed {
  std::uint64_t seed;
  walking::figures figures;
};

struct range {
  double mean = 0, least = 0, most = 0;
};
template <class Figure>
range over(const std::vector<run_of_seed>& runs, Figure figure) {
  range r{0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto& run : runs) {
    const double x = figure(run.figures);
    r.mean += x / static_cast<double>(runs.size());
    r.least = std::min(r.least, x), r.most = std::max(r.most, x);
  }
  return r;
}

template <class Architecture, gait Driver>
int judge(const options& o) {
  std::vector<std::string> limited;     // in the first run
  const cca::interruption interrupted;  // ctrl-c: the figures are of the runs that are over
  cca::controller<Architecture> start;
  walking::name_weights(start, o.weights);
  if constexpr (Driver == gait::trot) start.template get<"driver">().by_teacher = true;
  if (o.config.empty()) start.load();
  else start.load(o.config);

  const std::vector<walking::command> commands = o.commands();
  const auto all =
      trot::finished_runs("walking_policy_seeds", commands.size() * o.count, interrupted, [&](std::size_t i) {
        walking::trial t{.number = o.first + i % o.count, .wanted = commands[i / o.count]};
        if (o.uncertain) t.uncertain = walking::drawn_trial(t.number).uncertain;
        using controller = cca::controller<Architecture>;
        return trot::run_of(
            start,
            [&, t](controller& c) {
              return walking::attempt(c, t, o.seconds, [&interrupted] { return !interrupted; }, o.ground);
            },
            [&, i, t](const trot::recording& run, const controller& c) {
              if (i == 0) limited = cca::summaries_of(c);
              return run_of_seed{t.number, walking::along_its_way(run)};
            });
      });

  std::size_t falls = 0, walked = 0;
  trot::json list = trot::json::array();
  for (std::size_t at = 0; at < all.size(); at += o.count) {
    const walking::command& wanted = commands[at / o.count];
    const std::vector<run_of_seed> runs(
        all.begin() + static_cast<std::ptrdiff_t>(at),
        all.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(at + o.count, all.size())));
    std::size_t fell_here = 0, walked_here = 0;
    trot::json each = trot::json::array();
    for (const auto& [seed, f] : runs) {
      const bool good = walking::walks(f, wanted);
      fell_here += f.fell, walked_here += good;
      if (!good || commands.size() == 1)
        std::printf(
            "  %.2f m/s %+.2f rad/s, seed %llu: %.3f m/s %+.3f rad/s, drift %+.2f m in %.2f m, roll %.1f "
            "pitch %.1f deg, slip %.3f m/s, transport %.2f%s%s\n",
            wanted.speed, wanted.turn, static_cast<unsigned long long>(seed), f.cruise, f.turn, f.drift,
            f.way, f.max_roll * 57.2958, f.max_pitch * 57.2958, f.slip, f.transport, f.fell ? ", FELL" : "",
            good ? "" : ", beyond the bounds");
      each.push_back({{"seed", seed},
                      {"fell", f.fell},
                      {"seconds", f.seconds},
                      {"way_m", f.way},
                      {"speed_m_s", f.cruise},
                      {"turn_rad_s", f.turn},
                      {"drift_m", f.drift},
                      {"foot_slip_m_s", f.slip},
                      {"cost_of_transport", f.transport},
                      {"within_bounds", good}});
    }
    const range speed = over(runs, [](const auto& f) { return f.cruise; }),
                turn = over(runs, [](const auto& f) { return f.turn; }),
                slip = over(runs, [](const auto& f) { return f.slip; }),
                transport = over(runs, [](const auto& f) { return f.transport; });
    std::printf(
        "%zu of %zu walk at %.2f m/s, %+.2f rad/s: %zu fell; %.3f m/s (%.3f to %.3f); %+.3f rad/s (%+.3f "
        "to %+.3f); slip %.3f m/s (%.3f at most); cost of transport %.2f\n",
        walked_here, runs.size(), wanted.speed, wanted.turn, fell_here, speed.mean, speed.least, speed.most,
        turn.mean, turn.least, turn.most, slip.mean, slip.most, transport.mean);
    falls += fell_here, walked += walked_here;
    list.push_back({{"commanded_speed_m_s", wanted.speed},
                    {"commanded_turn_rad_s", wanted.turn},
                    {"seeds", runs.size()},
                    {"walked", walked_here},
                    {"falls", fell_here},
                    {"mean_speed_m_s", speed.mean},
                    {"least_speed_m_s", speed.least},
                    {"greatest_speed_m_s", speed.most},
                    {"mean_turn_rad_s", turn.mean},
                    {"mean_foot_slip_m_s", slip.mean},
                    {"greatest_foot_slip_m_s", slip.most},
                    {"mean_cost_of_transport", transport.mean},
                    {"runs", each}});
  }
  std::printf("%s, %s: %zu of %zu runs walk as commanded, %.0f s each, %s%s: %zu fell\n",
              std::string(gait_names[static_cast<std::size_t>(Driver)]).c_str(),
              trot::name_of(o.engine).c_str(), walked, all.size(), o.seconds, o.ground.name().c_str(),
              o.uncertain ? ", uncertain" : "", falls);
  for (const std::string& line : limited) std::printf("first run: %s\n", line.c_str());
  if (!o.summary.empty())
    trot::write(o.summary, [&](std::ostream& file) {
      trot::write(file, trot::json{{"gait", gait_names[static_cast<std::size_t>(Driver)]},
                                   {"engine", trot::name_of(o.engine)},
                                   {"terrain", o.ground.name()},
                                   {"uncertain", o.uncertain},
                                   {"runs", all.size()},
                                   {"walked", walked},
                                   {"falls", falls},
                                   {"commands", list}});
    });
  if (interrupted) return interrupted.exit_code();
  return walked == all.size() ? 0 : 1;
}

template <class World>
int judge_in(const options& o) {
  return o.driver == gait::policy ? judge<by_policy<World>, gait::policy>(o)
                                  : judge<by_trot<World>, gait::trot>(o);
}

}  // namespace

int main(int count, char** words) {
  options o;
  cca::command_line line(
      "the learned gait at many speeds, turns and disturbances that were not used in training, on all cores");
  o.offer(line);
  return cca::run_program(count, words, line, [&] {
    if (o.first + o.count > walking::first_of_training)
      throw cca::command_line_error("the seeds from " + std::to_string(walking::first_of_training) +
                                    " on are those of the training: take lower ones");
    return o.engine == trot::engine::compiled ? judge_in<trot::beside<cca::sim::compiled_oncilla_world>>(o)
                                              : judge_in<cca::sim::world>(o);
  });
}
