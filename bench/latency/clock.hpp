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

// The thread that calls stays on this core; -1: it stays where it is. Costs a comparison where it is there.
inline void stay_on(int core) {
  thread_local int here = -1;
  if (core == here) return;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(core), &one);
  ::sched_setaffinity(0, sizeof one, &one);
  here = core;
}

inline int cores() { return static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)); }

}  // namespace bench
