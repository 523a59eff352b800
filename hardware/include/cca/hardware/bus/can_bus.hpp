// A CAN bus as a controller uses it: in batches and without waiting. Errors of the bus are states.
//
//   send(frames)   takes a batch in the given order. Frames that can't be sent now are dropped and counted,
//                  never kept: a late set point is worse than none. `full`: the transmit queue has no room
//                  for the rest of the batch. `away`: the bus is down or off, and nothing is taken.
//                  `invalid`: some frames can't be on this bus; the others are sent. `sent` does not say that
//                  another node received the frame: only a drive's answer shows that the drive is there.
//   receive(into)  gives the frames that have come, in order of arrival, as many as there is room for, and
//                  learns the bus's state. Call it in each beat.
//   state()        the state as of the last `receive`
//   counters()     since the bus was opened; `confirmed` counts own frames that went over the bus
//   in_flight()    frames taken and not yet confirmed
//
// Laws: tests/laws/can_bus_laws.hpp. Models: memory_bus.hpp, socket_can.hpp. docs/can_bus.md.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <cca/hardware/bus/can_frame.hpp>

namespace cca::hardware {

// The first four are error active, warning, passive and bus-off of ISO 11898-1: error counters from 0, 96,
// 128, 256 on. `down`: there is no link.
enum class bus_state : std::uint8_t { active, warning, passive, bus_off, down };

constexpr std::string_view name_of(bus_state s) {
  constexpr std::string_view names[] = {"active", "warning", "passive", "bus-off", "down"};
  return names[static_cast<std::size_t>(s)];
}

// In these states the bus takes no frames and has lost those in its queue.
constexpr bool is_away(bus_state s) { return s == bus_state::bus_off || s == bus_state::down; }

struct received_frame {
  can_frame frame;
  std::int64_t time = 0;  // ns of arrival on the bus's clock: monotonic, or virtual time of a bus in memory
};

struct bus_counters {
  std::uint64_t sent = 0;          // taken for sending
  std::uint64_t confirmed = 0;     // of those, went over the bus
  std::uint64_t received = 0;      // from others
  std::uint64_t dropped_full = 0;  // not taken: the transmit queue was full
  std::uint64_t dropped_away = 0;  // not taken, or lost in the queue: bus off or down, or given up
  std::uint64_t invalid = 0;       // not taken: no frame of this bus
  std::uint64_t lost = 0;          // arrived while the receive queue was full
  std::uint64_t intruders = 0;     // sent by others under ids that only we may send

  std::uint64_t errors = 0;            // error frames
  std::uint64_t arbitration_lost = 0;  // by a controller that doesn't try again
  std::uint64_t protocol_errors = 0;   // of bits, forms, stuffing, checksums
  std::uint64_t not_acknowledged = 0;  // no other node is on the bus
  std::uint64_t overflows = 0;         // of the controller's own buffers
  std::uint64_t timeouts = 0;          // the driver gave up a frame
  std::uint64_t bus_offs = 0, restarts = 0, downs = 0, ups = 0;
  std::uint8_t transmit_errors = 0, receive_errors = 0;  // the controller's counters, as last reported

  // How often the bus went away. Comparing it in each beat shows every interruption, however short.
  constexpr std::uint64_t interruptions() const { return bus_offs + downs; }
};

enum class send_outcome : std::uint8_t { sent, full, away, invalid };

struct send_result {
  std::size_t sent = 0;
  send_outcome outcome = send_outcome::sent;  // `sent`: all frames; else the first reason why not
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
