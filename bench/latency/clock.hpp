// What all forms of the benchmark measure with, and where their threads run.
#pragma once

#include <sched.h>
#include <time.h>
#include <unistd.h>

#include <cstdint>

namespace bench {

inline std::int64_t nanoseconds() {
  timespec t{};
  ::clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
}

// The thread that calls stays on this core; -1: it stays where it is. Costs a comparison if it is there.
inline void stay_on(int core) {
  thread_local int here = -1;
  if (core == here) return;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(core), &one);
  ::sched_setaffinity(0, sizeof one, &one);
  here = core;
}

// The driver is number 0, the reflectors follow. Each has a core of its own if there are enough: if not, the
// system decides, and they take turns.
inline bool have_cores(int fan_out) { return fan_out < ::sysconf(_SC_NPROCESSORS_ONLN); }
inline int core_of(int number, int fan_out) { return have_cores(fan_out) ? number : -1; }

}  // namespace bench
