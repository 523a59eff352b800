// A program that is ending says that it goes on, so that a second SIGINT does not end it in the middle
// (cca/runtime/interruption.hpp).
//
//   while (arm.moves_to_its_rest()) c.step(), cca::stopping_goes_on();
//
// cca::hardware::shut_down does so itself; a stop of your own needs it only if it takes longer than 2 s. Any
// thread may call it, at any time. Cost: one reading of the clock.
#pragma once

#include <atomic>
#include <cstdint>

#include <cca/base/monotonic_clock.hpp>

namespace cca {
namespace detail {

// When it last went on (ns).
inline std::atomic<std::int64_t> stop_progress{0};

}  // namespace detail

inline void stopping_goes_on() noexcept {
  detail::stop_progress.store(detail::monotonic_clock::now(), std::memory_order_relaxed);
}

}  // namespace cca
