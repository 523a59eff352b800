#pragma once
// What is played, and how the components of this process are set up for it.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <cca/main/command_line.hpp>

#include "../combination_of_skills/rollout.hpp"
#include "observing.hpp"

namespace deployed {

struct settings {
  skills::circumstances run{.where = skills::target::inside};
  std::string shape = "trot.shape";
  std::int64_t most_beats = 60'000;
  observing files{};
};

inline bool is_named(const std::vector<std::string>& names, std::string_view one) {
  return std::find(names.begin(), names.end(), one) != names.end();
}

// Loads and starts what runs in this process: a controller has all environments.
template <class Played>
void set_up(Played& played, const settings& s, const std::vector<std::string>& here) {
  if (is_named(here, "reflexes") && !played.template get<"dmp.module">().p.files.load.assign(s.shape))
    throw cca::command_line_error(s.shape + ": this name is too long");
  if (is_named(here, "simulation")) {
    played.template get<"robot.simulator">().set_scene(s.run);
    played.template get<"recorder">().seen.reserve(s.most_beats);
  }
  played.load();
  played.start();
}

}  // namespace deployed
