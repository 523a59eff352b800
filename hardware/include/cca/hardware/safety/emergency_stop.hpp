// The emergency stop: collects every trip of the chain and keeps it until an operator starts the robot
// deliberately.
//
//   act   in "wanted" wanted_points, "joints" joint_states; out "safe" set_points: what is wanted, with the
//         motion_mode instead of the rules that it breaks
//
// It trips on what the guards before it have marked, on what the synchronizer reports about a joint, and by
// hand:
//   press()         from now on all drives are damped, and no drive can be enabled. `release()` alone moves
//                   nothing, and only `release()` ends it: a start does not
//   stop_softly()   the drives hold their position and get softer
// These three may be called from any thread.
// If the robot is healthy and only its command is stale, not finite or late, it stops softly. A trip by a
// drive, a sensor or the bus damps at once. The first cause is kept: rule, joint, beat. Motion comes back
// only when the synchronizer's `start` has enabled the drives again and the button is released.
//
// Cost: two comparisons a joint. Example: tests/runtime/drive_chain; docs/hardware.md.
#pragma once

#include <algorithm>
#include <atomic>
#include <string>

#include <cca/base/after_run.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/hardware/drives/set_points.hpp>

namespace cca::hardware {

template <class Joints>
class emergency_stop {
public:
  auto act(in<"wanted", wanted_points<Joints>> wanted, in<"joints", joint_states<Joints>> joints, beat now)
      -> out<"safe", set_points<Joints>> {
    const auto& asked = wanted.vector();
    const auto phase = joint_state::of(joints.vector(), 0).phase;
    const bool is_pressed = read(pressed);
    if (phase == motion_phase::begins && !is_pressed) {
      is = motion_mode::run;
      first = {};
      has_begun = true;
      write(softly, false);
    }
    if (is_pressed) trip(safety_rule::pressed, -1, now);
    if (read(softly)) trip(safety_rule::asked, -1, now);
    for (std::size_t i = 0; i < Joints::count; ++i) {
      trip(joint_state::of(joints.vector(), i).trip, static_cast<int>(i), now);
      trip(wanted_point::of(asked, i).broken(), static_cast<int>(i), now);
    }
    typename set_points<Joints>::vector_type v;
    for (std::size_t i = 0; i < Joints::count; ++i)
      set_point{wanted_point::of(asked, i), is_pressed ? motion_mode::barred : is}.put(v, i);
    return v;
  }

  void press() { write(pressed, true); }
  void release() { write(pressed, false); }
  void stop_softly() { write(softly, true); }

  motion_mode mode() const { return is; }
  safety_event first_cause() const { return first; }
  // The synchronizer says more about what its drives do (robot/stop_cause.hpp).
  cca::cause cause() const {
    if (first.rule == safety_rule::none || !has_begun) return {};
    const std::string joint =
        first.joint < 0 ? "" : std::string(Joints::names[static_cast<std::size_t>(first.joint)]) + ": ";
    return {joint + advice(first.rule), first.beat};
  }

  // A button that is held stays pressed.
  void on_start() {
    is = motion_mode::damped;
    first = {};
    has_begun = false;
    write(softly, false);
  }

private:
  static std::string advice(safety_rule rule) {
    switch (rule) {
      case safety_rule::not_finite:
        return "what it is commanded is not finite: look for the component that computes it";
      case safety_rule::stale:
        return "the data of the set points are older than `greatest_age` of the node `stale`: see what their "
               "writers wait for, or raise it";
      case safety_rule::pressed:
        return "the emergency stop is pressed";
      case safety_rule::asked:
        return "a soft stop was asked for";
      default:
        return std::string(name_of(rule));
    }
  }
  // Atomic access to plain members: so the chain stays a value that can be copied.
  static bool read(bool& flag) { return std::atomic_ref(flag).load(std::memory_order_acquire); }
  static void write(bool& flag, bool value) { std::atomic_ref(flag).store(value, std::memory_order_release); }

  void trip(safety_rule rule, int joint, const beat& now) {
    if (rule == safety_rule::none) return;
    is = std::max(is, leads_to(rule));
    if (first.rule != safety_rule::none) return;
    first = {rule, is_of_joint(rule) ? joint : -1, now.index()};
  }
  // The other rules come for all joints at once, so they name none.
  static constexpr bool is_of_joint(safety_rule rule) {
    return rule != safety_rule::stale && rule != safety_rule::stalled && rule != safety_rule::sensor_board &&
           rule != safety_rule::link;
  }
  static constexpr motion_mode leads_to(safety_rule rule) {
    switch (rule) {
      case safety_rule::not_finite:
      case safety_rule::stale:
      case safety_rule::stalled:
      case safety_rule::asked:
        return motion_mode::soft;
      default:
        return motion_mode::damped;
    }
  }

  motion_mode is = motion_mode::damped;  // until the first start
  safety_event first{};
  bool pressed = false, softly = false, has_begun = false;
};

}  // namespace cca::hardware
