// One world of many: the controller of a task with its robot, from the beat of one answer to the next.
//
// An answer counts in the beat in which the policy saw what it answers, as on the robot. So at the end of a
// step a copy of the controller runs the policy's next beat, shows what it would see, and is thrown away.
//
//   Task   cca/python/task.hpp
//
// Errors: cca::refused where an episode can't begin.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <cca/base/refused.hpp>
#include <cca/component/lifecycle.hpp>

namespace cca::python {

// When the policy of a task fires, in beats.
struct firing_times {
  std::int64_t first = 0, period = 0;
};

template <class Task>
class episode {
public:
  using controller = typename Task::controller;
  using stand_in = std::remove_reference_t<decltype(Task::policy_of(std::declval<controller&>()))>;

  explicit episode(const controller& loaded) : c(loaded) {}

  // `change(controller)` sets parameters. The controller is loaded and not started.
  template <class Change>
  void begin(const controller& loaded, const firing_times& times, std::uint64_t seed, Change change) {
    c = loaded;
    reason_.clear();
    change(c);
    Task::begin(c, seed);
    c.start();
    for (std::int64_t k = 0; k < times.first && beat(c); ++k) {}
    if (reason_.empty()) look();
    if (!reason_.empty())
      throw refused("seed " + std::to_string(seed) +
                    ": it ends before the policy has seen anything: " + reason_);
    Task::score_of(c).sum = 0;
    reward_ = 0;
  }

  // From the beat of this answer to the next one of the policy.
  void step(std::span<const double> action, const firing_times& times) {
    auto& policy = Task::policy_of(c);
    std::copy(action.begin(), action.end(), policy.answer.data());
    beat(c);
    Task::score_of(c).sum = 0;  // of the beat that was looked at
    for (std::int64_t k = 1; k < times.period && reason_.empty(); ++k) beat(c);
    if (reason_.empty()) look();
    else reward_ = Task::score_of(c).sum;
  }

  const typename stand_in::observation& observations() const { return policy().observations; }
  double reward() const { return reward_; }
  bool is_over() const { return is_over_ || !reason_.empty(); }
  // Of a fault: its place and text; else empty.
  const std::string& fault() const { return reason_; }

  // The next beat of any controller of the task; false after a fault.
  static bool run_beat(controller& of) {
    if constexpr (requires { Task::before_beat(of); }) Task::before_beat(of);
    of.step();
    return of.state() != state::faulted;
  }

private:
  const stand_in& policy() const { return Task::policy_of(const_cast<controller&>(c)); }

  bool beat(controller& of) {
    if (run_beat(of)) return true;
    reason_ = of.fault_path() + ": " + std::string(of.fault().reason());
    return false;
  }

  void look() {
    controller ahead = c;
    const auto before = Task::policy_of(ahead).firings;
    run_beat(ahead);
    const auto& policy = Task::policy_of(ahead);
    if (policy.firings == before) {
      reason_ = ahead.fault_path() + ": " + std::string(ahead.fault().reason());
    } else {
      Task::policy_of(c).observations = policy.observations;
    }
    reward_ = Task::score_of(ahead).sum;
    is_over_ = Task::score_of(ahead).is_over;
  }

  controller c;
  double reward_ = 0;
  bool is_over_ = false;
  std::string reason_;
};

}  // namespace cca::python
