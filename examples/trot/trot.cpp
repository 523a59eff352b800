// The Oncilla trots in the simulator. `trot --help` lists the options.
//
// To learn from it, read in this order:
//   spaces.hpp               the types of what flows between the components
//   throttle.hpp, stride_oscillator.hpp, gait.hpp, posture.hpp
//                            the components
//   architecture.hpp         how they are wired
//   rollout.hpp              a run in the simulator
//   trot.toml                the parameters
// report/ has what every program needs around its controller: command line, progress bar, figures, CSV and
// SVG files. The search for gait parameters is in tools/gait_search.
#include <chrono>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/runtime/interruption.hpp>

#include "report/command_line.hpp"
#include "report/csv.hpp"
#include "idle_robot.hpp"
#include "report/program.hpp"
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

int run(const trot::options& o) {
  trot::trotting controller;
  if (o.config) controller.load(*o.config);
  else controller.load();
  if (o.speed) {
    auto wanted = controller.get<"throttle">().p;
    wanted.speed = *o.speed;
    controller.set<"throttle">(wanted);
  }

  const auto disturbance =
      o.seed ? cca::sim::disturbance::from_seed(*o.seed, o.seconds) : cca::sim::disturbance::none();
  trot::progress_bar bar("trot", !o.quiet);
  const cca::interruption interrupted;  // ctrl-c: ends the run, and what it has is written
  double in_between = 0;
  const auto start = clock_type::now();
  const trot::recording recorded = trot::roll_out(
      controller, o.ground, disturbance, o.seconds, [&](const cca::sim::world& world, double part) {
        if (controller.beat_index() % 20 != 0) return !interrupted;
        const auto drawing = clock_type::now();
        char note[64];
        std::snprintf(note, sizeof note, "%5.1f s %6.2f m", world.time(), world.trunk_position()[0]);
        bar.show(part, note);
        in_between += seconds_since(drawing);
        return !interrupted;
      });
  controller.stop();
  const double taken = seconds_since(start) - in_between;
  bar.done();
  if (interrupted) std::cerr << "trot: interrupted; the figures are of what it has run\n";

  const trot::statistics figures = trot::evaluate(recorded);
  trot::costs costs;
  costs.real_time_factor = figures.seconds / taken;
  costs.controller_ns_per_beat = controller_nanoseconds();
  costs.physics_ns_per_beat =
      taken * 1e9 / static_cast<double>(recorded.moments.size()) - costs.controller_ns_per_beat;

  const std::string seed = o.seed ? std::to_string(*o.seed) : "null";
  if (!o.quiet) trot::write_table(std::cout, figures, costs);
  if (o.summary)
    trot::write(*o.summary,
                [&](std::ostream& file) { trot::write_json(file, figures, costs, {seed, o.ground.name()}); });
  if (o.csv) trot::write(*o.csv, [&](std::ostream& file) { trot::write_csv(file, recorded); });
  if (o.svg) {
    char title[128];
    std::snprintf(title, sizeof title, "Oncilla, trot on %s ground: %.2f m in %.1f s, %.2f m/s",
                  o.ground.name().c_str(), figures.distance, figures.seconds, figures.speed);
    trot::write(*o.svg, [&](std::ostream& file) { trot::write_svg(file, recorded, title); });
  }
  return interrupted ? interrupted.exit_code() : figures.fell ? 1 : 0;
}

}  // namespace

int main(int count, char** arguments) {
  return trot::program("trot", trot::usage, count, arguments,
                       [](const std::vector<std::string>& given) { return run(trot::parse(given)); });
}
