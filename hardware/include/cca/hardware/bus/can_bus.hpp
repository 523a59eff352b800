// A CAN bus as a controller uses it: in batches, without waiting, and with its troubles as states.
//
// `send` takes a batch in the order given. What can't be taken now is dropped and counted, never kept: a
// set-point that goes out late is worse than none. `full`: the transmit queue has no room for the rest of the
// batch. `away`: the bus is down or off, nothing is taken. `invalid`: frames that can't be on this bus are
// left out, the others go. That a frame was taken says nothing of who got it: whether a drive is there is
// known from what it answers.
//
// `receive` gives what has come, in order of arrival, at most as many as there is room for, and learns the
// bus's state; call it in each beat. `confirmed` counts own frames that went over the bus; `in_flight()`
// those taken and not yet confirmed.
//
// The laws are in tests/laws/can_bus_laws.hpp; models: memory_bus.hpp, socket_can.hpp. docs/can_bus.md.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <cca/hardware/bus/can_frame.hpp>

namespace cca::hardware {

// What ISO 11898-1 calls error active, warning, passive and bus-off, by the controller's error counters (0,
// 96, 128, 256); down: there is no link at all.
enum class bus_state : std::uint8_t { active, warning, passive, bus_off, down };

constexpr std::string_view name_of(bus_state s) {
  constexpr std::string_view names[] = {"active", "warning", "passive", "bus-off", "down"};
  return names[static_cast<std::size_t>(s)];
}

// Neither takes frames, and what it had taken before is lost.
constexpr bool is_away(bus_state s) { return s == bus_state::bus_off || s == bus_state::down; }

struct received_frame {
  can_frame frame;
  std::int64_t time =
      0;  // ns of arrival, on the bus's clock: the monotonic one, or the virtual time of a bus in memory
};

struct bus_counters {
  std::uint64_t sent = 0;          // taken for sending
  std::uint64_t confirmed = 0;     // of those, went over the bus
  std::uint64_t received = 0;      // from others
  std::uint64_t dropped_full = 0;  // not taken: transmit queue full
  std::uint64_t dropped_away = 0;  // not taken, or lost in the queue: bus off or down, given up
  std::uint64_t invalid = 0;       // not taken: no frame of this bus
  std::uint64_t lost = 0;          // arrived, and lost since the receive queue was full
  std::uint64_t intruders = 0;     // frames of others under ids that are ours alone to send

  std::uint64_t errors = 0;            // error frames
  std::uint64_t arbitration_lost = 0;  // of a controller that doesn't repeat by itself
  std::uint64_t protocol_errors = 0;   // of bits, forms, stuffing, checksums
  std::uint64_t not_acknowledged = 0;  // nobody else is there
  std::uint64_t overflows = 0;         // of the controller's own buffers
  std::uint64_t timeouts = 0;          // the driver gave a frame up
  std::uint64_t bus_offs = 0, restarts = 0, downs = 0, ups = 0;
  std::uint8_t transmit_errors = 0, receive_errors = 0;  // the controller's counters, as last told

  // How often the bus went away. Who compares it from beat to beat misses none, however short.
  constexpr std::uint64_t interruptions() const { return bus_offs + downs; }
};

enum class send_outcome : std::uint8_t { sent, full, away, invalid };

struct send_result {
  std::size_t sent = 0;
  send_outcome outcome = send_outcome::sent;  // `sent`: all of them; else why not, the first reason
};

template <class Bus> concept CanBus =
    requires(Bus& bus, const Bus& seen, std::span<const can_frame> out, std::span<received_frame> in) {
      { bus.send(out) } noexcept -> std::same_as<send_result>;
      { bus.receive(in) } noexcept -> std::same_as<std::size_t>;
      { seen.state() } noexcept -> std::same_as<bus_state>;
      { seen.counters() } noexcept -> std::convertible_to<bus_counters>;
      { seen.in_flight() } noexcept -> std::convertible_to<std::uint64_t>;
    };

}  // namespace cca::hardware
