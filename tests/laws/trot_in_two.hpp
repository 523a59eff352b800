// The trot on drives in two environments, for tests that take its gait away: the clock of the side with the
// buses, and what its drives do after that.
#pragma once

#include <algorithm>
#include <cstdint>

#include "../../examples/hardware_in_the_loop/two_environments.hpp"

namespace laws {

using trot_in_two = cca::deployed<hil::two_environments<hil::memory_end>>;
inline constexpr std::int64_t tolerated_late_beats = 3;

// A wall-clock run: between two beats a millisecond passes for the drives. It is slow, 50 ms a beat, so that
// a busy machine makes nothing late before the gait is gone.
class clock_of_drives : public cca::at_speed {
public:
  explicit clock_of_drives(hil::memory_buses& drives) : at_speed(0.02), far(drives) {}
  void wait(std::int64_t since) {
    at_speed::wait(since);
    if (since > 0) far.pass_millisecond();
  }

private:
  hil::memory_buses& far;
};

inline bool is_driven(const hil::memory_buses& far) {
  return std::ranges::any_of(far.laws, [](const auto& law) { return law.stiffness > 0; });
}
inline bool trots(const hil::memory_buses& far) {
  return is_driven(far) && far.world().trunk_position()[0] > 0.3;
}

// In how many of the next 300 ms a drive still holds a position.
inline int driven_after(trot_in_two& robot, hil::memory_buses& far) {
  int driven = 0;
  for (int ms = 0; ms < 300; ++ms) {  // the frames of on_fault are on the buses
    far.pass_millisecond();
    if (is_driven(far)) ++driven;
    robot.step();
  }
  return driven;
}

}  // namespace laws
