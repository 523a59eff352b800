#pragma once
// The options of a run beside those that every robot's program has. A mistake is refused with a message that
// says what was expected.
#include <optional>
#include <string>

#include <cca/config.hpp>
#include <cca/main/command_line.hpp>
#include <cca/main/robot_program.hpp>

#include "../trot/report/command_line.hpp"
#include "rollout.hpp"

namespace skills {

inline void set_seconds(circumstances& run, double seconds) {
  constexpr double standing = 0.2;
  run.trot_seconds = seconds + standing;
  run.after_seconds = seconds;
}

// Those that the programs of one run and of many share.
inline void offer_seconds(cca::command_line& line, circumstances& run, std::string_view help) {
  line.number("--seconds S", [&run](double seconds) { set_seconds(run, seconds); }, 1, 20, help);
}
inline void offer_push(cca::command_line& line, circumstances& run) {
  line.number("--push F", run.push, 0, 100, "newtons from the side while the paw is at the ball (20)");
}
inline void offer_shape(cca::command_line& line, std::string& shape) {
  line.text("--shape FILE", shape, "the learned shape (trot.shape); combination_of_skills_learn writes it");
}

struct options {
  circumstances run;
  std::string shape = "trot.shape";
  std::optional<std::string> summary;

  void offer(cca::command_line& line, cca::run_settings& settings) {
    trot::offer_seed(line, run.seed);
    line.one_of("--paw P", run.paw, paw_names, "left or right (left): on which side the ball is");
    line.one_of("--target T", run.where, target_names,
                "ahead, high or inside of where it stops, or in the world (ahead)");
    offer_push(line, run);
    offer_seconds(line, run, "of trot, before and after (6); a ball in the world is 4 m ahead");
    offer_shape(line, shape);
    line.text("--summary FILE", summary, "the figures as JSON: a list of one run");
    line.flag("--quiet", settings.quiet, "no progress bar, no tables");
  }
};

// Names the learned shape of the trot, which the controller then loads.
template <class Controller>
void name_shape(Controller& controller, const std::string& shape) {
  if (!controller.template get<"dmp.module">().p.files.load.assign(shape))
    throw cca::command_line_error(shape + ": this name is too long");
}

// The same, and its parameters from a file, if one is given.
template <class Controller>
void load(Controller& controller, const std::string& shape, const std::optional<std::string>& config) {
  name_shape(controller, shape);
  if (config) controller.load(*config);
  else controller.load();
}

}  // namespace skills
