// What all drives have in common: a drive's type, the command that it gets and the report that it gives.
//
// A drive is a type without state. Its functions are constexpr and pure: they turn frames into numbers and
// back. All numbers are in SI units at the drive's output shaft, behind its own gear: rad, rad/s, N m,
// degrees Celsius.
//
//   D::name, D::limits        its name; per quantity the range that its frames can say
//   D::uses                   which quantities of a command it takes (drive_quantity)
//   D::requests, D::replies   the ids that it listens to, and those that it sends: others, since a frame says
//                             by its id alone whether it is a command or an answer
//   D::traffic                its frames in each cycle (bus_plan.hpp)
//   D::watchdog               what it does by itself when no set point comes
//   D::set_point(command)     the frames of a cycle. A command that is not finite gives none. A number beyond
//                             the range becomes the nearest one, and `cut` says which quantity
//   D::decode(frame, report)  writes what the frame says into the report. False: the frame is not this
//                             drive's, or not well-formed, and the report stays as it was. Of the frames
//                             that answer a set point one reports the position: more than 150 different
//                             ones in 100 beats count as two drives (robot/sender_check.hpp)
//   D::enabling               enables the drive: `next(report)`, once a cycle, gives the frames to send,
//                             until it says `done` or `failed`
//   D::disable()              the frames after which the drive holds nothing
//
// Some drives also have:
//   D::broadcasts             ids that all drives of its kind listen to; several of them on a bus may have
//                             these, and no drive may have one of them among its requests or replies
//   D::cycle_frames           frames that end a cycle, once a bus for all drives with the same ones
//   D::report_period          ns; the drive reports by itself, this often, and not when asked
//   D::torque_period          ns; likewise for its torque, where that has frames of its own. A drive that
//                             states it must report its torque; others may
//   D::occupies               further ids of its own, which no other drive on the bus may have (bus_plan.hpp)
//   D::reply_mark             the first byte of its replies, for drives that may share the id of their
//                             replies
//   D::damp()                 frames after which it only damps, where a set point without stiffness can't say
//                             that
//   D::most_damping(k)        the damping that it can have with the stiffness k, where that is less than the
//                             drive's limit
//   D::is_off(report)         the report says that the drive holds nothing, where that is not the activity
//                             `disabled` or `faulted`
//
// Models: mit.hpp, odrive.hpp, moteus.hpp, robstride.hpp, cia402.hpp. docs/drives.md.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include <cca/hardware/bus/bus_traffic.hpp>
#include <cca/hardware/bus/can_bus.hpp>

namespace cca::hardware {

// Torque of the motor = stiffness (position - q) + damping (velocity - v) + torque, as far as the drive can
// do that: `uses` says what it takes.
struct drive_command {
  double position = 0;   // rad
  double velocity = 0;   // rad/s
  double torque = 0;     // N m
  double stiffness = 0;  // N m/rad
  double damping = 0;    // N m s/rad
};

// A set of quantities: which numbers of a command were cut, or which a report has.
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

// The faults that drives have in common; `code` in the report is the drive's own number.
enum class drive_fault : std::uint8_t {
  none,
  over_current,
  over_voltage,
  under_voltage,
  over_temperature,
  position_sensor,
  phases,
  watchdog,       // no set point in time
  limit,          // of speed, torque or position
  configuration,  // a calibration or a setting is missing
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
  double temperature = untold;  // degrees Celsius; of the power stage, where there are two
  drive_activity activity = drive_activity::unknown;
  drive_fault fault = drive_fault::none;
  std::uint32_t state = 0;  // the drive's own number of its state
  std::uint32_t code = 0;   // and of its fault
  std::uint8_t told = 0;    // drive_quantity: what the last frame reported
  // drive_quantity: numbers at the end of what a frame can say; the true number may be beyond it.
  std::uint8_t at_end = 0;
  std::uint64_t frames = 0;  // frames with a report
  std::uint64_t states = 0;  // those of them that reported the activity
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
  constexpr void clear() { count = 0; }  // leaves the frames as they are: each has 76 bytes
  constexpr bool empty() const { return count == 0; }
  constexpr std::size_t size() const { return count; }
  constexpr const can_frame& operator[](std::size_t i) const { return frames[i]; }
  // For range-for over a returned list: the loop keeps the list alive, as it would not with a span. Where a
  // span is asked for, a list converts to one.
  constexpr const can_frame* begin() const { return frames.data(); }
  constexpr const can_frame* end() const { return frames.data() + count; }
};
using drive_frames = frame_list<8>;

struct set_point_frames {
  drive_frames frames{};
  bool finite = true;    // false: a number that the drive uses is NaN or infinite, and there are no frames
  std::uint8_t cut = 0;  // drive_quantity: which numbers were beyond the drive's range
};

enum class enable_progress : std::uint8_t { going, done, failed };
struct enable_step {
  drive_frames frames{};
  enable_progress progress = enable_progress::going;
};

// What stops a drive that receives nothing: `nanoseconds` after the last set point; 0: a setting in the
// drive.
struct drive_watchdog {
  std::int64_t nanoseconds = 0;
  std::string_view what_it_does;
};

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
