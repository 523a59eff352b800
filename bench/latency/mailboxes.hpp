// Raw: a bare atomic ping-pong between threads, or between processes over shared memory.
//
// Each writer has a mailbox: a number and, on the same cache line, the message. A reader takes the message
// out of the mailbox into memory of its own, and answers from there, as with `recv` and `send`.
#pragma once

#include <atomic>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include "processes.hpp"

namespace bench {

template <int Words>
struct mailbox {
  alignas(64) std::atomic<std::uint64_t> number{0};
  double message[Words];

  void put(const double* from, std::uint64_t n) {
    std::memcpy(message, from, sizeof message);
    number.store(n, std::memory_order_release);
  }
  // Looks again at once; where there are too few cores, it gives way after a while.
  void take(double* to, std::uint64_t n, bool gives_way) const {
    for (int looks = 0; number.load(std::memory_order_acquire) != n;)
      if (gives_way && ++looks > 64) std::this_thread::yield();
    std::memcpy(to, message, sizeof message);
  }
};

// The driver's mailbox is the first.
template <int Words, int FanOut>
struct ping_pong {
  const amount& of;
  bool gives_way = !have_cores(FanOut);

  void reflect(mailbox<Words>* all, int reflector) const {
    stay_on(core_of(reflector + 1, FanOut));
    const auto own = std::make_unique<double[]>(Words);
    for (std::uint64_t n = 1; n <= of.warm_up + of.round_trips; ++n) {
      all[0].take(own.get(), n, gives_way);
      all[reflector + 1].put(own.get(), n);
    }
  }
  void drive(mailbox<Words>* all, round_of_times& round, std::int64_t since) const {
    stay_on(core_of(0, FanOut));
    const auto own = std::make_unique<double[]>(Words);
    bench::drive(round, of, since, [&](std::uint64_t n) {
      const auto number = static_cast<double>(n);
      own[0] = number;
      own[Words - 1] = number;
      all[0].put(own.get(), n);
      bool is_right = true;
      for (int r = 1; r <= FanOut; ++r) {
        all[r].take(own.get(), n, gives_way);
        is_right = is_right && own[0] == number && own[Words - 1] == number;
      }
      return is_right;
    });
  }
};

template <int Words, int FanOut>
round_of_times raw_threads(const amount& of) {
  const std::int64_t since = nanoseconds();
  const auto all = std::make_unique<mailbox<Words>[]>(FanOut + 1);
  const ping_pong<Words, FanOut> game{of};
  round_of_times round;
  std::vector<std::thread> threads;
  for (int r = 0; r < FanOut; ++r) threads.emplace_back([&, r] { game.reflect(all.get(), r); });
  game.drive(all.get(), round, since);
  for (auto& thread : threads) thread.join();
  return round;
}

template <int Words, int FanOut>
round_of_times raw_shared_memory(const amount& of) {
  const std::int64_t since = nanoseconds();
  const shared_array<mailbox<Words>> all(FanOut + 1);
  const ping_pong<Words, FanOut> game{of};
  return in_processes(
      FanOut, of.round_trips, [&](int r) { game.reflect(all.get(), r); },
      [&](round_of_times& round) { game.drive(all.get(), round, since); });
}

}  // namespace bench
