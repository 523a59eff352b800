// Processes that measure: each side is a child, so that no library's state is shared by a fork.
#pragma once

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <vector>

#include "clock.hpp"
#include "times.hpp"

namespace bench {

// Memory that forked processes share; it begins with zeros.
template <class T>
class shared_array {
public:
  explicit shared_array(std::size_t count) : bytes(count * sizeof(T)) {
    void* const at = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (at == MAP_FAILED) throw std::bad_alloc();
    first = static_cast<T*>(at);
  }
  ~shared_array() { ::munmap(first, bytes); }
  shared_array(const shared_array&) = delete;
  shared_array& operator=(const shared_array&) = delete;
  T* get() const { return first; }

private:
  std::size_t bytes;
  T* first;
};

// f() in a child, which ends after a minute at the latest.
template <class F>
pid_t in_child(F f) {
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child > 0) return child;
  ::alarm(60);
  try {
    f();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    ::_exit(1);
  }
  ::_exit(0);
}

// One round: reflect(number) in a child for each reflector, drive(round) in one more, whose round comes back.
template <class Reflect, class Drive>
round_of_times in_processes(int fan_out, std::size_t round_trips, Reflect reflect, Drive drive) {
  const shared_array<double> found(round_trips + 2);
  std::vector<pid_t> children;
  for (int r = 0; r < fan_out; ++r) children.push_back(in_child([&] { reflect(r); }));
  children.push_back(in_child([&] {
    round_of_times round;
    drive(round);
    if (round.times.size() != round_trips) throw std::runtime_error("round trips are missing");
    std::copy(round.times.begin(), round.times.end(), found.get() + 2);
    found.get()[0] = round.set_up;
    found.get()[1] = static_cast<double>(round.wrong);
  }));
  bool is_well = true;
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    is_well = is_well && status == 0;
  }
  if (!is_well) throw std::runtime_error("a process of the benchmark failed");
  round_of_times round;
  round.times.assign(found.get() + 2, found.get() + 2 + round_trips);
  round.set_up = found.get()[0];
  round.wrong = static_cast<std::int64_t>(found.get()[1]);
  return round;
}

// The driver's part of every raw form: send(number), then take() the numbers that come back.
template <class RoundTrip>
void drive(round_of_times& round, const amount& of, std::int64_t since, RoundTrip round_trip) {
  std::int64_t begun = since;
  round.times.reserve(of.round_trips);
  for (std::size_t n = 1; n <= of.warm_up + of.round_trips; ++n) {
    if (!round_trip(n)) ++round.wrong;
    const std::int64_t time = nanoseconds();
    if (n == 1) round.set_up = 1e-3 * static_cast<double>(time - since);
    if (n > of.warm_up) round.times.push_back(1e-3 * static_cast<double>(time - begun));
    begun = time;
  }
}

}  // namespace bench
