// How the robot in a compiled world differs from its description: the drives in their condition, and what its
// links weigh beside it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>

#include <cca/sim/compiled/built/added_masses.hpp>
#include <cca/sim/robot/model/drive_condition.hpp>

namespace cca::sim::detail {

template <class R>
struct built_robot {
  static constexpr auto n = static_cast<std::size_t>(compiled_tree<R>::coordinates);

  std::array<robots::joint_drive, n> drives = R::drives;
  bool has_dry_friction = false;
  added_masses<R> added{};

  constexpr built_robot() { take({}); }
  explicit built_robot(const body_factors& by) : added(by) {
    if (by.has_lengths())
      throw std::invalid_argument(
          "cca::sim::compiled_world: the lengths of links are constants of its code, so `body.length` of the "
          "settings must be 1; cca::sim::robot_world takes others");
    take({});
  }

  // Over the coordinates; none: as described.
  constexpr void take(std::span<const drive_condition> conditions) {
    has_dry_friction = false;
    for (std::size_t c = 0; c < n; ++c) {
      drives[c] = c < conditions.size() ? in_condition(R::drives[c], conditions[c]) : R::drives[c];
      has_dry_friction = has_dry_friction || drives[c].dry_friction > 0;
    }
  }
};

}  // namespace cca::sim::detail
