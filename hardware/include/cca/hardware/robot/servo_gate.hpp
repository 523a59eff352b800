// The gate before the servos of a board: the same as before the drives.
//
//   servo_gate<Axes, Rate> gate;
//   gate.pass(wanted, measured)   rad. The targets of this beat, not a number where the servo must not move
//   gate.close()                  in each beat without motion: the next one begins where the servos are
//
// Motion begins at the measured angle, with at most 2 rad/s until it has reached the command; then a target
// moves as fast as the axis may. Targets stay within the range of the axis; one that has not been measured
// waits. Errors: space.missing_limits. Cost: five operations a servo. Example:
// tests/runtime/drive_chain/start_and_stop.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/safety/beats.hpp>

namespace cca::hardware {

template <class Axes, class Rate = cca::rate<1000>>
class servo_gate;

template <class... Axes, class Rate>
class servo_gate<cca::axes<Axes...>, Rate> {
  template <class Axis>
  using limited =
      cca::detail::holds_or_tells<detail::stated_limits<Axis>::sound, detail::stated_limits<Axis>>;
  static_assert((limited<Axes>::value && ...));

public:
  static constexpr std::size_t count = sizeof...(Axes);
  using angles = std::array<double, count>;
  static constexpr double approach = 2, seconds = 1 / Rate::hz;

  void close() { open = {}; }

  angles pass(const angles& wanted, const angles& measured) {
    angles safe;
    safe.fill(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < count; ++i) {
      if (!open[i]) {
        if (!std::isfinite(measured[i])) continue;
        open[i] = approaching[i] = true;
        at[i] = measured[i];
      }
      if (!std::isfinite(wanted[i])) continue;
      const double step = seconds * (approaching[i] ? std::min(approach, fastest[i]) : fastest[i]);
      const double within = range[i].nearest(wanted[i]);
      at[i] = joint_bounds{at[i] - step, at[i] + step}.nearest(within);
      if (at[i] == within) approaching[i] = false;
      safe[i] = at[i];
    }
    return safe;
  }

private:
  static constexpr std::array<joint_bounds, count> range{joint_bounds{
      cca::detail::lower_limit_of<Axes, cca::angle>, cca::detail::upper_limit_of<Axes, cca::angle>}...};
  static constexpr angles fastest{cca::detail::upper_limit_of<Axes, cca::velocity>...};

  angles at{};
  std::array<bool, count> open{}, approaching{};
};

template <class Rate>
class servo_gate<cca::axes<>, Rate> {};

}  // namespace cca::hardware
