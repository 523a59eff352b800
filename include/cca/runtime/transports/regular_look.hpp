// Calls a function five times a second, in a thread of its own, which takes no signals.
#pragma once

#include <signal.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace cca::detail {

class regular_look {
public:
  explicit regular_look(std::function<void()> look) {
    sigset_t all, before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
      thread = std::thread([this, look = std::move(look)] {
        std::unique_lock lock(mutex);
        while (!ends.wait_for(lock, std::chrono::milliseconds(200), [this] { return is_over; })) look();
      });
    } catch (const std::system_error&) {
      is_over = true;  // no thread: nobody looks
    }
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
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
  std::mutex mutex;
  std::condition_variable ends;
  bool is_over = false;
  std::thread thread;
};

}  // namespace cca::detail
