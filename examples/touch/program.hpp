#pragma once
// The program of touch: many runs, a table, files. The arm's engine is a parameter.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/main/end_of_run.hpp>
#include <cca/runtime/interruption.hpp>

#include "../deployed/observing.hpp"
#include "../trot/report/engine.hpp"
#include "../trot/report/file.hpp"
#include "../trot/report/finished_runs.hpp"
#include "rollout.hpp"
#include "summary.hpp"

namespace touch {

// `Architecture`: that of an arm in a simulator.
template <class Architecture>
struct observable : Architecture, cca::recordable, cca::traceable, cca::shows<arm::body, "robot.angles"> {};

// Of a controller of `observable`.
template <class Controller>
struct options {
  std::uint64_t first = 0, count = 1;
  std::optional<std::string> config, shape, summary, csv;
  deployed::observing files;

  void offer(cca::command_line& line) {
    line.whole_number("--first N", first, 0, "the first seed (0)");
    line.whole_number("--count N", count, 1, "how many (1)");
    line.text("--config FILE", config, "parameters (the defaults in the code)");
    line.text("--shape FILE", shape, "keeps what the first run has learned");
    line.text("--summary FILE", summary, "the figures as JSON: a list of runs");
    trot::offer_engine(line);
    deployed::offer_observing<Controller>(line, files, "of the first run");
    line.text("--csv FILE", csv, "hand, force and step of the first run, every 10 ms");
    cca::offer_descriptions<Controller>(line, [this](Controller& c) {
      if (config) cca::read_parameters(c, *config);
    });
  }
};

template <class Controller>
int run(const options<Controller>& o) {
  Controller start;
  if (o.config) start.load(*o.config);
  else start.load();

  std::string seen;
  std::vector<std::string> limited;     // in the first run
  const cca::interruption interrupted;  // ctrl-c: the table is of the runs that are over
  std::ostringstream moments;           // of the first run
  const std::vector<touch::result> runs =
      trot::finished_runs("touch", o.count, interrupted, [&](std::size_t i) {
        const auto c = std::make_unique<Controller>(start);
        cca::observed_run look(*c, i == 0 ? o.files : deployed::observing(), "touch", true);
        const touch::result r = touch::roll_out(*c, o.first + i, [&](const Controller& now, int step) {
          if (i == 0 && o.csv && now.beat_index() % 10 == 0) touch::write_moment(moments, now, step);
          return !interrupted;
        });
        if (const std::string text = deployed::end(look); !text.empty()) seen = text;  // of one run
        if (i == 0) limited = cca::summaries_of(*c);
        const auto& module = c->template get<"repeat.module">();
        if (i == 0 && o.shape && !interrupted) module.learning.save(*o.shape, module.constants());
        return r;
      });

  touch::write_heading();
  for (const touch::result& r : runs) touch::write_row(r);
  const auto good = std::count_if(runs.begin(), runs.end(), [](const auto& r) { return touch::within(r); });
  std::printf("%d of %d runs are within all bounds\n", static_cast<int>(good), static_cast<int>(runs.size()));
  for (const std::string& line : limited) std::printf("first run: %s\n", line.c_str());
  std::fputs(seen.c_str(), stdout);
  if (o.csv)
    trot::write(*o.csv, [&](std::ostream& file) { file << touch::moment_columns << '\n' << moments.str(); });
  if (o.summary) trot::write(*o.summary, [&](std::ostream& file) { touch::write_json(file, runs); });
  if (interrupted) return interrupted.exit_code();
  return good == static_cast<std::ptrdiff_t>(runs.size()) ? 0 : 1;
}

// `Observable`: an `observable`.
template <class Observable>
int main_of(int count, char** words) {
  options<cca::controller<Observable>> o;
  cca::command_line line("an arm learns a movement by hand, wipes a table by touch, and yields to a push");
  o.offer(line);
  return cca::run_program(count, words, line, [&] { return run(o); });
}

}  // namespace touch
