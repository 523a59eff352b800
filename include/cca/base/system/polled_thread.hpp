// A thread whose end is asked for, instead of waited for as in std::thread::join: a thread that must not wait
// does other work between two questions.
#pragma once

#include <pthread.h>
#include <sched.h>

#include <memory>
#include <system_error>
#include <utility>

namespace cca::detail {

// How the calling thread is scheduled, and on which cores, for threads that must not inherit what it has
// later.
class scheduling_of_caller {
public:
  scheduling_of_caller() {
    ::pthread_getschedparam(::pthread_self(), &policy, &parameter);
    ::pthread_getaffinity_np(::pthread_self(), sizeof cores, &cores);
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
    ::pthread_attr_setschedpolicy(&attributes, policy);
    ::pthread_attr_setschedparam(&attributes, &parameter);
    ::pthread_attr_setaffinity_np(&attributes, sizeof cores, &cores);
  }
  ~scheduling_of_caller() { ::pthread_attr_destroy(&attributes); }
  scheduling_of_caller(const scheduling_of_caller&) = delete;
  scheduling_of_caller& operator=(const scheduling_of_caller&) = delete;

  const pthread_attr_t* attribute() const { return &attributes; }

private:
  int policy = 0;
  sched_param parameter{};
  cpu_set_t cores{};
  pthread_attr_t attributes{};
};

class polled_thread {
public:
  polled_thread() = default;
  polled_thread(const polled_thread&) = delete;
  polled_thread& operator=(const polled_thread&) = delete;

  // Once. Throws std::system_error if the system has no more threads. Without `scheduling` it inherits that
  // of the calling thread.
  template <class F>
  void start(F f, const scheduling_of_caller* scheduling = nullptr) {
    auto given = std::make_unique<F>(std::move(f));
    const int error = ::pthread_create(
        &id, scheduling ? scheduling->attribute() : nullptr,
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
