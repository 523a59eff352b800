// Waiting for another environment without a lock: first at once, then giving way, then asleep. Now and then
// who waits asks whether the other one, in another process, is gone.
//
// A real-time thread that yields runs again at once if no other thread of its priority is ready, and after a
// short sleep it is always the next to run. So on a shared core it must sleep, and sleep longer the longer it
// has waited. Otherwise the threads that it waits for never run.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <thread>

#include <cca/runtime/environments/exchange/peers.hpp>
#include <cca/runtime/pace.hpp>

namespace cca::detail {

// While a thread polls: the other one on the same core runs faster, and the answer comes as fast.
inline void leave_core_to_others() {
#if defined(__x86_64__) || defined(__i386__)
  asm volatile("pause");
#elif defined(__aarch64__)
  asm volatile("isb");
#endif
}

class patience {
public:
  explicit patience(bell* arriving = nullptr, const peers* others = nullptr)
      : news(arriving), receives(others), before(arriving ? arriving->count() : 0) {}

  // Not beyond `latest`, a time of the clock.
  void wait(std::int64_t latest = std::numeric_limits<std::int64_t>::max()) {
    if (!receives && ++spun < spins) {
      leave_core_to_others();
      return count_again();
    }
    const std::int64_t now = monotonic_clock::now();
    if (times++ == 0) since = now;
    waited = now - since;
    const std::int64_t longest = std::min(longest_sleep, latest - now);
    if (longest <= 0) return count_again();
    if (receives && receives->receive(longest)) return count_again();
    if (news) news->wait(before, longest);
    else if (waited < longest_awake) std::this_thread::yield();
    else
      monotonic_clock::sleep_until(now +
                                   std::min(std::clamp(waited / 8, shortest_sleep, longest_sleep), longest));
    count_again();
  }
  // Every few milliseconds.
  bool is_time_to_ask() {
    if (waited < next_question) return false;
    next_question = waited + 2'000'000;
    return true;
  }

protected:
  static constexpr int least_spins = 8;

  int spins = least_spins, spun = 0;
  std::int64_t times = 0;  // beyond the spins

private:
  // On a busy machine a thread that yields runs again after milliseconds; a sleeping one is woken at once.
  static constexpr std::int64_t longest_awake = 100'000, shortest_sleep = 20'000, longest_sleep = 500'000;

  void count_again() {
    if (news) before = news->count();
  }

  bell* news;
  const peers* receives;
  std::uint32_t before;
  std::int64_t since = 0, waited = 0, next_question = 2'000'000;
};

// How long an environment polls before it yields. On a core of its own, longer polling gives a faster answer.
// On a shared core, polling only delays the threads that it waits for. So it learns from how its waits end,
// and tries longer polling again now and then.
struct waiting_habit {
  static constexpr int most_spins = 256;  // some microseconds, each with a pause
  int spins = most_spins;
  unsigned waits = 0;
};

class learned_patience : public patience {
public:
  // `arriving`: rings when something comes from another process. Null: it polls. `others`: those
  // from which this thread itself receives; then polling finds nothing.
  explicit learned_patience(waiting_habit& of, bell* arriving = nullptr, const peers* others = nullptr)
      : patience(arriving, others), habit(of) {
    spins = ++habit.waits % 64 == 0 ? waiting_habit::most_spins : habit.spins;
  }
  ~learned_patience() {
    if (times == 0 && spun > least_spins) habit.spins = std::min(2 * habit.spins, waiting_habit::most_spins);
    if (times > 0 && times <= 4) habit.spins = std::max(habit.spins / 2, least_spins);
  }
  learned_patience(const learned_patience&) = delete;
  learned_patience& operator=(const learned_patience&) = delete;

private:
  waiting_habit& habit;
};

}  // namespace cca::detail
