// What all drives have in common: what one is told, what it tells, and what a drive's type states.
//
// A drive is a type without state. Its functions are constexpr and pure, between frames and numbers in SI
// units at the drive's output shaft, after its own gear: rad, rad/s, N m, degrees Celsius.
//
//   D::name, D::limits      what it is, and what its frames can say, per quantity
//   D::requests, D::replies the ids that it listens to, and those that it sends
//   D::traffic              the frames that a cycle costs (bus_plan.hpp)
//   D::watchdog             what it does by itself when no set-point comes
//   D::set_point(command)   frames of a cycle. Not finite: none at all. Beyond what a frame can say: the
//   nearest, and `cut` says so. D::decode(frame, report)  takes what the frame tells into the report; false:
//   not of this drive, or not well-formed, and nothing is changed D::enabling             the way to where it
//   moves: `next(report)` once a cycle gives the frames to send, until `done` or `failed` D::disable() frames
//   after which it holds nothing any more
//
// What some have besides:
//   D::broadcasts           ids that all drives of its kind listen to, whoever is meant
//   D::cycle_frames         frames that end a cycle on its bus, once for all drives there that state the same
//   D::report_period        ns; it tells where it is by itself, so often, instead of when it is asked
//   D::occupies             ids that are its own though no set-point uses them: on its bus nobody else may
//   have one (bus_plan.hpp) D::reply_mark           what stands in the first byte of all its replies, where
//   drives may reply under one id D::damp()               frames after which it only damps, where a set-point
//   without stiffness can't say so
//
// Models: mit.hpp, odrive.hpp, moteus.hpp, cia402.hpp. docs/drives.md.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include <cca/hardware/bus/can_bus.hpp>
#include <cca/hardware/bus/can_filter.hpp>
#include <cca/hardware/bus/frame_bits.hpp>

namespace cca::hardware {

// torque of the motor = stiffness (position - q) + damping (velocity - v) + torque, where the drive can; a
// drive says by `uses` which of these it takes.
struct drive_command {
  double position = 0;   // rad
  double velocity = 0;   // rad/s
  double torque = 0;     // N m
  double stiffness = 0;  // N m/rad
  double damping = 0;    // N m s/rad
};

// Sets of these: what a command was cut in, what a report told.
enum drive_quantity : std::uint8_t {
  no_quantity = 0,
  of_position = 1,
  of_velocity = 2,
  of_torque = 4,
  of_stiffness = 8,
  of_damping = 16,
  of_temperature = 32,
  of_activity = 64,
};

enum class drive_activity : std::uint8_t { unknown, disabled, enabling, enabled, faulted };

// What is wrong with a drive, as far as drives agree; `code` in the report has the drive's own number.
enum class drive_fault : std::uint8_t {
  none,
  over_current,
  over_voltage,
  under_voltage,
  over_temperature,
  position_sensor,
  phases,
  watchdog,       // no set-point in time
  limit,          // of speed, torque or position
  configuration,  // it lacks a calibration or a setting
  power_stage,
  communication,
  emergency_stop,
  other,
};

constexpr std::string_view name_of(drive_fault f) {
  constexpr std::string_view names[] = {"none",
                                        "over-current",
                                        "over-voltage",
                                        "under-voltage",
                                        "over-temperature",
                                        "position sensor",
                                        "phases",
                                        "watchdog",
                                        "limit",
                                        "configuration",
                                        "power stage",
                                        "communication",
                                        "emergency stop",
                                        "other"};
  return names[static_cast<std::size_t>(f)];
}

struct drive_report {
  static constexpr double untold = std::numeric_limits<double>::quiet_NaN();

  double position = untold;     // rad
  double velocity = untold;     // rad/s
  double torque = untold;       // N m
  double temperature = untold;  // degrees Celsius, of the power stage where there are two
  drive_activity activity = drive_activity::unknown;
  drive_fault fault = drive_fault::none;
  std::uint32_t state = 0;  // the drive's own number of its state
  std::uint32_t code = 0;   // and of its fault
  std::uint8_t told = 0;    // drive_quantity: what the last frame told
  std::uint8_t at_end =
      0;  // drive_quantity: the number is the last that the frame can say, the truth may lie beyond
  std::uint64_t frames = 0;  // how many told something
  std::uint64_t states = 0;  // how many of them told the activity
};

// A few frames, in order.
template <std::size_t Most>
struct frame_list {
  std::array<can_frame, Most> frames{};
  std::size_t count = 0;

  constexpr frame_list() = default;
  template <class... Frames>
    requires(sizeof...(Frames) > 0 && (std::same_as<Frames, can_frame> && ...))
  constexpr frame_list(const Frames&... f) : frames{f...}, count(sizeof...(Frames)) {}

  constexpr void add(const can_frame& f) { frames[count++] = f; }
  constexpr void clear() { count = 0; }  // what lay there stays, unseen: a frame is 80 bytes
  constexpr bool empty() const { return count == 0; }
  constexpr std::size_t size() const { return count; }
  constexpr const can_frame& operator[](std::size_t i) const { return frames[i]; }
  // So that a loop goes over the list itself: a span of what a function has just returned would outlive it.
  // Where a span is asked for, a list becomes one.
  constexpr const can_frame* begin() const { return frames.data(); }
  constexpr const can_frame* end() const { return frames.data() + count; }
};
using drive_frames = frame_list<8>;

struct set_point_frames {
  drive_frames frames{};
  bool finite =
      true;  // false: the command holds NaN or infinity where the drive uses it, and there are no frames
  std::uint8_t cut = 0;  // drive_quantity: what was beyond the drive's range
};

enum class enable_progress : std::uint8_t { going, done, failed };
struct enable_step {
  drive_frames frames{};
  enable_progress progress = enable_progress::going;
};

// What stops a drive that hears nothing: `nanoseconds` after the last set-point, 0 where that is a setting of
// the drive's own.
struct drive_watchdog {
  std::int64_t nanoseconds = 0;
  std::string_view what_it_does;
};

// Frames on the bus: so many in each cycle, or one in each period whatever the cycle.
struct frame_traffic {
  frame_shape shape{};
  int a_cycle = 1;
  std::int64_t period = 0;  // ns; 0: by cycle
};

// The bits of a reply's first byte that say who it is from: `value` in those of `mask`. Without a mask they
// say nothing.
struct drive_mark {
  std::uint8_t value = 0, mask = 0;
  // Whether no byte is taken for both.
  friend constexpr bool apart(drive_mark a, drive_mark b) {
    return ((a.value ^ b.value) & a.mask & b.mask) != 0;
  }
};

// What of these a drive does not state.
template <class D>
inline constexpr std::array<can_filter, 0> broadcasts_of{};
template <class D>
  requires requires { D::broadcasts; }
inline constexpr auto broadcasts_of<D> = D::broadcasts;
template <class D>
inline constexpr std::array<can_filter, 0> occupied_by{};
template <class D>
  requires requires { D::occupies; }
inline constexpr auto occupied_by<D> = D::occupies;
template <class D>
inline constexpr drive_mark reply_mark_of{};
template <class D>
  requires requires { D::reply_mark; }
inline constexpr drive_mark reply_mark_of<D> = D::reply_mark;
template <class D>
inline constexpr std::array<can_frame, 0> cycle_frames_of{};
template <class D>
  requires requires { D::cycle_frames; }
inline constexpr auto cycle_frames_of<D> = D::cycle_frames;
template <class D>
inline constexpr std::int64_t report_period_of = 0;
template <class D>
  requires requires { D::report_period; }
inline constexpr std::int64_t report_period_of<D> = D::report_period;

template <class Type> concept Drive = requires(const drive_command& command,
                                               const can_frame& frame,
                                               drive_report& report,
                                               typename Type::enabling& enabling) {
  { Type::name } -> std::convertible_to<std::string_view>;
  { Type::uses } -> std::convertible_to<std::uint8_t>;
  { Type::watchdog } -> std::convertible_to<drive_watchdog>;
  { std::span<const can_filter>(Type::requests) };
  { std::span<const can_filter>(Type::replies) };
  { std::span<const frame_traffic>(Type::traffic) };
  Type::limits;
  { Type::set_point(command) } noexcept -> std::same_as<set_point_frames>;
  { Type::decode(frame, report) } noexcept -> std::same_as<bool>;
  { Type::disable() } noexcept -> std::same_as<drive_frames>;
  { enabling.next(report) } noexcept -> std::same_as<enable_step>;
};

}  // namespace cca::hardware
