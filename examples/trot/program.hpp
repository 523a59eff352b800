#pragma once
// The program of the trot, around the main function for robots (cca/main.hpp). The robot's engine is a
// parameter.
#include <chrono>
#include <cstdio>
#include <iostream>
#include <span>
#include <string>

#include <cca/cca.hpp>
#include <cca/main.hpp>

#include "report/command_line.hpp"
#include "report/csv.hpp"
#include "report/engine.hpp"
#include "idle_robot.hpp"
#include "report/file.hpp"
#include "report/progress.hpp"
#include "rollout.hpp"
#include "report/statistics.hpp"
#include "report/summary.hpp"
#include "report/svg.hpp"
#include "report/watched.hpp"

namespace trot {

using clock_type = std::chrono::steady_clock;

inline double seconds_since(clock_type::time_point start) {
  return std::chrono::duration<double>(clock_type::now() - start).count();
}

struct idle_trot : architecture<idle_robot> {};

// The time of a beat of the same controller, with a robot that costs nothing.
inline double controller_nanoseconds() {
  cca::controller<idle_trot> controller;
  controller.load();
  controller.start();
  constexpr int beats = 200'000;
  const auto start = clock_type::now();
  for (int k = 0; k < beats; ++k) controller.step();
  return seconds_since(start) / beats * 1e9;
}

// [push]
// Offered through a door: a force on the trunk, held.
template <class Controller>
cca::run_command<Controller> push_of_trunk() {
  const auto push = [](Controller& c, const Eigen::Vector3d& force) {
    c.template get<"robot.simulator">().world().push(force);
  };
  return {.name = "push",
          .help = "pushes the trunk",
          .arguments = {{"forward", 10, -60, 60, "N"}, {"left", 0, -60, 60, "N"}},
          .begin = [push](Controller& c,
                          std::span<const double> newtons) { push(c, {newtons[0], newtons[1], 0}); },
          .end = [push](Controller& c) { push(c, Eigen::Vector3d::Zero()); }};
}
// [push end]

// `Watched`: `watched` of the architecture of a robot with the questions of asked_by_leg.hpp. `Runs`: what
// --engine calls it.
template <class Watched, engine Runs>
struct program : cca::robot_program<Watched> {
  using controller_type = typename cca::robot_program<Watched>::controller_type;
  using cca::robot_program<Watched>::purpose, cca::robot_program<Watched>::settings;

  program() : bar("trot") {
    purpose = "a simulated Oncilla trots";
    settings.seconds = 20;
    settings.speed.reset();  // a fast run
    this->offers.push_back(push_of_trunk<controller_type>());
  }

  void options(cca::command_line& line) override {
    o.offer(line, settings);
    offer_engine(line);
  }

  void loaded(controller_type& c) override {
    if (o.speed) {
      auto wanted = c.template get<"throttle">().p;
      wanted.speed = *o.speed;
      c.template set<"throttle">(wanted);
    }
    const double seconds = *settings.seconds;
    if (o.seed) settings.notes["seed"] = std::to_string(*o.seed);
    settings.notes["ground"] = o.ground.name();
    settings.notes["engine"] = name_of(Runs);
    recorded = trot::begin(
        c, o.ground,
        o.seed ? cca::sim::disturbance::from_seed(*o.seed, seconds) : cca::sim::disturbance::none(), seconds);
    bar = progress_bar("trot", !settings.quiet);
    start = clock_type::now();
  }

  bool between(controller_type& c) override {
    const auto& world = c.template get<"robot.simulator">().world();
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
    if (c.state() != cca::state::loaded) c.stop();  // else it has waited for its first beat
    taken = seconds_since(start) - drawn;
    bar.done();
  }

  int finish(controller_type&) override {
    const statistics figures = evaluate(recorded);
    costs costs;
    costs.real_time_factor = figures.seconds / taken;
    costs.controller_ns_per_beat = controller_nanoseconds();
    costs.physics_ns_per_beat =
        taken * 1e9 / static_cast<double>(recorded.moments.size()) - costs.controller_ns_per_beat;
    if (!settings.quiet) write_table(std::cout, figures, costs);
    if (o.summary)
      write(*o.summary, [&](std::ostream& file) {
        write_json(file, figures, costs, {o.seed, o.ground.name(), name_of(Runs)});
      });
    if (o.csv) write(*o.csv, [&](std::ostream& file) { write_csv(file, recorded); });
    if (o.svg) write(*o.svg, [&](std::ostream& file) { write_svg(file, recorded, title(figures)); });
    return figures.fell ? 1 : 0;
  }

private:
  std::string title(const statistics& figures) const {
    char text[128];
    std::snprintf(text, sizeof text, "Oncilla, trot on %s ground: %.2f m in %.1f s, %.2f m/s",
                  o.ground.name().c_str(), figures.distance, figures.seconds, figures.speed);
    return text;
  }

  trot::options o;
  progress_bar bar;
  recording recorded;
  clock_type::time_point start{};
  double drawn = 0, taken = 0;  // s
};

}  // namespace trot
