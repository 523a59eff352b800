#pragma once
// The options of `trot` from the command line. A mistake is refused with a message that says what was
// expected.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <cca/sim/terrain.hpp>

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
    "  --help            this text\n";

struct command_line_error : std::runtime_error {
  using runtime_error::runtime_error;
};

namespace detail {

inline double number(const std::string& option, const std::string& text, double low, double high) {
  std::size_t read = 0;
  double value = 0;
  try {
    value = std::stod(text, &read);
  } catch (const std::exception&) { read = 0; }
  if (read == 0 || read != text.size() || !(value >= low && value <= high))
    throw command_line_error(option + " " + text + ": expected a number from " + std::to_string(low) +
                             " to " + std::to_string(high));
  return value;
}

inline std::uint64_t whole_number(const std::string& option, const std::string& text) {
  if (text.empty() || text.size() > 18 || text.find_first_not_of("0123456789") != text.npos)
    throw command_line_error(option + " " + text + ": expected a whole number, 0 or more");
  return std::stoull(text);
}

inline cca::sim::terrain ground(const std::string& text) {
  try {
    return cca::sim::terrain::named(text);
  } catch (const std::invalid_argument& e) { throw command_line_error(e.what()); }
}

}  // namespace detail

// For programs whose options all have a value.
inline bool asks_for_help(const std::vector<std::string>& arguments) {
  return std::find(arguments.begin(), arguments.end(), "--help") != arguments.end();
}

inline options parse(const std::vector<std::string>& arguments) {
  options o;
  for (auto at = arguments.begin(); at != arguments.end(); ++at) {
    const std::string& name = *at;
    const auto value = [&]() -> const std::string& {
      if (++at == arguments.end()) throw command_line_error(name + ": expected a value after it");
      return *at;
    };
    if (name == "--seconds") o.seconds = detail::number(name, value(), 0.001, 36000);
    else if (name == "--seed") {
      const std::string& text = value();
      o.seed = text == "none" ? std::nullopt : std::optional(detail::whole_number(name, text));
    } else if (name == "--terrain") o.ground = detail::ground(value());
    else if (name == "--speed") o.speed = detail::number(name, value(), 0, 1);
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

}  // namespace trot
