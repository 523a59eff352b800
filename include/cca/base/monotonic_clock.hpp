// The clock that a run follows and a trace measures with: CLOCK_MONOTONIC, in ns. All processes of a machine
// see the same time.
#pragma once

#include <cstdint>
#include <ctime>

#include <cca/base/compiler.hpp>

namespace cca::detail {

struct monotonic_clock {
  static std::int64_t now() {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
  }
  static void sleep_until(std::int64_t time) {
    timespec wake{};
    wake.tv_sec = static_cast<std::time_t>(time / 1'000'000'000);
    wake.tv_nsec = static_cast<long>(time % 1'000'000'000);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) != 0) {}
  }
};

}  // namespace cca::detail
