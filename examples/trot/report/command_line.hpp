#pragma once
// The options of `trot` from the command line. A mistake is refused with a message that says what was
// expected.
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <cca/sim/terrain.hpp>

#include "option_reader.hpp"

namespace trot {

struct options {
  double seconds = 20;
  std::optional<std::uint64_t> seed = 0;  // none: no disturbance
  cca::sim::terrain ground = cca::sim::terrain::flat();
  std::optional<double> speed;  // m/s; otherwise what the parameters say
  std::optional<std::string> config, summary, csv, svg;
  bool quiet = false;
  bool help = false;
};

inline constexpr std::string_view usage =
    "trot: a simulated Oncilla trots\n"
    "\n"
    "  --seconds S       how long, in simulated seconds (20)\n"
    "  --seed N          the disturbance: joint noise, friction, pushes (0); `none` for none\n"
    "  --terrain T       flat, slope[:degrees] or steps[:millimetres] (flat)\n"
    "  --speed V         m/s, from 0.2 up (the parameters' speed)\n"
    "  --config FILE     parameters (the defaults in the code)\n"
    "  --summary FILE    the table as one JSON object\n"
    "  --csv FILE        every fifth beat\n"
    "  --svg FILE        footfalls, path and joint angles\n"
    "  --quiet           no progress bar, no table\n"
    "  --version         the version of cca\n"
    "  --help            this text\n";

namespace detail {

inline cca::sim::terrain ground(const std::string& text) {
  try {
    return cca::sim::terrain::named(text);
  } catch (const std::invalid_argument& e) { throw command_line_error(e.what()); }
}

}  // namespace detail

inline options parse(const std::vector<std::string>& arguments) {
  options o;
  option_reader read;
  read.number("--seconds", o.seconds, 0.001, 36000);
  read.value("--seed", [&o](const std::string& text) {
    o.seed = text == "none" ? std::nullopt : std::optional(detail::whole_number("--seed", text));
  });
  read.value("--terrain", [&o](const std::string& text) { o.ground = detail::ground(text); });
  read.number("--speed", o.speed, 0, 1);
  read.text("--config", o.config);
  read.text("--summary", o.summary);
  read.text("--csv", o.csv);
  read.text("--svg", o.svg);
  read.flag("--quiet", o.quiet);
  read.flag("--help", o.help);
  read.all(arguments);
  return o;
}

}  // namespace trot
