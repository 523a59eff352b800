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

template <class R, class Real = double>
struct built_robot {
  static constexpr auto n = static_cast<std::size_t>(compiled_tree<R>::coordinates);
  using number = number_of<Real>;

  std::array<drive_numbers<number>, n> drives{};
  number rubs{};  // 1 where a joint has dry friction, 0 where none has
  added_masses<R, number> added{};

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
    rubs = number(0.0);
    for (std::size_t c = 0; c < n; ++c) {
      drives[c] = drive_numbers<number>(c < conditions.size() ? in_condition(R::drives[c], conditions[c])
                                                              : R::drives[c]);
      if (is_any(drives[c].dry_friction)) rubs = number(1.0);
    }
  }

  bool has_dry_friction() const { return is_any(rubs); }

  // Of a robot in a lane. `take_lane` of each lane, in their order.
  void take_lane(int k, const built_robot<R, double>& one)
    requires is_in_lanes<Real>
  {
    for (std::size_t c = 0; c < n; ++c) {
      const auto& from = one.drives[c];
      auto& to = drives[c];
      to.torque.set(k, from.torque), to.no_load_speed.set(k, from.no_load_speed);
      to.friction.set(k, from.friction), to.dry_friction.set(k, from.dry_friction);
    }
    rubs.set(k, one.rubs);
    added.take_lane(k, one.added);
  }
};

}  // namespace cca::sim::detail
