// The Combination of Skills on drives: the Oncilla trots, stops, reaches for a ball and trots on, over five
// buses in memory. The options are those of combination_of_skills without its CSV file and picture; --help
// lists them.
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>

#include <cca/cca.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/main.hpp>
#include <cca/robots/oncilla/legged_body.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>                // offers --record
#include <cca/record/replay_option.hpp>  // offers --replay
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

#include "../combination_of_skills/command_line.hpp"
#include "../combination_of_skills/summary.hpp"
#include "../trot/report/file.hpp"
#include "on_drives.hpp"

namespace {

struct on_drives
    : hil::skills_on_drives,
      cca::recordable,
      cca::traceable,
      cca::shows<cca::robots::oncilla::legged_body, "robot.angles", "robot.synchronizer.orientation"> {};

struct program : cca::robot_program<on_drives> {
  program() {
    purpose = "a simulated Oncilla on virtual drives trots, stops, reaches for a ball and trots on";
    settings.speed.reset();  // a fast run
  }

  void options(cca::command_line& line) override { o.offer(line, settings); }

  void prepare(controller_type& c) override {
    buses.connect(c);
    hil::prepare(c, o.shape);
  }
  void loaded(controller_type& c) override {
    if (o.run.seed) settings.notes["seed"] = std::to_string(*o.run.seed);
    run.emplace(o.run);
    stage on{c, buses};
    run->begin(on);
  }

  bool between(controller_type& c) override {
    buses.pass_millisecond();
    stage on{c, buses};
    return run->note(on);
  }

  void stop(controller_type& c) override { stopped = buses.shut_down(c); }

  int finish(controller_type&) override {
    const auto result = run->end();
    if (!settings.quiet) skills::write_table(std::cout, o.run, result);
    if (o.summary)
      trot::write(*o.summary, [&](std::ostream& file) { skills::write_json(file, {{o.run, result}}); });
    if (!settings.quiet || !stopped.complete()) std::printf("%s\n", stopped.text().c_str());
    return skills::succeeded(result) ? 0 : 1;
  }

private:
  struct stage {
    controller_type& controller;
    hil::memory_buses& buses;
    const cca::sim::world& world() const { return buses.world(); }
    void put_down(cca::sim::world&& w, const cca::sim::disturbance& d) { buses.put_down(std::move(w), d); }
    void disturb(const cca::sim::disturbance& d) { buses.disturb(d); }
  };

  skills::options o;
  hil::memory_buses buses{{}, true, hil::early_in_beat};
  std::optional<skills::noted_run> run;
  cca::hardware::shut_down_report stopped;
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
