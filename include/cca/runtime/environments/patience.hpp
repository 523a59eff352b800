// Waiting for another environment without a lock: first at once, then giving way, then asleep. Now and then
// who waits asks whether the other one, in another process, is gone.
//
// A thread in real time that gives way comes back at once where no thread of its priority waits, and one that
// sleeps briefly is always the next to run. So on a core that is shared it must sleep, and the longer it has
// waited the longer, or those that it waits for never come.
#pragma once

#include <algorithm>
#include <cstdint>
#include <thread>

#include <cca/runtime/pace.hpp>

namespace cca::detail {

class patience {
public:
  void wait() {
    if (++spun < spins) return;
    const std::int64_t now = monotonic_clock::now();
    if (times++ == 0) since = now;
    waited = now - since;
    if (waited < longest_awake) std::this_thread::yield();
    else monotonic_clock::sleep_until(now + std::clamp(waited / 8, shortest_sleep, longest_sleep));
  }
  // Every few milliseconds.
  bool is_time_to_ask() {
    if (waited < next_question) return false;
    next_question = waited + 2'000'000;
    return true;
  }

protected:
  static constexpr int least_spins = 64;

  int spins = least_spins, spun = 0;
  std::int64_t times = 0;  // beyond the spins

private:
  // Who gives way on a busy machine comes back after milliseconds; who sleeps is woken at once.
  static constexpr std::int64_t longest_awake = 100'000, shortest_sleep = 20'000, longest_sleep = 500'000;

  std::int64_t since = 0, waited = 0, next_question = 2'000'000;
};

// How long an environment looks again at once before it gives way. On a core of its own it answers sooner
// the longer it does; where the others need its core, it only keeps them from coming. So it learns from how
// its waits end, and tries again now and then.
struct waiting_habit {
  static constexpr int most_spins = 2048;  // some microseconds
  int spins = most_spins;
  unsigned waits = 0;
};

class learned_patience : public patience {
public:
  explicit learned_patience(waiting_habit& of) : habit(of) {
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
