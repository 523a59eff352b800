#pragma once
// The options of `trot` beside those that every robot's program has. A mistake is refused with a message that
// says what was expected.
#include <cstdint>
#include <optional>
#include <string>

#include <cca/main/command_line.hpp>
#include <cca/main/robot_program.hpp>
#include <cca/sim/engine/terrain.hpp>

namespace trot {

inline void offer_terrain(cca::command_line& line, cca::sim::terrain& ground) {
  line.value(
      "--terrain T", [&ground](const std::string& text) { ground = cca::sim::terrain::named(text); },
      "flat, slope[:degrees] or steps[:millimetres] (flat)");
}

// None: no disturbance.
inline void offer_seed(cca::command_line& line, std::optional<std::uint64_t>& seed) {
  line.value(
      "--seed N",
      [&seed](const std::string& text) {
        seed = text == "none" ? std::nullopt : std::optional(cca::whole_number_in("--seed", text));
      },
      "the disturbance: joint noise, friction, pushes (0); `none` for none");
}

struct options {
  std::optional<std::uint64_t> seed = 0;
  cca::sim::terrain ground = cca::sim::terrain::flat();
  std::optional<double> speed;  // m/s; otherwise what the parameters say
  std::optional<std::string> summary, csv, svg;

  void offer(cca::command_line& line, cca::run_settings& settings) {
    line.number("--seconds S", settings.seconds, 0.001, 36000, "how long, in simulated seconds (20)");
    offer_seed(line, seed);
    offer_terrain(line, ground);
    line.number("--speed V", speed, 0, 1, "m/s, 0, or 0.2 to 0.8 for a steady trot (the parameters' speed)");
    line.text("--summary FILE", summary, "the table as one JSON object");
    line.text("--csv FILE", csv, "every fifth beat");
    line.text("--svg FILE", svg, "footfalls, path and joint angles");
    line.flag("--quiet", settings.quiet, "no progress bar, no tables");
  }
};

}  // namespace trot
