#pragma once
// Two processes in lock step: a beat of one, then a beat of the other, in virtual time, independent of the
// speed of the machine and of pauses.
//
// Each process waits until all frames of the other's beat have come. After `patience` it goes on without
// them, and a millisecond of virtual time has passed: so the watchdogs of the drives notice a dead
// controller.
#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <string_view>

#include <poll.h>

#include <cca/hardware/bus/ring.hpp>
#include <cca/hardware/socket_can.hpp>

namespace hil {

// SocketCAN. In lock step, frames wait for the beat and get its time.
class paced_can {
public:
  paced_can(std::string_view name, const cca::hardware::socket_can_options& o, bool in_lock_step)
      : bus(name, o), kept(in_lock_step) {}

  cca::hardware::send_result send(std::span<const cca::hardware::can_frame> frames) noexcept {
    return bus.send(frames);
  }
  std::size_t receive(std::span<cca::hardware::received_frame> into) noexcept {
    if (!kept) return bus.receive(into);
    std::size_t n = 0;
    for (; n < into.size() && !waiting.empty(); ++n, waiting.pop()) into[n] = waiting.front();
    return n;
  }
  cca::hardware::bus_state state() const noexcept { return bus.state(); }
  const cca::hardware::bus_counters& counters() const noexcept { return bus.counters(); }
  std::uint64_t in_flight() const noexcept { return bus.in_flight(); }

  void fetch(std::int64_t now) {
    std::array<cca::hardware::received_frame, 1> one;
    while (!waiting.full() && bus.receive(one) == 1) waiting.push({one[0].frame, now});
  }
  std::size_t frames() const { return waiting.size(); }
  int file() const { return bus.file(); }

private:
  cca::hardware::socket_can bus;
  bool kept;
  cca::hardware::detail::ring<cca::hardware::received_frame, 64> waiting{};
};

inline constexpr std::chrono::milliseconds patience(500);

// Waits until each bus has as many frames as it must have, or until patience is over.
template <std::size_t Buses>
void wait_for(std::span<paced_can, Buses> all,
              const std::array<std::size_t, Buses>& enough,
              std::int64_t now) {
  const auto end = std::chrono::steady_clock::now() + patience;
  for (;;) {
    std::array<pollfd, Buses> files;
    bool complete = true;
    for (std::size_t b = 0; b < Buses; ++b) {
      all[b].fetch(now);
      const bool waits = all[b].frames() < enough[b];
      complete = complete && !waits;
      files[b] = {waits ? all[b].file() : -1, POLLIN, 0};
    }
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
    if (complete || left <= 0) return;
    ::poll(files.data(), files.size(), static_cast<int>(left));
  }
}

}  // namespace hil
