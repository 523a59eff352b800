// Throws std::invalid_argument for settings of a robot's world that no world can have.
#pragma once

#include <cmath>

#include <cca/sim/engine/checked_scene.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>

namespace cca::sim {

inline void check(const robot_world_settings& s) {
  check(s.engine);
  need(s.steps_per_beat >= 1, "the number of physics steps in a beat", s.steps_per_beat, "", "at least 1");
  need_place(s.mount, "the mount of the robot");
  for (const double bound :
       {s.plausible.speed, s.plausible.turn, s.plausible.energy, s.plausible.stop, s.plausible.stop_way})
    need(bound >= 0, "a bound of what is plausible", bound, "", "at least 0");
  for (const double f : s.body.mass)
    need(f > 0 && std::isfinite(f), "a factor of the mass of a link", f, "", "above 0");
  for (const double f : s.body.length)
    need(f > 0 && std::isfinite(f), "a factor of the length of a link", f, "", "above 0");
}

}  // namespace cca::sim
