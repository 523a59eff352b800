// Ends a program in order at SIGINT (ctrl-c) and SIGTERM: the signal is noted, the run ends after its beat,
// and the program stops the controller and writes what it has.
//
//   cca::interruption interrupted;                               // notes signals from here on
//   c.run(cca::for_<10>{}, cca::at_wall_clock(), interrupted);   // as `between`: ends the run
//   c.stop();
//   return interrupted ? interrupted.exit_code() : 0;
//
// In a function of your own between two beats: `return !interrupted;`. In a loop: `while (!interrupted)`.
// A further signal is noted as well and kills nothing, so that a robot always stops in order; SIGQUIT
// (ctrl-\) still ends the program at once. The destructor restores the signal handlers that were set before.
// Cost: one load of an atomic number. Not in <cca/cca.hpp>, because <csignal> declares `signal`, a name that
// a program may want for a space. Example: tests/runtime/core/ending.cpp; docs/controller.md.
#pragma once

#include <array>
#include <atomic>
#include <csignal>  // with POSIX's sigaction
#include <cstddef>
#include <cstdint>

namespace cca {
namespace detail {

// Written by the handler, read by any thread.
struct noted_signals {
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<int>::is_always_lock_free);
  std::atomic<std::uint32_t> count{0};
  std::atomic<int> last{0};
};
inline noted_signals noted;

extern "C" inline void cca_note_signal(int number) {
  noted.last.store(number, std::memory_order_relaxed);
  noted.count.fetch_add(1, std::memory_order_release);
}

}  // namespace detail

class interruption {
public:
  interruption() : before(detail::noted.count.load(std::memory_order_acquire)) {
    struct sigaction note{};
    note.sa_handler = detail::cca_note_signal;
    ::sigemptyset(&note.sa_mask);
    for (std::size_t i = 0; i < ends.size(); ++i) ::sigaction(ends[i], &note, &old[i]);
  }
  ~interruption() {
    for (std::size_t i = 0; i < ends.size(); ++i) ::sigaction(ends[i], &old[i], nullptr);
  }
  interruption(const interruption&) = delete;
  interruption& operator=(const interruption&) = delete;

  // Whether a signal has come since this was made.
  explicit operator bool() const noexcept {
    return detail::noted.count.load(std::memory_order_acquire) != before;
  }

  // For `run`, as its `between`: goes on until a signal comes.
  template <class Controller>
  bool operator()(const Controller&) const noexcept {
    return !*this;
  }

  // What a shell expects of a program that a signal has ended: 130 for SIGINT, 143 for SIGTERM. 0: none came.
  int exit_code() const noexcept {
    return *this ? 128 + detail::noted.last.load(std::memory_order_relaxed) : 0;
  }

private:
  static constexpr std::array ends{SIGINT, SIGTERM};
  std::uint32_t before;
  std::array<struct sigaction, ends.size()> old{};
};

}  // namespace cca
