// How long the cycles of free-running components take, for tests in a wall-clock run.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>

namespace free_cycles {

inline std::atomic<std::int64_t> cycle_in_us{0};
inline std::atomic<bool> cycle_hangs{false};

// What a component calls in its cycle.
inline void take_time() {
  if (cycle_in_us > 0) std::this_thread::sleep_for(std::chrono::microseconds(cycle_in_us.load()));
  while (cycle_hangs) std::this_thread::sleep_for(std::chrono::microseconds(100));
}

// While it lives cycles take so long; then none takes any.
struct cycles_of {
  explicit cycles_of(std::int64_t microseconds) { cycle_in_us = microseconds; }
  ~cycles_of() { cycle_in_us = 0, cycle_hangs = false; }
  cycles_of(const cycles_of&) = delete;
  cycles_of& operator=(const cycles_of&) = delete;
};

}  // namespace free_cycles
