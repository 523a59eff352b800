#pragma once
// The Combination of Skills with one type changed, on virtual drives around the simulated Oncilla, on buses
// in memory.
#include <optional>
#include <string>

#include "../combination_of_skills/command_line.hpp"
#include "in_memory.hpp"

namespace hil {

// [skills]
struct skills_on_drives : skills::architecture<oncilla<memory_end>> {};
// [skills end]

// The far side answers soon: what the sensor board has not got through when the next beat begins would meet
// the frame that says where the abductions shall be, and be given up.
struct skills_in_memory : in_memory<skills_on_drives> {
  skills_in_memory() : in_memory({}, true, 300'000) {}
};

// Without the balance reflex, unless a file says otherwise: it turns the trunk's rate into a knee's angle,
// whose own rate the servos follow, and over the buses that comes late enough for the standing robot to
// tremble.
inline void load(skills_in_memory& run, const std::string& shape, const std::optional<std::string>& config) {
  auto reflex = run.controller.get<"balance">().p;
  reflex.time = 0;
  run.controller.set<"balance">(reflex);
  skills::load(run.controller, shape, config);
}

}  // namespace hil
