// Calls a function five times a second, in a thread of its own, which takes no signals.
#pragma once

#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace cca::detail {

class regular_look {
public:
  explicit regular_look(std::function<void()> look) {
    const std::uint64_t before = mask(all_signals);
    try {
      thread = std::thread([this, look = std::move(look)] {
        std::unique_lock lock(mutex);
        while (!ends.wait_for(lock, std::chrono::milliseconds(200), [this] { return is_over; })) look();
      });
    } catch (const std::system_error&) {
      is_over = true;  // no thread: nobody looks
    }
    mask(before);
  }
  ~regular_look() {
    {
      const std::lock_guard lock(mutex);
      is_over = true;
    }
    ends.notify_one();
    if (thread.joinable()) thread.join();
  }
  regular_look(const regular_look&) = delete;
  regular_look& operator=(const regular_look&) = delete;

private:
  // The call of the system itself: <signal.h> declares `signal`, a name that a program may want for a space.
  // 32 and 33 are those of the C library.
  static constexpr std::uint64_t all_signals = ~(std::uint64_t{3} << 31);
  static std::uint64_t mask(std::uint64_t signals) {
    constexpr int set = 2;  // SIG_SETMASK
    std::uint64_t before = 0;
    ::syscall(SYS_rt_sigprocmask, set, &signals, &before, sizeof before);
    return before;
  }

  std::mutex mutex;
  std::condition_variable ends;
  bool is_over = false;
  std::thread thread;
};

}  // namespace cca::detail
