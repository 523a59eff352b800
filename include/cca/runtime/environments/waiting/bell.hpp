// How a thread that sleeps is told that there is news: a counter that it waits for. Ringing never waits, and
// is one addition unless somebody sleeps (then a call of the system, some microseconds).
#pragma once

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <cstdint>
#include <ctime>

namespace cca::detail {

class bell {
public:
  void ring() noexcept {
    rung.fetch_add(1, std::memory_order_seq_cst);
    if (sleepers.load(std::memory_order_seq_cst) > 0)
      ::syscall(SYS_futex, &rung, FUTEX_WAKE_PRIVATE, INT_MAX, nullptr, nullptr, 0);
  }

  // Read this, look whether there is news, and then wait for the next: nothing is missed.
  std::uint32_t count() const noexcept { return rung.load(std::memory_order_seq_cst); }

  // Until it has rung since `before` was counted, but not for long (ns).
  void wait(std::uint32_t before, std::int64_t longest) noexcept {
    const timespec until{longest / 1'000'000'000, longest % 1'000'000'000};
    sleepers.fetch_add(1, std::memory_order_seq_cst);
    ::syscall(SYS_futex, &rung, FUTEX_WAIT_PRIVATE, before, &until, nullptr, 0);
    sleepers.fetch_sub(1, std::memory_order_seq_cst);
  }

private:
  std::atomic<std::uint32_t> rung{0};
  std::atomic<std::int32_t> sleepers{0};
  static_assert(sizeof rung == 4 && std::atomic<std::uint32_t>::is_always_lock_free);
};

}  // namespace cca::detail
