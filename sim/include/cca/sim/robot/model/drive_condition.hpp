// How the drive of a joint differs from its description at the moment: worn, rusty, on a low battery.
//
// It acts within the physics steps of a world (`set_condition`), so friction holds a joint still and a motor
// runs out of torque as they do in the description. Units of a prismatic joint: N, N s/m.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <cca/robots/description.hpp>

namespace cca::sim {

struct drive_condition {
  double strength = 1;      // share of the motor's torque that is left
  double supply = 1;        // share of the voltage: of the motor's torque and of its no-load speed
  double friction = 0;      // N m s/rad, beside that of the description
  double dry_friction = 0;  // N m, the same

  bool is_possible() const {
    return std::isfinite(strength + supply + friction + dry_friction) && strength >= 0 && supply > 0 &&
           friction >= 0 && dry_friction >= 0;
  }
};

// A described drive in this condition.
constexpr robots::joint_drive in_condition(robots::joint_drive d, const drive_condition& now) {
  d.motor.torque *= now.strength * now.supply;
  d.motor.no_load_speed *= now.supply;
  d.friction += now.friction;
  d.dry_friction += now.dry_friction;
  return d;
}

// Those that are possible replace the kept ones; of more than are kept, the first count.
template <class Kept>
void take_possible(std::span<const drive_condition> now, Kept& kept) {
  for (std::size_t c = 0; c < std::min(now.size(), kept.size()); ++c)
    if (now[c].is_possible()) kept[c] = now[c];
}

}  // namespace cca::sim
