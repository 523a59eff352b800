// Waiting for another environment without a lock: first at once, then giving way, then asleep. Now and then
// it asks whether the other one, in another process, is gone.
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

// The processes that run the other environments, as the transport sees them.
class peers {
public:
  virtual ~peers() = default;
  // Its process has ended, or is not part of this run.
  virtual bool is_gone(int environment) const = 0;
  // The newest run that others began before they knew of this process: it takes part in later ones only.
  virtual std::int64_t newest_run_before() const { return 0; }
  // Throws `refused` where this process must not run what it runs.
  virtual void check() const {}
};

}  // namespace cca::detail
