#pragma once
// The program of the Combination of Skills, around the main function for robots (cca/main.hpp). The robot's
// engine is a parameter.
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>

#include <cca/cca.hpp>
#include <cca/main.hpp>

#include "../trot/report/csv.hpp"
#include "../trot/report/engine.hpp"
#include "../trot/report/file.hpp"
#include "../trot/report/progress.hpp"
#include "../trot/report/recording.hpp"
#include "../trot/report/svg.hpp"
#include "../trot/report/watched.hpp"
#include "command_line.hpp"
#include "rollout.hpp"
#include "summary.hpp"

namespace skills {

// `Watched`: `watched` of the architecture of a robot with the questions of asked_by_leg.hpp. `Runs`: what
// --engine calls it.
template <class Watched, trot::engine Runs>
struct program : cca::robot_program<Watched> {
  using controller_type = typename cca::robot_program<Watched>::controller_type;
  using cca::robot_program<Watched>::purpose, cca::robot_program<Watched>::settings;

  program() {
    purpose = "a simulated Oncilla trots, stops, reaches for a ball and trots on";
    settings.speed.reset();  // a fast run
  }

  void options(cca::command_line& line) override {
    o.offer(line, settings);
    trot::offer_engine(line);
    line.text("--csv FILE", csv, "every fifth beat");
    line.text("--svg FILE", svg, "footfalls, path and joint angles");
  }

  void prepare(controller_type& c) override { name_shape(c, o.shape); }

  void loaded(controller_type& c) override {
    if (o.run.seed) settings.notes["seed"] = std::to_string(*o.run.seed);
    settings.notes["engine"] = trot::name_of(Runs);
    run.emplace(o.run);
    simulated_stage<controller_type> stage{c};
    run->begin(stage);
    bar = trot::progress_bar("skills", !settings.quiet);
  }

  bool between(controller_type& c) override {
    simulated_stage<controller_type> stage{c};
    if (csv || svg) record(stage.world(), c.beat_index());
    if (c.beat_index() % 20 == 0) {
      const auto& steps = c.template get<"sequencer">().steps;
      char note[64];
      std::snprintf(note, sizeof note, "%5.1f s  %s", stage.world().time(),
                    std::string(steps.name()).c_str());
      bar.show(static_cast<double>(steps.step()) / plan::count, note);
    }
    return run->note(stage);
  }

  void stop(controller_type& c) override {
    if (c.state() != cca::state::loaded) c.stop();  // else it has waited for its first beat
    bar.show(1);
    bar.done();
  }

  int finish(controller_type&) override {
    const auto result = run->end();
    if (!settings.quiet) write_table(std::cout, o.run, result);
    if (o.summary) trot::write(*o.summary, [&](std::ostream& file) { write_json(file, {{o.run, result}}); });
    if (csv) trot::write(*csv, [&](std::ostream& file) { trot::write_csv(file, recorded); });
    if (svg)
      trot::write(*svg, [&](std::ostream& file) {
        char title[128];
        std::snprintf(title, sizeof title,
                      "Oncilla, combination of skills: ball %.1f mm off, reached in %.1f s",
                      result.reach_error * 1e3, result.reach_time);
        trot::write_svg(file, recorded, title);
      });
    return succeeded(result) ? 0 : 1;
  }

private:
  template <class World>
  void record(const World& world, std::int64_t beat) {
    if (beat == 1) recorded.begin(world, 30'000);
    recorded.note(world);
  }

  skills::options o;
  std::optional<std::string> csv, svg;
  std::optional<noted_run> run;
  trot::progress_bar bar{"skills"};
  trot::recording recorded;
};

}  // namespace skills
