// Waiting for another environment without a lock: first at once, then giving way, then asleep. Now and then
// who waits asks whether the other one, in another process, is gone.
#pragma once

#include <cstdint>
#include <thread>

#include <cca/runtime/pace.hpp>

namespace cca::detail {

class patience {
public:
  void wait() {
    if (++times < 64) return;
    if (times < longest_awake) return give_way();
    monotonic_clock::sleep_until(monotonic_clock::now() + 20'000);
  }
  // Every few milliseconds.
  bool is_time_to_ask() const { return times > longest_awake && times % 64 == 0; }

private:
  static constexpr std::int64_t longest_awake = 512;

  // Who gives way on a busy machine comes back after milliseconds; who sleeps is woken at once.
  void give_way() {
    const std::int64_t before = monotonic_clock::now();
    std::this_thread::yield();
    if (monotonic_clock::now() - before > 100'000) times = longest_awake;
  }

  std::int64_t times = 0;
};

}  // namespace cca::detail
