#pragma once
// The options from the command line. A mistake is refused with a message that says what was expected.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../trot/report/option_reader.hpp"
#include "rollout.hpp"

namespace skills {

using trot::command_line_error;

struct options {
  circumstances run;
  std::string shape = "trot.shape";
  std::optional<std::string> config, summary, csv, svg;
  bool quiet = false;
  bool help = false;
};

inline constexpr std::string_view usage =
    "combination_of_skills: a simulated Oncilla trots, stops, reaches for a ball and trots on\n"
    "\n"
    "  --seed N          the disturbance: joint noise, friction, pushes (0); `none` for none\n"
    "  --paw P           left or right (left): on which side the ball is\n"
    "  --target T        ahead, high or inside of where it stops, or fixed in the world (ahead)\n"
    "  --push F          newtons from the side while the paw is at the ball (20)\n"
    "  --seconds S       of trot, before and after (6); a ball in the world is 4 m ahead\n"
    "  --shape FILE      the learned shape of the trot (trot.shape); combination_of_skills_learn writes it\n"
    "  --config FILE     parameters (the defaults in the code)\n"
    "  --summary FILE    the figures as JSON: a list of one run\n"
    "  --csv FILE        every fifth beat\n"
    "  --svg FILE        footfalls, path and joint angles\n"
    "  --quiet           no progress bar, no table\n"
    "  --version         the version of cca\n"
    "  --help            this text\n";

namespace detail {

template <std::size_t Count>
std::size_t one_of(const std::string& option,
                   const std::string& text,
                   const std::array<std::string_view, Count>& names) {
  const auto found = std::find(names.begin(), names.end(), text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string all = option + " " + text + ": expected one of";
  for (const auto name : names) all.append(" ").append(name);
  throw command_line_error(all);
}

}  // namespace detail

inline void set_seconds(circumstances& run, double seconds) {
  constexpr double standing = 0.2;
  run.trot_seconds = seconds + standing;
  run.after_seconds = seconds;
}

inline options parse(const std::vector<std::string>& arguments) {
  options o;
  trot::option_reader read;
  read.value("--seed", [&o](const std::string& text) {
    o.run.seed = text == "none" ? std::nullopt : std::optional(trot::detail::whole_number("--seed", text));
  });
  read.value("--paw", [&o](const std::string& text) {
    o.run.paw = static_cast<paw_side>(detail::one_of("--paw", text, paw_names));
  });
  read.value("--target", [&o](const std::string& text) {
    o.run.where = static_cast<target>(detail::one_of("--target", text, target_names));
  });
  read.number("--push", o.run.push, 0, 100);
  read.value("--seconds", [&o](const std::string& text) {
    set_seconds(o.run, trot::detail::number("--seconds", text, 1, 20));
  });
  read.text("--shape", o.shape);
  read.text("--config", o.config);
  read.text("--summary", o.summary);
  read.text("--csv", o.csv);
  read.text("--svg", o.svg);
  read.flag("--quiet", o.quiet);
  read.flag("--help", o.help);
  read.all(arguments);
  return o;
}

// Loads a controller: its parameters from a file, if one is given, and the learned shape of the trot.
template <class Controller>
void load(Controller& controller, const std::string& shape, const std::optional<std::string>& config) {
  if (!controller.template get<"dmp.module">().p.files.load.assign(shape))
    throw command_line_error(shape + ": this name is too long");
  if (config) controller.load(*config);
  else controller.load();
}

}  // namespace skills
