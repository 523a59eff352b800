// Why a start was refused, for people.
//
//   start_failure f = controller.get<"robot.synchronizer">().failure();
//   if (f) std::puts(text_of(f).c_str());   // left_front_hip is at 2.31 rad, outside of its range ...
//
// `why` is the rule: enabling (a drive, or a quantity that it must report, is missing), range (a joint is
// outside), rate (a joint turns faster than its axis allows), implausible (velocity and angle disagree),
// pressed (the emergency stop). text_of allocates: call it outside of the loop.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/drives/set_points.hpp>

namespace cca::hardware {

struct start_failure {
  safety_rule why = safety_rule::none;
  std::string_view joint{};    // empty: of no joint
  double angle = 0;            // rad, where the joint is; of `rate` its speed in rad/s
  joint_bounds range{0, 0};    // where it may be; of `rate` how fast
  double tolerance = 0;        // rad, or rad/s
  std::string_view missing{};  // of `enabling`: what has not come

  explicit operator bool() const { return why != safety_rule::none; }
};

inline std::string text_of(const start_failure& f) {
  const std::string name(f.joint);
  switch (f.why) {
    case safety_rule::none:
      return "no start was refused";
    case safety_rule::range: {
      char numbers[160];
      std::snprintf(numbers, sizeof numbers,
                    " is at %.3f rad, outside of its range %.3f to %.3f rad by more than %.2f rad: "
                    "turn it back by hand, or correct its offset",
                    f.angle, f.range.lower, f.range.upper, f.tolerance);
      return name + numbers;
    }
    case safety_rule::rate: {
      char numbers[160];
      std::snprintf(
          numbers, sizeof numbers,
          " turns at %.3f rad/s, faster than its axis allows (%.3f to %.3f rad/s): stop its motion, "
          "then start again",
          f.angle, f.range.lower, f.range.upper);
      return name + numbers;
    }
    case safety_rule::implausible:
      return name +
             ": the velocity that its drive reports is not the change of its angle: "
             "check the sign and the range of the velocity";
    case safety_rule::pressed:
      return "the emergency stop is pressed: release it, then start again";
    default:
      return f.joint.empty() ? std::string(f.missing) : name + ": its drive " + std::string(f.missing);
  }
}

}  // namespace cca::hardware
