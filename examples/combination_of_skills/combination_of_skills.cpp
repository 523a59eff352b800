// The Oncilla trots, stops, reaches for a ball with a front paw, and trots on. Writes a table, a CSV file and
// a picture; --help lists the options.
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/runtime/interruption.hpp>

#include "../trot/report/csv.hpp"
#include "../trot/report/progress.hpp"
#include "../trot/report/recording.hpp"
#include "../trot/report/svg.hpp"
#include "program.hpp"
#include "rollout.hpp"
#include "summary.hpp"

namespace {

int run(const skills::options& o) {
  skills::combined controller;
  skills::load(controller, o.shape, o.config);

  const cca::interruption interrupted;  // ctrl-c: ends the run, and what it has is written
  trot::progress_bar bar("skills", !o.quiet);
  trot::recording recorded;
  const bool records = o.csv || o.svg;
  const auto result = skills::roll_out(controller, o.run, [&](const skills::combined& c) {
    const auto& world = c.get<"robot.simulator">().world();
    if (records) {
      if (c.beat_index() == 1) recorded.begin(world, 30'000);
      recorded.note(world);
    }
    if (c.beat_index() % 20 != 0) return !interrupted;
    const auto& steps = c.get<"sequencer">().steps;
    char note[64];
    std::snprintf(note, sizeof note, "%5.1f s  %s", world.time(), std::string(steps.name()).c_str());
    bar.show(static_cast<double>(steps.step()) / skills::plan::count, note);
    return !interrupted;
  });
  controller.stop();
  bar.show(1);
  bar.done();

  if (!o.quiet) skills::write_table(std::cout, o.run, result);
  if (o.summary)
    trot::write(*o.summary, [&](std::ostream& file) { skills::write_json(file, {{o.run, result}}); });
  if (o.csv) trot::write(*o.csv, [&](std::ostream& file) { trot::write_csv(file, recorded); });
  if (o.svg)
    trot::write(*o.svg, [&](std::ostream& file) {
      char title[128];
      std::snprintf(title, sizeof title,
                    "Oncilla, combination of skills: ball %.1f mm off, reached in %.1f s",
                    result.reach_error * 1e3, result.reach_time);
      trot::write_svg(file, recorded, title);
    });
  if (interrupted) std::cerr << "combination_of_skills: interrupted; the figures are of what it has run\n";
  return interrupted ? interrupted.exit_code() : skills::succeeded(result) ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  return skills::program("combination_of_skills", count, arguments, run);
}
