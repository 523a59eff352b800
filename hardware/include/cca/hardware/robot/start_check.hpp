// Whether motion may begin: the joints are where they may be, and their velocities mean what they say.
//
//   begin()                      a new start
//   check(drives)                each beat while the drives are enabled: the reason to refuse the start, or
//                                none. A joint that is outside of its range by more than `range_tolerance`,
//                                in three beats in a row; a velocity that is not the change of the angle
//   missing(drives, enabling, board_reports)
//                                when the time is over: what has not come, or has not passed
//
// Used by drive_synchronizer.hpp. Cost: some operations a joint, while it enables.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <cca/hardware/robot/drive_enabling.hpp>
#include <cca/hardware/robot/joint_monitor.hpp>
#include <cca/hardware/robot/start_failure.hpp>

namespace cca::hardware {

template <class... J>
class start_check {
public:
  using joints = joint_list<J...>;
  // rad. An Oncilla that has collapsed lies on its hips, 0.45 rad outside, and must be able to stand up.
  static constexpr double range_tolerance = 0.5;
  static constexpr int beats = 3;  // one wrong frame refuses nothing

  void begin() { outside = {}; }

  start_failure check(const joint_monitor<J...>& drives) {
    for (std::size_t i = 0; i < joints::count; ++i) {
      const double angle = drives.angle_now(i);
      const bool is_outside = std::abs(angle - joints::angle[i].nearest(angle)) > range_tolerance;
      outside[i] = is_outside ? outside[i] + 1 : 0;
      if (outside[i] >= beats) return of(i, safety_rule::range, drives);
      if (drives.velocity(i).disagrees()) return of(i, safety_rule::implausible, drives);
    }
    return {};
  }

  start_failure missing(const joint_monitor<J...>& drives,
                        const drive_enabling<J...>& enabling,
                        bool board_reports) const {
    for (std::size_t i = 0; i < joints::count; ++i) {
      start_failure f = of(i, safety_rule::enabling, drives);
      f.missing = !drives.knows_angle(i)    ? "does not report its angle"
                  : !drives.knows_speed(i)  ? "does not report its velocity"
                  : !enabling.is_enabled(i) ? "can't be enabled"
                                            : "";
      if (!f.missing.empty()) return f;
    }
    // A joint that has turned a little and rests now: too little for `check`, and not taken back.
    for (std::size_t i = 0; i < joints::count; ++i)
      if (!drives.velocity(i).passed()) return of(i, safety_rule::implausible, drives);
    start_failure f{.why = safety_rule::enabling};
    f.missing = !board_reports ? "the sensor board is silent"
                               : "a bus is away, or holds frames that nobody acknowledges";
    return f;
  }

private:
  static start_failure of(std::size_t i, safety_rule why, const joint_monitor<J...>& drives) {
    return {why, joints::names[i], drives.angle[i], joints::angle[i], range_tolerance, {}};
  }

  std::array<int, joints::count> outside{};
};

}  // namespace cca::hardware
