#pragma once
// The program of the walk, around the main function for robots (cca/main.hpp). The robot's engine is a
// parameter.
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>

#include <cca/cca.hpp>
#include <cca/main.hpp>

#include "../trot/report/command_line.hpp"
#include "../trot/report/csv.hpp"
#include "../trot/report/engine.hpp"
#include "../trot/report/file.hpp"
#include "../trot/report/progress.hpp"
#include "../trot/report/statistics.hpp"
#include "../trot/report/summary.hpp"
#include "../trot/report/svg.hpp"
#include "../trot/report/watched.hpp"
#include "rollout.hpp"
#include "worth.hpp"

namespace walking {

// `Watched`: `watched` of the architecture of a robot with the questions of asked_by_leg.hpp. `Runs`: what
// --engine calls it.
template <class Watched, trot::engine Runs>
struct program : cca::robot_program<Watched> {
  using controller_type = typename cca::robot_program<Watched>::controller_type;
  using cca::robot_program<Watched>::purpose, cca::robot_program<Watched>::settings;

  program() {
    purpose = "a simulated Oncilla walks by a learned policy";
    settings.seconds = 20;
    settings.speed.reset();  // a fast run
    o.seed = 1000;           // no seed of the training
  }

  void options(cca::command_line& line) override {
    line.text("--weights FILE", weights, "of the policy (walk.policy)");
    o.offer(line, settings);
    line.number("--turn W", turn, -1, 1, "rad/s to the left, from where it walks (the parameters' turn)");
    trot::offer_engine(line);
  }

  void prepare(controller_type& c) override { name_weights(c, weights); }

  void loaded(controller_type& c) override {
    if (o.speed) command_speed(c, *o.speed);
    if (turn) command_turn(c, *turn);
    wanted = {c.template get<"gait.throttle">().p.speed, c.template get<"gait.helm">().p.turn};
    const double seconds = *settings.seconds;
    if (o.seed) settings.notes["seed"] = std::to_string(*o.seed);
    settings.notes["ground"] = o.ground.name();
    settings.notes["engine"] = trot::name_of(Runs);
    recorded = walking::begin(
        c, o.ground,
        o.seed ? cca::sim::disturbance::from_seed(*o.seed, seconds) : cca::sim::disturbance::none(), seconds);
    bar = trot::progress_bar("walk", !settings.quiet);
  }

  bool between(controller_type& c) override {
    const auto& world = c.template get<"robot.simulator">().world();
    recorded.note(world);
    if (c.beat_index() % 20 == 0) {
      char note[64];
      std::snprintf(note, sizeof note, "%5.1f s %6.2f m", world.time(), world.trunk_position()[0]);
      bar.show(world.time() / *settings.seconds, note);
    }
    return !recorded.fell;
  }

  void stop(controller_type& c) override {
    if (c.state() != cca::state::loaded) c.stop();  // else it has waited for its first beat
    bar.done();
  }

  int finish(controller_type&) override {
    const trot::statistics figures = trot::evaluate(recorded);
    if (!settings.quiet) {
      trot::write_table(std::cout, figures, std::nullopt);
      tell_way();
    }
    if (o.summary)
      trot::write(*o.summary, [&](std::ostream& file) {
        trot::write_json(file, figures, std::nullopt, {o.seed, o.ground.name(), trot::name_of(Runs)});
      });
    if (o.csv) trot::write(*o.csv, [&](std::ostream& file) { trot::write_csv(file, recorded); });
    if (o.svg)
      trot::write(*o.svg, [&](std::ostream& file) {
        char title[128];
        std::snprintf(title, sizeof title, "Oncilla, learned policy on %s ground: %.2f m in %.1f s, %.2f m/s",
                      o.ground.name().c_str(), figures.distance, figures.seconds, figures.speed);
        trot::write_svg(file, recorded, title);
      });
    return figures.fell ? 1 : 0;
  }

private:
  // In a circle the table's speed, which is along x, says little.
  void tell_way() const {
    const walking::figures f = along_its_way(recorded);
    std::printf(
        "  along its way         %.3f m/s of %.2f, %+.3f rad/s of %+.2f, cost of transport %.2f: %s\n",
        f.cruise, wanted.speed, f.turn, wanted.turn, f.transport,
        walks(f, wanted) ? "it walks as commanded" : "not as commanded");
  }

  std::string weights = "walk.policy";
  trot::options o;
  std::optional<double> turn;  // rad/s
  command wanted;
  trot::progress_bar bar{"walk"};
  trot::recording recorded;
};

}  // namespace walking
