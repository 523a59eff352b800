// Ends a program in order at SIGINT (ctrl-c), SIGTERM and SIGHUP (its terminal is gone): the signal is noted,
// the run ends after its beat, and the program stops the controller and writes what it has.
//
//   cca::interruption interrupted;                               // notes signals from here on
//   c.run(cca::for_<10>{}, cca::at_wall_clock(), interrupted);   // as `between`: ends the run
//   c.stop();
//   return interrupted ? interrupted.exit_code() : 0;
//
// In a function of your own between two beats: `return !interrupted;`. In a loop: `while (!interrupted)`.
//
// A second SIGINT ends a program that can't end in order: if 2 s have passed since the first signal, and
// since stopping last went on (cca/runtime/signals/stop_progress.hpp), it says what is left behind and ends
// at once, with code 130. Before that it only says so: an impatient user does not cut a robot's stop short.
// Further signals of the other kinds are noted. SIGQUIT (ctrl-\) still ends the program at once.
//
// Where SIGHUP is ignored (nohup), it stays ignored. SIGPIPE and SIGXFSZ end nothing: who writes gets an
// error instead. The destructor restores the handlers of the signals that are noted; these two stay harmless,
// because output may still be flushed.
// Cost: one load of an atomic number. Not in <cca/cca.hpp>, because <csignal> declares `signal`, a name that
// a program may want for a space. Example: tests/runtime/core/ending.cpp; docs/controller.md.
#pragma once

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>  // with POSIX's sigaction
#include <cstddef>
#include <cstdint>

#include <cca/base/monotonic_clock.hpp>
#include <cca/runtime/signals/write_if_possible.hpp>
#include <cca/runtime/signals/stop_progress.hpp>

namespace cca {
namespace detail {

// Written by the handler, read by any thread.
struct noted_signals {
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
                std::atomic<std::int64_t>::is_always_lock_free &&
                std::atomic<const char*>::is_always_lock_free);
  static constexpr const char* unknown =
      "\nended at once by a second SIGINT, not in order: it did not go on with stopping for 2 s. Left "
      "behind: "
      "what it drove gets no more commands; what it had not yet written is lost\n";

  std::atomic<std::uint32_t> count{0};
  std::atomic<std::uint32_t> before{0};  // the count when the newest `interruption` was made
  std::atomic<int> last{0};
  std::atomic<const char*> left_behind{unknown};
};
inline noted_signals noted;

inline constexpr std::int64_t longest_standstill = 2'000'000'000;

// All that is called here may be called in a handler.
extern "C" inline void cca_note_signal(int number) {
  const int error = errno;
  const std::int64_t now = monotonic_clock::now();
  const std::uint32_t before = noted.before.load(std::memory_order_relaxed);
  // Before it counts: a second signal, in another thread, sees it.
  if (noted.count.load(std::memory_order_relaxed) == before)
    stop_progress.store(now, std::memory_order_relaxed);
  noted.last.store(number, std::memory_order_relaxed);
  const bool is_first = noted.count.fetch_add(1, std::memory_order_acq_rel) == before;
  if (number == SIGINT && !is_first) {
    if (now - stop_progress.load(std::memory_order_relaxed) >= longest_standstill) {
      write_if_possible(STDERR_FILENO, noted.left_behind.load(std::memory_order_acquire));
      ::_exit(128 + SIGINT);
    }
    write_if_possible(STDERR_FILENO,
                      "\nstopping in order; should that hang for 2 s, ctrl-c ends the program at once\n");
  }
  errno = error;
}

// Unlike SIG_IGN, a handler is not inherited by the programs that this one starts.
extern "C" inline void cca_pass_over_signal(int) {}

}  // namespace detail

class interruption {
public:
  interruption() : before(detail::noted.count.load(std::memory_order_acquire)) {
    detail::noted.before.store(before, std::memory_order_relaxed);
    struct sigaction note{};
    note.sa_handler = detail::cca_note_signal;
    ::sigemptyset(&note.sa_mask);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      ::sigaction(ends[i], nullptr, &old[i]);
      if (ends[i] != SIGHUP || old[i].sa_handler != SIG_IGN) ::sigaction(ends[i], &note, nullptr);
    }
    for (const int number : {SIGPIPE, SIGXFSZ}) pass_over(number);
  }
  ~interruption() {
    for (std::size_t i = 0; i < ends.size(); ++i) ::sigaction(ends[i], &old[i], nullptr);
    detail::noted.left_behind.store(left_before, std::memory_order_release);
  }
  interruption(const interruption&) = delete;
  interruption& operator=(const interruption&) = delete;

  // Whether a signal has come since this was made.
  explicit operator bool() const noexcept {
    return detail::noted.count.load(std::memory_order_acquire) != before;
  }

  // The same. A deployment asks it also while it waits for other processes.
  bool is_over() const noexcept { return static_cast<bool>(*this); }

  // For `run`, as its `between`: goes on until a signal comes.
  template <class Controller>
  bool operator()(const Controller&) const noexcept {
    return !*this;
  }

  // What a shell expects of a program that a signal has ended: 130 for SIGINT, 143 for SIGTERM, 129 for
  // SIGHUP. 0: none came.
  int exit_code() const noexcept {
    return *this ? 128 + detail::noted.last.load(std::memory_order_relaxed) : 0;
  }

  // What a second SIGINT writes if it ends the program from here on: a line of at most 4 KiB, that stays
  // where it is as long as this does.
  void leaves_behind(const char* text) const noexcept {
    detail::noted.left_behind.store(text, std::memory_order_release);
  }

private:
  static void pass_over(int number) {
    struct sigaction now{};
    if (::sigaction(number, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) return;
    now = {};
    now.sa_handler = detail::cca_pass_over_signal;
    now.sa_flags = SA_RESTART;
    ::sigemptyset(&now.sa_mask);
    ::sigaction(number, &now, nullptr);
  }

  static constexpr std::array ends{SIGINT, SIGTERM, SIGHUP};
  std::uint32_t before;
  const char* left_before = detail::noted.left_behind.load(std::memory_order_acquire);
  std::array<struct sigaction, ends.size()> old{};
};

}  // namespace cca
