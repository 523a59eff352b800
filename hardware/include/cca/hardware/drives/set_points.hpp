// What flows between the synchronizer and the guards: what each joint measures, what each drive shall do, and
// why it may not.
//
// The spaces hold a few numbers an axis. They are for the guards and the synchronizer only.
//   joint_states    joint_state of an axis: angle, velocity, torque, trip (a safety_rule; 0: none), phase (a
//                   motion_phase)
//   wanted_points   wanted_point of an axis, until the emergency stop: position, velocity, torque, stiffness,
//                   damping (a drive_command of the joint), and the safety_rule that it breaks
//   set_points      set_point of an axis, from the emergency stop on: the same, and the motion_mode
// The last two are different spaces, so a guard on the wrong side of the emergency stop does not compile
// (space.mismatch). Cost: 5 and 6 doubles an axis. docs/hardware.md.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include <cca/hardware/drives/drive.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/record.hpp>

namespace cca::hardware {

// Why motion stopped, or why a set point was changed.
enum class safety_rule : std::uint8_t {
  none,
  not_finite,    // a set point has a number that is NaN or infinite
  stale,         // a command is too old
  stalled,       // the whole loop stood still
  silent,        // a drive does not answer
  sensor_board,  // the sensor board is silent or reports a fault
  drive_fault,   // a drive reports a fault
  implausible,   // a drive reports a jump, or no longer its velocity
  link,          // the bus went off or down, its queue stays full, or another program sends our frames
  enabling,      // a start failed: a drive could not be enabled, or the sensor board is silent
  pressed,       // the emergency stop
  asked,         // a soft stop
  range,         // this one and the following change a set point and stop nothing
  rate,
  torque,
  stop,
};
constexpr std::string_view name_of(safety_rule r) {
  constexpr std::string_view names[] = {"none",   "not finite",   "stale",          "stalled",
                                        "silent", "sensor board", "fault",          "implausible",
                                        "link",   "enabling",     "emergency stop", "soft stop",
                                        "range",  "rate",         "torque",         "stop of the joint"};
  return names[static_cast<std::size_t>(r)];
}

// The first cause: the rule, the joint (-1: of no joint), the beat (-1: none).
struct safety_event {
  safety_rule rule = safety_rule::none;
  int joint = -1;
  std::int64_t beat = -1;
};

// How far the drives are. `begins`: they are enabled from this beat on, and motion starts where the joints
// are. `resumes`: after beats without set points they go on, from where the joints are.
enum class motion_phase : std::uint8_t { stopped, enabling, begins, resumes, running };
// What the drives may do. `soft`: hold the measured position, softer in each beat. `damped`: only damp.
// `barred`: the emergency stop is pressed, so they only damp and none may be enabled.
enum class motion_mode : std::uint8_t { run, soft, damped, barred };

template <int Numbers>
struct drive_record : record<Numbers> {};
template <int Numbers>
struct wanted_record : record<Numbers> {};

template <class Joints>
struct joint_states : cca::space<drive_record<5>, typename Joints::axes> {};
template <class Joints>
struct wanted_points : cca::space<wanted_record<6>, typename Joints::axes> {};
template <class Joints>
struct set_points : cca::space<drive_record<6>, typename Joints::axes> {};

struct joint_state {
  double angle = drive_report::untold, velocity = 0, torque = 0;
  safety_rule trip = safety_rule::none;
  motion_phase phase = motion_phase::stopped;

  template <class Vector>
  static joint_state of(const Vector& v, std::size_t axis) {
    const auto i = static_cast<Eigen::Index>(5 * axis);
    return {v[i], v[i + 1], v[i + 2], static_cast<safety_rule>(v[i + 3]),
            static_cast<motion_phase>(v[i + 4])};
  }
  template <class Vector>
  void put(Vector& v, std::size_t axis) const {
    const auto i = static_cast<Eigen::Index>(5 * axis);
    v[i] = angle, v[i + 1] = velocity, v[i + 2] = torque;
    v[i + 3] = static_cast<double>(trip), v[i + 4] = static_cast<double>(phase);
  }
  bool known() const { return angle - angle == 0; }
};

template <class Mark>
struct marked_command : drive_command {
  Mark mark{};

  template <class Vector>
  static marked_command of(const Vector& v, std::size_t axis) {
    const auto i = static_cast<Eigen::Index>(6 * axis);
    return {{v[i], v[i + 1], v[i + 2], v[i + 3], v[i + 4]}, static_cast<Mark>(v[i + 5])};
  }
  template <class Vector>
  void put(Vector& v, std::size_t axis) const {
    const auto i = static_cast<Eigen::Index>(6 * axis);
    v[i] = position, v[i + 1] = velocity, v[i + 2] = torque, v[i + 3] = stiffness, v[i + 4] = damping,
    v[i + 5] = static_cast<double>(mark);
  }
  bool finite() const { return (position + velocity + torque + stiffness + damping) * 0 == 0; }

  // The rule that it breaks: the first one is kept.
  void trip(safety_rule r)
    requires std::same_as<Mark, safety_rule>
  {
    if (mark == safety_rule::none) mark = r;
  }
  safety_rule broken() const
    requires std::same_as<Mark, safety_rule>
  {
    return mark;
  }
  motion_mode mode() const
    requires std::same_as<Mark, motion_mode>
  {
    return mark;
  }
};
using wanted_point = marked_command<safety_rule>;
using set_point = marked_command<motion_mode>;

// How often a guard has changed something, and its first change since the start.
struct safety_record {
  safety_event first{};
  std::int64_t count = 0;
  void note(safety_rule rule, int joint, std::int64_t beat) {
    ++count;
    if (first.rule == safety_rule::none) first = {rule, joint, beat};
  }
  // For people; empty: it has changed nothing.
  template <class Joints>
  std::string summary() const {
    if (count == 0) return {};
    return std::to_string(count) +
           " numbers of set points limited; the first: " + std::string(name_of(first.rule)) + " of " +
           std::string(Joints::names[static_cast<std::size_t>(first.joint)]) + ", beat " +
           std::to_string(first.beat);
  }
};

}  // namespace cca::hardware
