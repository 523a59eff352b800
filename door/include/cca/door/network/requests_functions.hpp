// The requests of all clients, one at a time: begun, tried again while the controller is busy, and refused
// when no beat takes them. Nothing here waits: `tick` looks once.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cca/door/controls.hpp>
#include <cca/door/network/client.hpp>
#include <cca/door/network/limits.hpp>

namespace cca::detail::door_network {

inline constexpr const char* not_taken = "the loop has not begun a beat since";

struct door_task {
  std::uint64_t client = 0;    // 0: the door's own, which waits as long as it takes
  std::string name{}, what{};  // of the client; for the log
  door_request request{};
  bool may_set = false;  // parameters: it is compared before and after
  // Looks at the parameters before they are set, and fills in the request; what it returns is the refusal.
  std::function<std::string(const std::vector<door_parameter>&, door_request&)> prepare{};
  std::function<void(const door_outcome&)> answer{};
  bool is_undo = false, is_held = false;  // held: a command that has an effect until it is released
  std::string test{};  // the node of a test that it begins or ends, which no undo takes back
  double speed = 0;    // of the run, before it changes that
  time_point since{};
};

class request_queue {
public:
  using values = std::vector<door_parameter>;
  // Called once for each task that has an end; `is_late`: its client was told before that it was not taken.
  std::function<void(
      door_task&, const door_outcome&, const values* before, const values* after, bool is_late)>
      on_end{};

  request_queue(door_controls& of, const door_limits& all) : controls(of), limits(all) {}

  bool is_idle() const { return !current && waiting.empty(); }
  bool is_full() const { return waiting.size() >= limits.requests; }
  void add(door_task task, time_point now) {
    task.since = now;
    waiting.push_back(std::move(task));
  }
  // Before all that wait: what ends an effect, and the emergency stop.
  void add_first(door_task task, time_point now) {
    task.since = now;
    waiting.push_front(std::move(task));
  }
  // What a client asked for and nobody has begun.
  void forget(std::uint64_t client) {
    std::erase_if(waiting, [&](const door_task& one) { return one.client == client; });
  }
  // Those of clients that nobody has begun: each is told why.
  void refuse_tests(const std::string& why) {
    refuse([](const door_task& one) { return one.client != 0 && !one.test.empty(); }, why);
  }
  void tick(time_point now) {
    stop_now(now);
    while (step(now)) {}
    refuse_old(now);
  }

private:
  door_controls& controls;
  const door_limits& limits;
  std::deque<door_task> waiting{};
  std::optional<door_task> current{};
  std::optional<values> before{};
  std::optional<door_outcome> ended{};  // of the current one, whose values after are still asked for
  bool is_late = false;
  time_point last_end{};

  // The emergency stop does not wait for a request that no beat has taken.
  void stop_now(time_point now) {
    if (!current || ended || waiting.empty() || waiting.front().request.about != door_request::what::end_run)
      return;
    door_outcome outcome = controls.begin(waiting.front().request);
    if (outcome.is == door_outcome::how::busy) return;
    door_task other = *std::move(current);
    current.reset();
    begin(std::move(outcome));
    if (on_end) on_end(other, {door_outcome::how::refused, "the run was stopped"}, nullptr, nullptr, is_late);
    if (ended) end(nullptr, now);
  }
  // Whether there is something to do at once.
  bool step(time_point now) {
    if (current && !ended) {
      door_outcome outcome = controls.outcome();
      if (outcome.is == door_outcome::how::begun || outcome.is == door_outcome::how::busy) return false;
      ended = std::move(outcome);
    }
    if (current) {
      const bool compares = current->may_set && ended && ended->is == door_outcome::how::done;
      const auto after = compares ? controls.parameters() : std::nullopt;
      if (compares && !after) return false;
      end(after ? &*after : nullptr, now);
      return true;
    }
    if (waiting.empty()) return false;
    door_task& first = waiting.front();
    before = first.may_set ? controls.parameters() : std::nullopt;
    if (first.may_set && !before) return false;
    if (first.prepare && before)
      if (std::string why = first.prepare(*before, first.request); !why.empty()) {
        begin({door_outcome::how::refused, std::move(why)});
        return true;
      }
    door_outcome outcome = controls.begin(first.request);
    if (outcome.is == door_outcome::how::busy) return false;
    begin(std::move(outcome));
    return true;
  }
  void begin(door_outcome outcome) {
    current = std::move(waiting.front());
    waiting.pop_front();
    is_late = false;
    if (outcome.is != door_outcome::how::begun) ended = std::move(outcome);
  }
  void end(const values* after, time_point now) {
    if (!current || !ended) return;
    door_task task = *std::move(current);
    const door_outcome outcome = *std::move(ended);
    current.reset(), ended.reset();
    last_end = now;
    if (on_end) on_end(task, outcome, before ? &*before : nullptr, after, is_late);
  }
  // Time counts from the request, or from the end of the last one: a queue that moves is in order.
  bool is_old(const door_task& one, time_point now) const {
    return one.client != 0 && now - std::max(one.since, last_end) > limits.taken_time;
  }
  void refuse_old(time_point now) {
    if (current && !ended && !is_late && is_old(*current, now)) {
      is_late = true;  // it can't be called back, so it stays the current one
      if (current->answer)
        current->answer({door_outcome::how::refused, std::string(not_taken) + "; the next one takes it"});
    }
    refuse([&](const door_task& one) { return is_old(one, now); }, not_taken);
  }
  template <class Which>
  void refuse(Which&& which, const std::string& why) {
    std::deque<door_task> refused;
    for (auto one = waiting.begin(); one != waiting.end();)
      if (which(*one)) refused.push_back(std::move(*one)), one = waiting.erase(one);
      else ++one;
    for (door_task& one : refused) on_end(one, {door_outcome::how::refused, why}, nullptr, nullptr, false);
  }
};

}  // namespace cca::detail::door_network
