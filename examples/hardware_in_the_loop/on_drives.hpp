#pragma once
// The Combination of Skills with one type changed: on virtual drives around the simulated Oncilla, over buses
// in memory.
#include <optional>
#include <string>

#include "../combination_of_skills/command_line.hpp"
#include "in_memory.hpp"

namespace hil {

// [skills]
struct skills_on_drives : skills::architecture<oncilla<memory_end>> {};
// [skills end]

// The far end answers early in the beat. A frame of the sensor board that is still waiting when the next beat
// begins would lose arbitration against the abduction targets, and be dropped.
inline constexpr std::int64_t early_in_beat = 300'000;
struct skills_in_memory : in_memory<skills_on_drives> {
  skills_in_memory() : in_memory({}, true, early_in_beat) {}
};

// Before the parameters are loaded: names the shape of the trot, and switches the balance reflex off, unless
// a file sets it. It turns the trunk's rate of turn into a knee angle, and the delay of the buses is enough
// to make the standing robot tremble.
template <class Controller>  // of skills_on_drives, or of a graph derived from it
void prepare(Controller& controller, const std::string& shape) {
  auto reflex = controller.template get<"balance">().p;
  reflex.time = 0;
  controller.template set<"balance">(reflex);
  skills::name_shape(controller, shape);
}
inline void load(skills_in_memory& run, const std::string& shape, const std::optional<std::string>& config) {
  prepare(run.controller, shape);
  skills::load(run.controller, shape, config);
}

}  // namespace hil
