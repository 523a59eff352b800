// Watches a bus and decides whether set points may go out on it.
//
//   link_supervisor<3> link;
//   link.observe(bus.state(), bus.counters());   // each beat, after bus.receive
//   if (link.may_move()) link.sent(bus.send(set_points));
//
// It begins `stopped`. Only `start`, a deliberate call, leads to `running`. It is refused while the bus is
// away or still holds frames, since those would be stale. The caller begins at what the joints measure then,
// not at the last command. From `running` it goes to `safe`, and stays there until the next `start`, when
//   - the bus went off or down, even for less than a beat (the counters show it);
//   - the bus dropped something of `FullCycles` batches in a row because its queue was full: nobody
//     acknowledges, or the bus is overloaded;
//   - another program sends frames that only we may send.
// The first cause is kept, with its beat. `may_speak`: frames that brake, damp or ask can still go out; where
// they can't, only the drive's own watchdog stops it. A passive bus still works: `degraded()` says so, and
// stops nothing.
//
// Cost: some comparisons a beat. Laws and example: tests/runtime/hardware/link.cpp; docs/can_bus.md.
#pragma once

#include <cstdint>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/bus/can_bus.hpp>

namespace cca::hardware {

enum class link_state : std::uint8_t { stopped, running, safe };
enum class link_cause : std::uint8_t { none, bus_off, link_down, queue_full, intruder };
enum class start_refusal : std::uint8_t { none, bus_away, frames_in_flight };

constexpr std::string_view name_of(link_cause c) {
  constexpr std::string_view names[] = {"none", "bus-off", "link down", "transmit queue full",
                                        "another sender of our frames"};
  return names[static_cast<std::size_t>(c)];
}

namespace detail {

template <int FullCycles>
struct no_full_cycles {
  static constexpr void tell(auto& m) {
    m << "cca::hardware::link_supervisor: " << FullCycles
      << " batches in a row may meet a full queue: make this number 1 or more";
  }
};

}  // namespace detail

template <int FullCycles = 3>
class link_supervisor {
  static_assert(cca::detail::holds_or_tells<(FullCycles >= 1), detail::no_full_cycles<FullCycles>>::value);

public:
  // Call it once a beat, after the bus has received: it counts beats.
  constexpr void observe(bus_state seen_state, const bus_counters& counters) {
    ++beats;
    bus = seen_state;
    if (counters.downs != seen.downs || bus == bus_state::down) stop_for(link_cause::link_down);
    else if (counters.bus_offs != seen.bus_offs || bus == bus_state::bus_off) stop_for(link_cause::bus_off);
    else if (counters.intruders != seen.intruders) stop_for(link_cause::intruder);
    seen = counters;
  }

  // The outcome of this beat's set points.
  constexpr void sent(const send_result& result) {
    if (result.outcome == send_outcome::away)
      stop_for(bus == bus_state::bus_off ? link_cause::bus_off : link_cause::link_down);
    full_in_a_row = result.outcome == send_outcome::full ? full_in_a_row + 1 : 0;
    dropped += result.outcome == send_outcome::full;
    if (full_in_a_row >= FullCycles) stop_for(link_cause::queue_full);
  }

  // `in_flight`: the frames that the bus still holds.
  constexpr start_refusal start(std::uint64_t in_flight) {
    if (is_away(bus)) return start_refusal::bus_away;
    if (in_flight != 0) return start_refusal::frames_in_flight;
    now = link_state::running;
    cause = link_cause::none;
    caused_at = -1;
    full_in_a_row = 0;
    return start_refusal::none;
  }
  constexpr void stop() {
    if (now == link_state::running) now = link_state::stopped;
  }

  constexpr link_state state() const { return now; }
  constexpr bool may_move() const { return now == link_state::running; }
  constexpr bool may_speak() const { return !is_away(bus); }
  constexpr bool degraded() const { return bus != bus_state::active; }
  constexpr link_cause first_cause() const { return cause; }
  // Counted by `observe`, from 0; -1: no cause.
  constexpr std::int64_t first_beat() const { return caused_at; }
  // Batches that met a full queue.
  constexpr std::uint64_t dropped_batches() const { return dropped; }

private:
  constexpr void stop_for(link_cause why) {
    if (now != link_state::running) return;
    now = link_state::safe;
    cause = why;
    caused_at = beats;
  }

  link_state now = link_state::stopped;
  link_cause cause = link_cause::none;
  bus_state bus = bus_state::down;
  bus_counters seen{};
  std::int64_t beats = -1, caused_at = -1;
  std::uint64_t dropped = 0;
  int full_in_a_row = 0;
};

}  // namespace cca::hardware
