// Why the drives of a robot have stopped, for people: the first trip since the start, or why the start was
// refused. A base of drive_synchronizer.hpp.
//
//   cause()   "left_hind_hip: its drive (id 0x2 on bus 1) is silent: no frame for 3 beats: check its ..."
//             The id is the first that the drive listens to. It allocates: between two beats only
//
// Cost: a comparison a joint and beat, until the first trip. Test: tests/runtime/robot_on_drives/causes.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <cca/base/after_run.hpp>
#include <cca/hardware/drives/set_points.hpp>
#include <cca/hardware/robot/start_failure.hpp>
#include <cca/hardware/safety/link_supervisor.hpp>

namespace cca::hardware {

template <class... J>
class stop_cause {
public:
  safety_rule refusal() const { return start.why; }  // why the last start failed
  const start_failure& failure() const { return start; }

  cca::cause cause() const {
    if (start) return {text_of(start), at};
    if (waited_for) return {"the start was not over yet: " + text_of(waited_for), at};
    const std::string joint(names[first.joint]);
    const std::string drive =
        joint + cca::detail::formatted(": its drive (id 0x%x on bus %zu) ",
                                       static_cast<unsigned>(ids[first.joint]), bus_of[first.joint]);
    switch (first.rule) {
      case safety_rule::none:
        return {};
      case safety_rule::silent:
        return {drive + "is silent: no frame for " + std::to_string(first.silent) +
                    " beats: check its supply, its cable and its number",
                at - first.silent + 1};
      case safety_rule::drive_fault:
        if (first.fault == drive_fault::none)
          return {drive + "says that it is disabled: look for its own watchdog or a second controller", at};
        return {drive + "reports a fault: " + std::string(name_of(first.fault)) + ": see its manual", at};
      case safety_rule::implausible:
        return {
            drive +
                "reports what can't be: a jump, a velocity that is not the change of its angle, or no angle, "
                "velocity or state any more: check its encoder, its ranges, and that no other drive has "
                "its number",
            at};
      case safety_rule::link:
        return {"bus " + std::to_string(bus_of[first.joint]) + ", of " + joint + ": " +
                    std::string(name_of(first.link)) + ": check its cable, termination, bit rate and load",
                at};
      case safety_rule::sensor_board:
        if (first.board_status != 0)
          return {"the sensor board reports the status " + std::to_string(first.board_status), at};
        return {"the sensor board is silent: no frame for " + std::to_string(first.silent) +
                    " beats: check its supply and its cable",
                at - first.silent + 1};
      case safety_rule::stalled:
        return {
            cca::detail::formatted("no frame came for %.1f ms, because the loop or the bus stood still: see "
                                   "docs/real_time.md",
                                   1e-6 * static_cast<double>(first.pause)),
            at};
      default:
        return {joint + ": " + std::string(name_of(first.rule)), at};
    }
  }

protected:
  static constexpr std::array<std::size_t, sizeof...(J)> bus_of{J::bus...};

  // What the synchronizer knows when it looks for trips.
  struct seen {
    std::int64_t pause = 0;  // ns, between the frames of two beats
    int quiet_board = 0;     // beats
    int board_status = 0;
  };

  void begin_beat(std::int64_t k) { beat = k; }
  void forget_cause() { first = {}, start = waited_for = {}, at = -1; }

  template <class Monitor, class Links>
  void note_trips(const Monitor& now, const Links& links, const seen& s) {
    if (first.rule != safety_rule::none) return;
    for (std::size_t i = 0; i < sizeof...(J); ++i)
      if (now.trips[i] != safety_rule::none)
        return note(now.trips[i], i, now, links[bus_of[i]].first_cause(), s);
  }
  void note_refused(const start_failure& f) { start = f, at = beat; }
  // A component has made the controller fault while the drives were enabled: what had not come yet.
  void note_fault_in_start(const start_failure& missing) { waited_for = missing, at = beat; }

private:
  static constexpr std::array<std::string_view, sizeof...(J)> names{J::axis::name...};
  static constexpr std::array<std::uint32_t, sizeof...(J)> ids{J::drive::requests[0].id.number...};

  template <class Monitor>
  void note(safety_rule rule, std::size_t i, const Monitor& now, link_cause link, const seen& s) {
    const bool is_of_board = rule == safety_rule::sensor_board;
    first = {rule,
             i,
             is_of_board ? s.quiet_board : now.silent_for(i),
             now.reports[i].fault,
             link,
             s.pause,
             s.board_status};
    at = beat;
  }

  struct {
    safety_rule rule = safety_rule::none;
    std::size_t joint = 0;
    int silent = 0;  // beats
    drive_fault fault = drive_fault::none;
    link_cause link = link_cause::none;
    std::int64_t pause = 0;
    int board_status = 0;
  } first{};
  start_failure start{}, waited_for{};
  std::int64_t beat = -1, at = -1;
};

}  // namespace cca::hardware
