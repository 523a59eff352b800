// The Combination of Skills from many disturbance seeds, with either paw, for each place of the ball, on all
// cores: how often it falls, how near the paw comes, how long that takes.
//
//   combination_of_skills_runs --shape trot.shape --count 10 --summary summary.json
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
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

#include "../trot/report/engine.hpp"
#include "../trot/report/file.hpp"
#include "../trot/report/finished_runs.hpp"
#include "command_line.hpp"
#include "rollout.hpp"
#include "summary.hpp"

namespace {

struct compiled_skills : skills::architecture<cca::sim::compiled_oncilla> {};

struct options {
  std::string shape = "trot.shape", summary;
  std::optional<std::string> config;
  std::uint64_t first = 0, count = 10;
  skills::circumstances run;
  trot::engine engine = trot::engine::ode;
};

void offer(cca::command_line& line, options& o) {
  skills::offer_shape(line, o.shape);
  line.text("--config FILE", o.config, "parameters (the defaults in the code)");
  line.whole_number("--first N", o.first, 0, "the first seed (0)");
  line.whole_number("--count N", o.count, 1, "how many (10)");
  skills::offer_push(line, o.run);
  skills::offer_seconds(line, o.run, "of trot, before and after (6)");
  trot::offer_engine(line, o.engine);
  line.text("--summary FILE", o.summary, "the figures as JSON: a list of runs");
  cca::offer_descriptions<skills::combined>(line, [&o](skills::combined& c) {
    skills::name_shape(c, o.shape);
    if (o.config) cca::read_parameters(c, *o.config);
  });
}

std::string quoted(std::string_view name) { return std::string("`").append(name).append("`"); }

// Lowest, highest and sum of numbers.
struct seen {
  double low = std::numeric_limits<double>::infinity(), high = 0, sum = 0;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
    sum += x;
  }
};

// A row of a Markdown table, for the runs with this ball and this paw. The figures are of the successful
// runs.
void print(const std::vector<skills::finished_run>& runs, skills::target where, skills::paw_side paw) {
  int count = 0, fell = 0, good = 0;
  seen off, worst, pushed, time, speed;
  for (const auto& [c, r] : runs) {
    if (c.where != where || c.paw != paw) continue;
    ++count;
    fell += r.fell;
    if (!skills::succeeded(r)) continue;
    ++good;
    off.add(r.reach_error * 1e3);
    worst.add(r.worst_error * 1e3);
    pushed.add(r.worst_after_push * 1e3);
    time.add(r.reach_time);
    speed.add(r.speed_after);
  }
  std::printf("| %-8s | %-5s | %2d of %-12d | %5d |",
              quoted(skills::target_names[static_cast<std::size_t>(where)]).c_str(),
              std::string(skills::paw_names[static_cast<std::size_t>(paw)]).c_str(), good, count, fell);
  if (good > 0)
    std::printf(" %.2f, %.2f mm       | %5.2f mm       | %.2f to %.2f s | %.2f to %.2f m/s |\n",
                off.sum / good, worst.high, pushed.high, time.low, time.high, speed.low, speed.high);
  else std::printf("                     |                |                |                  |\n");
}

void print(const std::vector<skills::finished_run>& runs) {
  std::printf(
      "\n| ball     | paw   | within 5 mm in 3 s | falls | off: mean, greatest | after the push | reached in "
      "    | then trots at    |\n"
      "|----------|-------|--------------------|-------|---------------------|----------------|--------------"
      "--|------------------|\n");
  for (std::size_t where = 0; where < skills::target_names.size(); ++where)
    for (std::size_t paw = 0; paw < skills::paw_names.size(); ++paw)
      print(runs, static_cast<skills::target>(where), static_cast<skills::paw_side>(paw));
  for (const auto& [c, r] : runs)
    if (!skills::succeeded(r))
      std::printf("failed: seed %d, %s paw, %s: %s in `%s`, worst error %.2f mm, reached in %.2f s\n",
                  static_cast<int>(c.seed.value_or(0)),
                  std::string(skills::paw_names[static_cast<std::size_t>(c.paw)]).c_str(),
                  std::string(skills::target_names[static_cast<std::size_t>(c.where)]).c_str(),
                  r.fell ? "fell" : "ended",
                  std::string(skills::plan::table[static_cast<std::size_t>(r.last)].name).c_str(),
                  r.worst_error * 1e3, r.reach_time);
  const auto good = std::count_if(
      runs.begin(), runs.end(), [](const skills::finished_run& one) { return skills::succeeded(one.what); });
  std::printf(
      "\n%d of %d runs succeeded: no fall, the ball reached in 3 s, the paw within 5 mm of it, and trotted "
      "on.\n"
      "Off: the distance from paw to ball in the 0.4 s after it was reached. After the push: the largest "
      "distance from then on.\n",
      static_cast<int>(good), static_cast<int>(runs.size()));
}

template <class Architecture>
int run(const options& o) {
  cca::controller<Architecture> start;
  skills::load(start, o.shape, o.config);

  std::vector<skills::circumstances> all;
  for (std::uint64_t seed = o.first; seed < o.first + o.count; ++seed)
    for (std::size_t paw = 0; paw < skills::paw_names.size(); ++paw)
      for (std::size_t where = 0; where < skills::target_names.size(); ++where) {
        skills::circumstances c = o.run;
        c.seed = seed;
        c.paw = static_cast<skills::paw_side>(paw);
        c.where = static_cast<skills::target>(where);
        all.push_back(c);
      }

  std::vector<std::string> limited;     // in the first run
  const cca::interruption interrupted;  // ctrl-c: the table is of the runs that are over
  const std::vector<skills::finished_run> runs =
      trot::finished_runs("combination_of_skills_runs", all.size(), interrupted, [&](std::size_t i) {
        auto controller = start;
        const auto result = skills::roll_out(controller, all[i], [&] { return !interrupted; });
        if (i == 0) limited = cca::summaries_of(controller);
        return skills::finished_run{all[i], result};
      });

  print(runs);
  for (const std::string& line : limited) std::printf("first run: %s\n", line.c_str());
  if (!o.summary.empty()) trot::write(o.summary, [&](std::ostream& file) { skills::write_json(file, runs); });
  if (interrupted) return interrupted.exit_code();
  return std::all_of(runs.begin(), runs.end(),
                     [](const skills::finished_run& one) { return skills::succeeded(one.what); })
             ? 0
             : 1;
}

}  // namespace

int main(int count, char** words) {
  options o;
  cca::command_line line("the Combination of Skills with many seeds, both paws and every target");
  offer(line, o);
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? run<compiled_skills>(o) : run<skills::simulated>(o);
  });
}
