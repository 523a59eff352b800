// Waiting for another thread without a lock: first at once, then giving way, then asleep.
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

private:
  int times = 0;
};

}  // namespace cca::detail
