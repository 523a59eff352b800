// A thread whose end is asked for, instead of waited for as in std::thread::join: a thread that must not wait
// does other work between two questions.
#pragma once

#include <pthread.h>

#include <memory>
#include <system_error>
#include <utility>

namespace cca::detail {

class polled_thread {
public:
  polled_thread() = default;
  polled_thread(const polled_thread&) = delete;
  polled_thread& operator=(const polled_thread&) = delete;

  // Once. Throws std::system_error if the system has no more threads.
  template <class F>
  void start(F f) {
    auto given = std::make_unique<F>(std::move(f));
    const int error = ::pthread_create(
        &id, nullptr,
        [](void* work) -> void* {
          const std::unique_ptr<F> own(static_cast<F*>(work));
          (*own)();
          return nullptr;
        },
        given.get());
    if (error != 0) throw std::system_error(error, std::generic_category());
    given.release();
    runs = true;
  }

  // It must have ended before this is destroyed. True too if it was never started. Never waits.
  bool has_ended() noexcept {
    if (runs && ::pthread_tryjoin_np(id, nullptr) == 0) runs = false;
    return !runs;
  }

private:
  pthread_t id{};
  bool runs = false;
};

}  // namespace cca::detail
