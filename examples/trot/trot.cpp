// The Oncilla trots in the simulator. `trot --help` lists the options.
//
// To learn from it, read in this order:
//   spaces.hpp               the types of what flows between the components
//   throttle.hpp, stride_oscillator.hpp, gait.hpp, posture.hpp
//                            the components
//   architecture.hpp         how they are wired
//   rollout.hpp              a run in the simulator
//   trot.toml                the parameters
// report/ has what this program adds to the main function for robots: options, progress bar, figures, CSV and
// SVG files. The search for gait parameters is in tools/gait_search.
#include <chrono>
#include <cstdio>
#include <iostream>
#include <string>

#include <cca/cca.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/main.hpp>
#include <cca/robots/oncilla/legged_body.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>                // offers --record
#include <cca/record/replay_option.hpp>  // offers --replay
#endif

#include "report/command_line.hpp"
#include "report/csv.hpp"
#include "idle_robot.hpp"
#include "report/file.hpp"
#include "report/progress.hpp"
#include "rollout.hpp"
#include "report/statistics.hpp"
#include "report/summary.hpp"
#include "report/svg.hpp"

namespace {

using clock_type = std::chrono::steady_clock;

double seconds_since(clock_type::time_point start) {
  return std::chrono::duration<double>(clock_type::now() - start).count();
}

struct idle_trot : trot::architecture<trot::idle_robot> {};

// The time of a beat of the same controller, with a robot that costs nothing.
double controller_nanoseconds() {
  cca::controller<idle_trot> controller;
  controller.load();
  controller.start();
  constexpr int beats = 200'000;
  const auto start = clock_type::now();
  for (int k = 0; k < beats; ++k) controller.step();
  return seconds_since(start) / beats * 1e9;
}

struct simulated_trot
    : trot::simulated_trot,
      cca::recordable,
      cca::traceable,
      cca::shows<cca::robots::oncilla::legged_body, "robot.angles", "robot.simulator.orientation"> {};

struct program : cca::robot_program<simulated_trot> {
  program() : bar("trot") {
    purpose = "a simulated Oncilla trots";
    settings.seconds = 20;
    settings.speed.reset();  // a fast run
  }

  void options(cca::command_line& line) override { o.offer(line, settings); }

  void loaded(controller_type& c) override {
    if (o.speed) {
      auto wanted = c.get<"throttle">().p;
      wanted.speed = *o.speed;
      c.set<"throttle">(wanted);
    }
    const double seconds = *settings.seconds;
    if (o.seed) settings.notes["seed"] = std::to_string(*o.seed);
    settings.notes["ground"] = o.ground.name();
    recorded = trot::begin(
        c, o.ground,
        o.seed ? cca::sim::disturbance::from_seed(*o.seed, seconds) : cca::sim::disturbance::none(), seconds);
    bar = trot::progress_bar("trot", !settings.quiet);
    start = clock_type::now();
  }

  bool between(controller_type& c) override {
    const cca::sim::world& world = c.get<"robot.simulator">().world();
    recorded.note(world);
    if (c.beat_index() % 20 == 0) {
      const auto drawing = clock_type::now();
      char note[64];
      std::snprintf(note, sizeof note, "%5.1f s %6.2f m", world.time(), world.trunk_position()[0]);
      bar.show(world.time() / *settings.seconds, note);
      drawn += seconds_since(drawing);
    }
    return !recorded.fell;
  }

  void stop(controller_type& c) override {
    c.stop();
    taken = seconds_since(start) - drawn;
    bar.done();
  }

  int finish(controller_type&) override {
    const trot::statistics figures = trot::evaluate(recorded);
    trot::costs costs;
    costs.real_time_factor = figures.seconds / taken;
    costs.controller_ns_per_beat = controller_nanoseconds();
    costs.physics_ns_per_beat =
        taken * 1e9 / static_cast<double>(recorded.moments.size()) - costs.controller_ns_per_beat;
    if (!settings.quiet) trot::write_table(std::cout, figures, costs);
    if (o.summary)
      trot::write(*o.summary, [&](std::ostream& file) {
        trot::write_json(file, figures, costs, {o.seed, o.ground.name()});
      });
    if (o.csv) trot::write(*o.csv, [&](std::ostream& file) { trot::write_csv(file, recorded); });
    if (o.svg)
      trot::write(*o.svg, [&](std::ostream& file) { trot::write_svg(file, recorded, title(figures)); });
    return figures.fell ? 1 : 0;
  }

private:
  std::string title(const trot::statistics& figures) const {
    char text[128];
    std::snprintf(text, sizeof text, "Oncilla, trot on %s ground: %.2f m in %.1f s, %.2f m/s",
                  o.ground.name().c_str(), figures.distance, figures.seconds, figures.speed);
    return text;
  }

  trot::options o;
  trot::progress_bar bar;
  trot::recording recorded;
  clock_type::time_point start{};
  double drawn = 0, taken = 0;  // s
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
