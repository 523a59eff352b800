// How long and how fast a controller runs. The results never depend on it: time in a beat is virtual.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <string>

#include <cca/base/refused.hpp>

namespace cca {

// Seconds of virtual time: `for_<10>`, `for_<0.5>`.
template <auto Seconds>
struct for_ {
  static constexpr std::int64_t beats(std::int64_t period) {
    return static_cast<std::int64_t>(static_cast<double>(Seconds) * 1e9 / static_cast<double>(period) + 0.5);
  }
};

template <std::int64_t Count>
struct for_beats {
  static constexpr std::int64_t beats(std::int64_t) { return Count; }
};

// Beats known only at run time.
struct for_some_beats {
  std::int64_t count;
  constexpr std::int64_t beats(std::int64_t) const { return count; }
};

struct as_fast_as_possible {
  constexpr void begin() {}
  constexpr void wait(std::int64_t) {}
};

// Beat k begins `factor` times as fast as wall-clock time says: 1 real time, 0.1 ten times slower, 2 twice as
// fast. Wakes at absolute times, so a late beat does not shift those after it.
class at_speed {
public:
  explicit at_speed(double factor) : speed(factor) {
    if (!(factor > 0))
      throw refused("cca::at_speed: " + std::to_string(factor) + " is no pace, expected a number above 0");
  }
  void begin() { clock_gettime(CLOCK_MONOTONIC, &start); }
  void wait(std::int64_t virtual_nanoseconds) const {
    const auto passed =
        static_cast<std::int64_t>(std::min(static_cast<double>(virtual_nanoseconds) / speed, 9e18)) +
        start.tv_nsec;
    timespec wake{};
    wake.tv_sec = start.tv_sec + static_cast<std::time_t>(passed / 1'000'000'000);
    wake.tv_nsec = static_cast<long>(passed % 1'000'000'000);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) != 0) {}
  }

private:
  double speed;
  timespec start{};
};

inline at_speed at_wall_clock() { return at_speed(1); }

}  // namespace cca
