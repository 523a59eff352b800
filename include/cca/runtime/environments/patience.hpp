// Waiting for another environment without a lock: first at once, then giving way, then asleep. Now and then
// who waits asks whether the other one, in another process, is gone.
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
    if (++times < longest_awake) return give_way();
    monotonic_clock::sleep_until(monotonic_clock::now() + 20'000);
  }
  // Every few milliseconds.
  bool is_time_to_ask() const { return times > longest_awake && times % 64 == 0; }

protected:
  static constexpr int least_spins = 64;
  static constexpr std::int64_t longest_awake = 448;

  // Who gives way on a busy machine comes back after milliseconds; who sleeps is woken at once.
  void give_way() {
    const std::int64_t before = monotonic_clock::now();
    std::this_thread::yield();
    if (monotonic_clock::now() - before > 100'000) times = longest_awake;
  }

  int spins = least_spins, spun = 0;
  std::int64_t times = 0;
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
