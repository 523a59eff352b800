// A CAN bus in memory, for tests and for machines without CAN: several ends on one wire, in virtual time. A
// script makes it fail.
//
//   cca::hardware::memory_bus<2> wire({.rates = {1'000'000}, .seed = 7, .script = faults});
//   auto robot = wire.end(0), drives = wire.end(1);    // each is a CanBus
//   robot.send(frames); wire.advance(now);             // simulates everything up to `now`, in nanoseconds
//
// One frame at a time is on the wire: the one with the lowest id first. It takes the longest time that such a
// frame can take (frame_bits.hpp), and goes to all other ends. If there is no other end, it is not
// acknowledged and sent again until the transmit queue is full. An end that goes off or down loses its queue.
// The same calls, seed and script give the same result, bit for bit. A copy is a snapshot; ends are handles,
// so take new ones from it.
//
// `Depth` is the length of an end's transmit queue, `Arrivals` of its receive queue; frames beyond are lost
// and counted. Cost: nothing is allocated. The script is not copied: it must live as long as the bus.
// Laws: tests/laws/can_bus_laws.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/bus/bus_fault.hpp>
#include <cca/hardware/bus/can_bus.hpp>
#include <cca/hardware/bus/fault_dice.hpp>
#include <cca/hardware/bus/frame_bits.hpp>
#include <cca/hardware/bus/ring.hpp>

namespace cca::hardware {

struct memory_bus_options {
  bit_rates rates{};
  bool one_shot = false;  // each frame is tried once, as after `ip link ... one-shot on`
  std::uint64_t seed = 0;
  std::span<const bus_fault> script{};
};

namespace detail {

template <std::size_t Ends, std::size_t Depth, std::size_t Arrivals>
struct bus_without_room {
  static constexpr void tell(auto& m) {
    m << "cca::hardware::memory_bus: " << static_cast<std::int64_t>(Ends) << " ends with queues of "
      << static_cast<std::int64_t>(Depth) << " and " << static_cast<std::int64_t>(Arrivals)
      << " places are no bus: make these numbers at least 2, 1 and 1";
  }
};

}  // namespace detail

template <std::size_t Ends = 2, std::size_t Depth = 16, std::size_t Arrivals = 256>
class memory_bus {
  static_assert(cca::detail::holds_or_tells<(Ends >= 2 && Depth >= 1 && Arrivals >= 1),
                                            detail::bus_without_room<Ends, Depth, Arrivals>>::value);

public:
  class end_type {
  public:
    end_type(memory_bus& b, std::size_t i) : bus(&b), index(i) {}
    send_result send(std::span<const can_frame> frames) noexcept { return bus->accept(index, frames); }
    std::size_t receive(std::span<received_frame> into) noexcept { return bus->hand_over(index, into); }
    bus_state state() const noexcept { return bus->stations[index].state; }
    const bus_counters& counters() const noexcept { return bus->stations[index].counters; }
    std::uint64_t in_flight() const noexcept { return bus->stations[index].out.size(); }

  private:
    memory_bus* bus;
    std::size_t index;
  };

  explicit memory_bus(memory_bus_options o = {}) : options(o), dice(o.seed) { apply_script(); }

  end_type end(std::size_t index) { return {*this, index}; }
  std::int64_t time() const { return clock; }

  // From now on these faults happen, and no others.
  void follow(std::span<const bus_fault> script) {
    options.script = script;
    apply_script();
  }

  // Simulates everything up to `now`. An earlier `now` changes nothing.
  void advance(std::int64_t now) {
    while (clock <= now) {
      begin_sending();
      const std::int64_t next = next_event();
      if (next > now) break;
      clock = next;
      apply_script();
      if (sender != nobody && clock >= sent_at) finish_sending();
      deliver_delayed();
    }
    clock = std::max(clock, now);
  }

private:
  static constexpr std::size_t nobody = Ends;
  static constexpr std::int64_t no_time = std::numeric_limits<std::int64_t>::max();

  struct station {
    bus_state state = bus_state::active, scripted = bus_state::active;
    bus_counters counters{};
    detail::ring<can_frame, Depth> out{};
    detail::ring<received_frame, Arrivals> in{};
  };
  struct delayed {
    can_frame frame{};
    std::size_t to = nobody;  // nobody: this place is free
    std::int64_t due = 0;
    bool until_next = false;  // reordered: released by the next frame
  };

  send_result accept(std::size_t index, std::span<const can_frame> frames) {
    station& s = stations[index];
    send_result result{};
    const auto refuse = [&](send_outcome why, std::uint64_t& count, std::size_t n) {
      count += n;
      if (result.outcome == send_outcome::sent) result.outcome = why;
    };
    if (is_away(s.state)) {
      if (!frames.empty()) refuse(send_outcome::away, s.counters.dropped_away, frames.size());
      return result;
    }
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (!frames[i].valid()) {
        refuse(send_outcome::invalid, s.counters.invalid, 1);
      } else if (!s.out.push(frames[i])) {
        refuse(send_outcome::full, s.counters.dropped_full, frames.size() - i);
        break;
      } else {
        ++result.sent;
      }
    }
    s.counters.sent += result.sent;
    return result;
  }

  std::size_t hand_over(std::size_t index, std::span<received_frame> into) {
    station& s = stations[index];
    std::size_t n = 0;
    for (; n < into.size() && !s.in.empty(); ++n, s.in.pop()) into[n] = s.in.front();
    return n;
  }

  bool is_on(std::size_t index) const { return !is_away(stations[index].state); }

  void begin_sending() {
    if (sender != nobody) return;
    for (std::size_t i = 0; i < Ends; ++i) {
      if (!is_on(i) || stations[i].out.empty()) continue;
      if (sender == nobody || goes_before(stations[i].out.front().id, stations[sender].out.front().id))
        sender = i;
    }
    if (sender == nobody) return;
    sent_at = clock + options.rates.nanoseconds(worst_case(shape_of(stations[sender].out.front())));
    for (std::size_t i = 0; options.one_shot && i < Ends; ++i) {
      station& s = stations[i];
      if (i == sender || !is_on(i) || s.out.empty()) continue;
      ++s.counters.arbitration_lost;
      give_up(s);
    }
  }
  void give_up(station& s) {
    ++s.counters.dropped_away;
    s.out.pop();
  }

  void finish_sending() {
    station& s = stations[sender];
    const std::size_t from = sender;
    sender = nobody;
    bool acknowledged = false;
    for (std::size_t i = 0; i < Ends; ++i) acknowledged |= i != from && is_on(i);
    if (!acknowledged) {  // ISO 11898-1: the error counter grows by 8 a try, and no further than passive
      ++s.counters.not_acknowledged;
      s.counters.transmit_errors = static_cast<std::uint8_t>(std::min(s.counters.transmit_errors + 8, 128));
      if (options.one_shot) give_up(s);
      update(s);
      return;
    }
    if (s.counters.transmit_errors > 0) --s.counters.transmit_errors;
    update(s);
    ++s.counters.confirmed;
    const can_frame frame = s.out.front();
    s.out.pop();
    for (std::size_t i = 0; i < Ends; ++i)
      if (i != from && is_on(i)) deliver(frame, i);
  }

  // To one end, with the faults of the script.
  void deliver(can_frame frame, std::size_t to) {
    std::int64_t wait = 0;
    bool twice = false, overtaken = false;
    for (const bus_fault& f : options.script) {
      if (!f.concerns_end(to) || !f.now(clock) || !f.concerns(frame.id)) continue;
      if (f.what > bus_trouble::corrupt || !dice.hits(f.chance)) continue;
      switch (f.what) {
        case bus_trouble::lose:
          return;
        case bus_trouble::delay:
          wait = std::max(wait, f.delay);
          break;
        case bus_trouble::duplicate:
          twice = true;
          break;
        case bus_trouble::reorder:
          overtaken = true, wait = std::max(wait, f.delay);
          break;
        case bus_trouble::corrupt:
          dice.damage(frame);
          break;
        default:
          break;
      }
    }
    for (int copies = twice ? 2 : 1; copies > 0; --copies) {
      if (wait > 0 && postpone({frame, to, clock + wait, overtaken})) continue;
      arrive(frame, to);
    }
    if (!overtaken)
      for (delayed& d : waiting)
        if (d.to == to && d.until_next) release(d);
  }

  bool postpone(const delayed& d) {
    for (delayed& place : waiting)
      if (place.to == nobody) return place = d, true;
    return false;
  }
  void release(delayed& d) {
    const std::size_t to = d.to;
    d.to = nobody;
    if (is_on(to)) arrive(d.frame, to);
  }
  void deliver_delayed() {
    for (;;) {
      delayed* first = nullptr;
      for (delayed& d : waiting)
        if (d.to != nobody && d.due <= clock && (!first || d.due < first->due)) first = &d;
      if (!first) return;
      release(*first);
    }
  }
  void arrive(const can_frame& frame, std::size_t to) {
    station& s = stations[to];
    if (s.in.push({frame, clock})) ++s.counters.received;
    else ++s.counters.lost;
  }

  void apply_script() {
    for (std::size_t i = 0; i < Ends; ++i) {
      bus_state wanted = bus_state::active;
      for (const bus_fault& f : options.script)
        if (f.what > bus_trouble::corrupt && f.concerns_end(i) && f.now(clock))
          wanted = std::max(wanted, static_cast<bus_state>(static_cast<int>(f.what) -
                                                           static_cast<int>(bus_trouble::corrupt)));
      station& s = stations[i];
      if (wanted == s.scripted) continue;
      s.scripted = wanted;
      update(s);
      if (is_away(s.state) && sender == i) sender = nobody;
    }
  }

  // The worse of the script's state and the error counter's.
  void update(station& s) {
    const bus_state counted = s.counters.transmit_errors >= 128  ? bus_state::passive
                              : s.counters.transmit_errors >= 96 ? bus_state::warning
                                                                 : bus_state::active;
    const bus_state before = s.state;
    s.state = std::max(s.scripted, counted);
    if (s.state == before) return;
    if (is_away(before) && !is_away(s.state))
      ++(before == bus_state::down ? s.counters.ups : s.counters.restarts);
    if (s.state == bus_state::down) ++s.counters.downs;
    if (s.state == bus_state::bus_off) ++s.counters.bus_offs;
    if (!is_away(s.state)) return;
    s.counters.transmit_errors = 0;
    s.counters.dropped_away += s.out.size();
    s.out.clear();
  }

  std::int64_t next_event() const {
    std::int64_t next = sender != nobody ? sent_at : no_time;
    for (const delayed& d : waiting)
      if (d.to != nobody) next = std::min(next, d.due);
    for (const bus_fault& f : options.script) {
      if (f.from > clock) next = std::min(next, f.from);
      if (f.until > clock) next = std::min(next, f.until);
    }
    return std::max(next, clock);
  }

  memory_bus_options options;
  std::array<station, Ends> stations{};
  std::array<delayed, 64> waiting{};
  std::size_t sender = nobody;
  std::int64_t clock = 0, sent_at = 0;
  detail::fault_dice dice;
};

}  // namespace cca::hardware
