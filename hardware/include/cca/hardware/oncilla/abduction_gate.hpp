// The gate before the abduction servos of the sensor board: the same as before the drives.
//
//   pass(wanted, measured)   rad. The targets of this beat, not a number where the servo must not move
//   close()                  in each beat without motion: the next motion begins where the servos are
//
// Motion begins at the measured angle, with at most 2 rad/s until it has reached the command; then a target
// moves as fast as the axis may. Targets stay within the range of the axis; one that has not been measured
// waits. A beat is 1 ms. Cost: five operations a servo. Example:
// tests/runtime/drive_chain/start_and_stop.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <cca/hardware/drives/joint.hpp>
#include <cca/robots/oncilla/spaces.hpp>

namespace cca::hardware {

class abduction_gate {
public:
  static constexpr std::size_t count = 4;
  using angles = std::array<double, count>;
  static constexpr double approach = 2, seconds = 1e-3;

  void close() { open = {}; }

  angles pass(const robots::oncilla::abduction_angles::vector_type& wanted, const angles& measured) {
    using axis = robots::oncilla::left_front_abduction;  // all four have the same limits
    constexpr joint_bounds range{cca::detail::lower_limit_of<axis, cca::angle>,
                                 cca::detail::upper_limit_of<axis, cca::angle>};
    constexpr double fastest = cca::detail::upper_limit_of<axis, cca::velocity>;
    angles safe;
    safe.fill(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < count; ++i) {
      const double target = wanted[static_cast<Eigen::Index>(i)];
      if (!open[i]) {
        if (!std::isfinite(measured[i])) continue;
        open[i] = approaching[i] = true;
        at[i] = measured[i];
      }
      if (!std::isfinite(target)) continue;
      const double step = seconds * (approaching[i] ? std::min(approach, fastest) : fastest);
      const double within = range.nearest(target);
      at[i] = joint_bounds{at[i] - step, at[i] + step}.nearest(within);
      if (at[i] == within) approaching[i] = false;
      safe[i] = at[i];
    }
    return safe;
  }

private:
  angles at{};
  std::array<bool, count> open{}, approaching{};
};

}  // namespace cca::hardware
