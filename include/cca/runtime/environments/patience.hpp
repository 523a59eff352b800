// Waiting for another environment without a lock: first at once, then giving way, then asleep. Now and then
// it asks whether the other one, in another process, is gone.
#pragma once

#include <algorithm>
#include <cstdint>
#include <thread>

#include <cca/runtime/pace.hpp>

namespace cca::detail {

// How long an environment looks again at once before it gives way. On a core of its own it answers sooner
// the longer it does; where the others need its core, it only keeps them from coming. So it learns from how
// its waits end, and tries again now and then.
class waiting_habit {
public:
  int spins() { return ++waits % 64 == 0 ? most : usual; }
  // A wait has ended.
  void learn(int spun, std::int64_t gave_way) {
    if (gave_way == 0 && spun > least) usual = std::min(2 * usual, most);
    if (gave_way > 0 && gave_way <= 4) usual = std::max(usual / 2, least);
  }

  static constexpr int least = 64;

private:
  static constexpr int most = 2048;  // some microseconds
  int usual = most;
  unsigned waits = 0;
};

class patience {
public:
  patience() = default;
  explicit patience(waiting_habit& of) : habit(&of), spins(of.spins()) {}
  ~patience() {
    if (habit) habit->learn(spun, times);
  }
  patience(const patience&) = delete;
  patience& operator=(const patience&) = delete;

  void wait() {
    if (++spun < spins) return;
    if (++times < longest_awake) return give_way();
    monotonic_clock::sleep_until(monotonic_clock::now() + 20'000);
  }
  // Every few milliseconds.
  bool is_time_to_ask() const { return times > longest_awake && times % 64 == 0; }

private:
  static constexpr std::int64_t longest_awake = 448;

  // Who gives way on a busy machine comes back after milliseconds; who sleeps is woken at once.
  void give_way() {
    const std::int64_t before = monotonic_clock::now();
    std::this_thread::yield();
    if (monotonic_clock::now() - before > 100'000) times = longest_awake;
  }

  waiting_habit* habit = nullptr;
  int spins = waiting_habit::least, spun = 0;
  std::int64_t times = 0;
};

// Of the environments that other processes run: whether the process has ended.
class peers {
public:
  virtual ~peers() = default;
  virtual bool is_gone(int environment) const = 0;
};

}  // namespace cca::detail
