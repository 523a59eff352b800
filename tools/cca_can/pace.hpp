// Time for a command: the machine's clock, or in tests that of a bus in memory.
#pragma once

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace cca_can {

class pace {
public:
  virtual ~pace() = default;
  virtual std::int64_t now() const = 0;       // ns, monotonic
  virtual std::int64_t calendar() const = 0;  // ns since 1970, at the same time
  // Waits in any case: what has been enabled must still be disabled.
  virtual void wait_until(std::int64_t when) = 0;
  virtual bool end_wanted() const = 0;  // ctrl-c, or what else ends a command
};

namespace detail {
inline volatile std::sig_atomic_t signal_came = 0;
}

// Ctrl-c, SIGTERM and a closed terminal ask for the end; the command then ends by itself. So do a reader of
// its output that is gone, as of `cca-can jog ... | head`, and a file that may not grow any more: what has
// been enabled is disabled.
class wall_pace : public pace {
public:
  wall_pace() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) {
      struct sigaction action = {};
      action.sa_handler = [](int) { detail::signal_came = 1; };
      sigaction(signal, &action, nullptr);
    }
  }
  std::int64_t now() const override { return read(CLOCK_MONOTONIC); }
  std::int64_t calendar() const override { return read(CLOCK_REALTIME); }
  void wait_until(std::int64_t when) override {
    const timespec t{when / 1'000'000'000, when % 1'000'000'000};
    while (now() < when) clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr);
  }
  bool end_wanted() const override { return detail::signal_came != 0; }

private:
  static std::int64_t read(clockid_t clock) {
    timespec t{};
    clock_gettime(clock, &t);
    return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
  }
};

inline constexpr std::int64_t ms = 1'000'000;

// Waits until then; false: the end was asked for meanwhile.
inline bool wait_until_end_wanted(pace& time, std::int64_t when) {
  while (!time.end_wanted() && time.now() < when) time.wait_until(std::min(when, time.now() + 20 * ms));
  return !time.end_wanted();
}

}  // namespace cca_can
