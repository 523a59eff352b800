// Whether motion may begin: the joints are where they may be, turn no faster than they may, and their
// velocities mean what they say.
//
//   begin()                      a new start
//   check(drives)                each beat while the drives are enabled: the reason to refuse the start, or
//                                none. A joint that is outside of its range by more than `range_tolerance`,
//                                or faster than its axis allows by more than `speed_tolerance`, in three
//                                beats in a row; a velocity that is not the change of the angle
//   may_begin()                  no joint was outside or too fast in the last beat
//   missing(drives, enabling, board_reports)
//                                when the time is over: what has not come, or has not passed
//
// Used by drive_synchronizer.hpp. Cost: some operations a joint, while it enables.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/robot/start_failure.hpp>

namespace cca::hardware {

template <class... J>
class start_check {
public:
  using joints = joint_list<J...>;
  // rad. An Oncilla that has collapsed lies on its hips, 0.45 rad outside, and must be able to stand up.
  static constexpr double range_tolerance = 0.5;
  // rad/s: the speed that a joint at rest may report, from steps of its drive's numbers.
  static constexpr double speed_tolerance = 0.1;
  static constexpr int beats = 3;  // one wrong frame refuses nothing

  void begin() { outside = too_fast = {}; }

  template <class Monitor>
  start_failure check(const Monitor& drives) {
    for (std::size_t i = 0; i < joints::count; ++i) {
      const double angle = drives.angle_now(i);
      const bool is_outside = std::abs(angle - joints::angle[i].nearest(angle)) > range_tolerance;
      outside[i] = is_outside ? outside[i] + 1 : 0;
      if (outside[i] >= beats) return of(i, safety_rule::range, drives);
      const double speed = drives.speed_now(i);
      too_fast[i] = std::abs(speed - joints::speed[i].nearest(speed)) > speed_tolerance ? too_fast[i] + 1 : 0;
      if (too_fast[i] >= beats) return of(i, safety_rule::rate, drives);
      if (drives.velocity(i).disagrees()) return of(i, safety_rule::implausible, drives);
    }
    return {};
  }

  bool may_begin() const {
    constexpr auto is_zero = [](int n) { return n == 0; };
    return std::ranges::all_of(outside, is_zero) && std::ranges::all_of(too_fast, is_zero);
  }

  template <class Monitor, class Enabling>
  start_failure missing(const Monitor& drives, const Enabling& enabling, bool board_reports) const {
    for (std::size_t i = 0; i < joints::count; ++i) {
      start_failure f = of(i, safety_rule::enabling, drives);
      f.missing = !drives.knows_angle(i)    ? "does not report its angle"
                  : !drives.knows_speed(i)  ? "does not report its velocity"
                  : !drives.knows_torque(i) ? "does not report its torque as often as its type states"
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
  template <class Monitor>
  static start_failure of(std::size_t i, safety_rule why, const Monitor& drives) {
    const bool by_speed = why == safety_rule::rate;
    return {why,
            joints::names[i],
            by_speed ? drives.speed[i] : drives.angle[i],
            by_speed ? joints::speed[i] : joints::angle[i],
            by_speed ? speed_tolerance : range_tolerance,
            {}};
  }

  std::array<int, joints::count> outside{}, too_fast{};
};

}  // namespace cca::hardware
