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

#include "../trot/report/command_line.hpp"
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
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    const auto value = [&]() -> const std::string& {
      if (i + 1 == arguments.size()) throw command_line_error(name + ": expected a value after it");
      return arguments[++i];
    };
    if (name == "--seed") {
      const std::string& text = value();
      o.run.seed = text == "none" ? std::nullopt : std::optional(trot::detail::whole_number(name, text));
    } else if (name == "--paw") o.run.paw = static_cast<paw_side>(detail::one_of(name, value(), paw_names));
    else if (name == "--target")
      o.run.where = static_cast<target>(detail::one_of(name, value(), target_names));
    else if (name == "--push") o.run.push = trot::detail::number(name, value(), 0, 100);
    else if (name == "--seconds") set_seconds(o.run, trot::detail::number(name, value(), 1, 20));
    else if (name == "--shape") o.shape = value();
    else if (name == "--config") o.config = value();
    else if (name == "--summary") o.summary = value();
    else if (name == "--csv") o.csv = value();
    else if (name == "--svg") o.svg = value();
    else if (name == "--quiet") o.quiet = true;
    else if (name == "--help") o.help = true;
    else throw command_line_error(name + ": no such option; --help lists them");
  }
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
