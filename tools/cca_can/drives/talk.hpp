// Talking to one drive on a bus, cycle by cycle: send, wait, hear, and find out what went wrong.
//
// A position that wraps goes on here, from the first report on: what `report` says and `set_point` takes has
// no jump, while the frames stay within the drive's range.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

#include <cca/hardware/link_supervisor.hpp>
#include <cca/hardware/position_unwrap.hpp>

#include "any_drive.hpp"
#include "../pace.hpp"

namespace cca_can {

namespace detail {
inline constexpr std::int64_t silence = 100 * ms;  // after which a drive counts as lost
}

// Why it can't go on; empty: all is well.
using trouble = std::string;

inline std::string text_of(const hw::drive_report& r) {
  constexpr const char* activities[] = {"-", "disabled", "enabling", "enabled", "faulted"};
  const auto number = [](double x, const char* unit) {
    char text[32];
    if (x - x == 0) std::snprintf(text, sizeof text, "%8.4f %s", x, unit);
    else std::snprintf(text, sizeof text, "       - %s", unit);
    return std::string(text);
  };
  std::string all = number(r.position, "rad  ") + number(r.velocity, "rad/s  ") + number(r.torque, "N m  ");
  if (r.temperature - r.temperature == 0) all += std::to_string(static_cast<int>(r.temperature)) + " C  ";
  all += activities[static_cast<std::size_t>(r.activity)];
  if (r.fault != hw::drive_fault::none)
    all += ", " + std::string(name_of(r.fault)) + " (code " + std::to_string(r.code) + ")";
  return all;
}

template <hw::CanBus Bus>
class talk {
public:
  talk(Bus& b, any_drive& d, pace& p, std::int64_t cycle_time)
      : bus(b), drive(d), time(p), period(cycle_time), unwrap(d.wraps) {
    next = time.now();
    hear();
    told = shown = {};  // it may be from before
    unwrap.restart();
    link.observe(bus.state(), bus.counters());
  }

  const hw::drive_report& report() const { return shown; }
  // How far that position is from what the drive reports: whole ranges.
  double turned() const { return drive.wraps > 0 ? unwrap.turned() : 0; }
  hw::set_point_frames set_point(hw::drive_command c, double most_torque) const {
    c.position -= turned();
    return drive.set_point(c, most_torque);
  }
  double seconds() const { return static_cast<double>(period) * 1e-9; }

  // For frames that may be lost: the caller checks what came of them.
  trouble cycle(std::span<const hw::can_frame> frames) {
    const hw::send_result sent = bus.send(frames);
    if (link.may_move()) link.sent(sent);
    next = std::max(next + period, time.now());
    time.wait_until(next);
    const std::uint64_t before = told.frames;
    hear();
    if (told.frames != before) heard_at = time.now();
    link.observe(bus.state(), bus.counters());
    return trouble_now();
  }

  // Its report before anything is enabled, asked for only by frames that can't move it.
  trouble ask_position(std::int64_t longest = 1000 * ms) {
    for (const std::int64_t end = time.now() + longest; time.now() < end;) {
      cycle(drive.ask_state());
      if (is_away(bus.state())) return away();
      if (time.end_wanted()) return "ended by ctrl-c";
      if (told.position - told.position == 0) return {};
    }
    return told.frames == 0 ? "it does not answer: is it powered, is this its number, its bus, its bit rate?"
                            : "it answers, but reports no position" +
                                  std::string(drive.clocked ? " (is it operational, and mapped?)" : "");
  }

  // Whether its settings agree with its name, and allow at most this torque (0: any). It only reads.
  trouble ask_settings(double torque, std::int64_t longest = 1000 * ms) {
    for (const std::int64_t end = time.now() + longest; !drive.ask_settings().empty();) {
      if (time.now() >= end)
        return "it does not report its mode of operation (6061h) and its largest torque (6072h)";
      cycle(drive.ask_settings());
      if (is_away(bus.state())) return away();
      if (time.end_wanted()) return "ended by ctrl-c";
    }
    return drive.wrong_setting(torque);
  }

  trouble enable(std::int64_t longest = 3000 * ms) {
    if (const auto refusal = link.start(bus.in_flight()); refusal != hw::start_refusal::none)
      return refusal == hw::start_refusal::bus_away ? away()
                                                    : "the bus still holds frames: nobody takes them";
    drive.begin();
    heard_at = time.now();
    for (const std::int64_t end = time.now() + longest; time.now() < end;) {
      const hw::enable_step s = drive.enable(told);
      if (s.progress == hw::enable_progress::done && told.activity != hw::drive_activity::disabled)
        return is_enabled = true, trouble();
      if (s.progress == hw::enable_progress::failed) return "it refuses to be enabled: " + text_of(told);
      if (trouble t = cycle(s.frames); !t.empty()) return t;
    }
    return "it was not enabled within 3 s: " + text_of(told);
  }

  // Several times, since a frame may be lost; returns whether it answered.
  bool disable() {
    is_enabled = false;
    const std::uint64_t before = told.frames;
    for (int i = 0; i < 5; ++i) cycle(drive.disable());
    return told.frames != before;
  }

private:
  void hear() {
    std::array<hw::received_frame, 32> frames;
    for (std::size_t n = frames.size(); n == frames.size();) {
      n = bus.receive(frames);
      for (std::size_t i = 0; i < n; ++i) {
        drive.hear_setting(frames[i].frame);
        if (drive.decode(frames[i].frame, told) && (told.told & hw::of_position)) unwrap(told.position);
      }
    }
    shown = told;
    shown.position += turned();
  }
  trouble away() const { return "the bus is " + std::string(name_of(bus.state())); }
  trouble trouble_now() const {
    if (is_away(bus.state())) return away();
    if (link.state() == hw::link_state::safe) return "the bus: " + std::string(name_of(link.first_cause()));
    if (link.may_move() && time.now() - heard_at > detail::silence) return "it does not answer any more";
    if (is_enabled && told.fault != hw::drive_fault::none)
      return "it reports a fault: " + std::string(name_of(told.fault)) + " (code " +
             std::to_string(told.code) + ")";
    if (is_enabled && told.activity == hw::drive_activity::disabled) return "it is not enabled any more";
    if (time.end_wanted()) return "ended by ctrl-c";
    return {};
  }

  Bus& bus;
  any_drive& drive;
  pace& time;
  std::int64_t period, next = 0, heard_at = 0;
  hw::drive_report told{}, shown{};
  hw::position_unwrap unwrap;
  hw::link_supervisor<3> link{};
  bool is_enabled = false;
};

}  // namespace cca_can
