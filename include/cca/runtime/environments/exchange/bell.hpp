// Wakes a thread that sleeps until there is news: a counter that it waits for. Ringing never waits, and is
// one addition, unless a thread sleeps (then a call of the system, some microseconds).
#pragma once

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <cstdint>
#include <ctime>

namespace cca::detail {

// `Reach`: FUTEX_PRIVATE_FLAG, between the threads of a process; 0, in memory that processes share. A process
// that is killed asleep only makes each later ring a call of the system.
template <int Reach>
class bell_within {
public:
  void ring() noexcept {
    rung.fetch_add(1, std::memory_order_seq_cst);
    if (sleepers.load(std::memory_order_seq_cst) > 0)
      ::syscall(SYS_futex, &rung, FUTEX_WAKE | Reach, INT_MAX, nullptr, nullptr, 0);
  }

  // Read this, look whether there is news, and then wait for the next: nothing is missed.
  std::uint32_t count() const noexcept { return rung.load(std::memory_order_seq_cst); }

  // Until it has rung since `before` was counted, but not for long (ns).
  void wait(std::uint32_t before, std::int64_t longest) noexcept { sleep(FUTEX_WAIT, before, longest, 0); }
  // The same until a time of CLOCK_MONOTONIC.
  void wait_until(std::uint32_t before, std::int64_t time) noexcept {
    sleep(FUTEX_WAIT_BITSET, before, time, FUTEX_BITSET_MATCH_ANY);
  }

private:
  void sleep(int how, std::uint32_t before, std::int64_t time, std::uint32_t bits) noexcept {
    const timespec until{time / 1'000'000'000, time % 1'000'000'000};
    sleepers.fetch_add(1, std::memory_order_seq_cst);
    ::syscall(SYS_futex, &rung, how | Reach, before, &until, nullptr, bits);
    sleepers.fetch_sub(1, std::memory_order_seq_cst);
  }

  std::atomic<std::uint32_t> rung{0};
  std::atomic<std::int32_t> sleepers{0};
  static_assert(sizeof rung == 4 && std::atomic<std::uint32_t>::is_always_lock_free);
};

using bell = bell_within<FUTEX_PRIVATE_FLAG>;
using bell_between_processes = bell_within<0>;

}  // namespace cca::detail
