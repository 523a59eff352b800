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
    if (times < 512) return std::this_thread::yield();
    monotonic_clock::sleep_until(monotonic_clock::now() + 20'000);
  }
  // Every few milliseconds.
  bool is_time_to_ask() const { return times > 512 && times % 64 == 0; }

private:
  std::int64_t times = 0;
};

// Of the environments that other processes run: whether the process has ended.
class peers {
public:
  virtual ~peers() = default;
  virtual bool is_gone(int environment) const = 0;
};

}  // namespace cca::detail
