// How a follower waits for the beats of the first environment, in a wall-clock run. `Loop` is its loop.
//
// It sleeps until its next beat is due, and is woken when a run ends. If the first environment does not begin
// that beat, resource nodes idle once a period and `between` is asked: a robot goes on getting frames, and a
// signal ends the run. More such periods in a row than late beats are tolerated are lost contact, unless the
// first environment has paused.
#pragma once

#include <algorithm>
#include <cstdint>

#include <cca/base/separate/function_ref.hpp>
#include <cca/graph/deployment/environments.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/environments/waiting/lost_contact.hpp>
#include <cca/runtime/pace.hpp>

namespace cca::detail {

template <class Loop, class D>
class beats_of_first {
protected:
  // Until it begins this beat. False: a fault or the end has come before it. `meanwhile`, if it is one: each
  // time before it sleeps.
  template <class AfterBeat>
  bool wait_for_beat(std::int64_t beat, AfterBeat& goes_on_after, function_ref<void()> meanwhile) {
    auto& shared = loop().shared();
    const auto& first = shared.environments[0];
    const std::int64_t since = monotonic_clock::now();
    std::int64_t idles_at = 0;
    for (std::int64_t missed = 0;;) {
      const std::uint32_t before = shared.ends.count();
      if (!loop().goes_on()) return false;
      const std::int64_t newest = loop().begun();
      if (newest >= beat) return true;
      const std::int64_t begun_at = first.begun_at[first.slot_of(newest)].load(std::memory_order_relaxed);
      const bool has_begun = begun_at != 0;
      const std::int64_t interval =
          has_begun ? first.interval.load(std::memory_order_relaxed) : counts_of<D>.period;
      const std::int64_t due = begun_at + (beat - newest) * interval;
      const std::int64_t now = monotonic_clock::now();
      if (now > std::max(since, due) + longest_silence)
        loop().state.look_for(0, loop().position() - 1, [&] { return loop().begun() >= beat; });
      idles_at = std::max(idles_at, std::max(since, due) + interval / 2);
      if (now < idles_at) {
        if (meanwhile) meanwhile();
        shared.ends.wait_until(before, std::clamp(due, now + shortest_sleep, now + longest_sleep(interval)));
        continue;
      }
      loop().active_at = now;
      loop().idle();
      if (!goes_on_after()) return loop().stop(), false;
      idles_at = std::max(idles_at, now - interval / 2) + interval;
      if (first.is_paused.load(std::memory_order_acquire)) missed = 0;
      else if (Loop::has_hooks_of_resources && has_begun && ++missed > environments_of<D>::tolerated)
        loop().state_fault(loop().state.observers(), 0, lost_contact<D>(0), -1);
    }
  }

  // Until the first environment has begun the last beat before `end`, of which this one needs none.
  void wait_for_last_beat(std::int64_t end, function_ref<void()> meanwhile) {
    auto& shared = loop().shared();
    const std::int64_t interval = std::max(counts_of<D>.period, longest_rest);
    const auto is_over = [&] { return !loop().goes_on() || loop().begun() >= end - 1; };
    for (;;) {
      const std::uint32_t before = shared.ends.count();
      if (is_over()) return;
      loop().state.look_for(0, exchange<D>::position_of(std::max<std::int64_t>(loop().begun(), 0)), is_over);
      meanwhile();
      shared.ends.wait_until(before, monotonic_clock::now() + interval);
    }
  }

private:
  Loop& loop() { return static_cast<Loop&>(*this); }

  static constexpr std::int64_t longest_silence = 10'000'000;  // then it is asked whether it is gone
  static constexpr std::int64_t shortest_sleep = 20'000, longest_rest = 20'000'000;
  // The end of a run wakes a thread, but a transport may bring it late: an environment that must react to a
  // fault looks in each beat.
  static constexpr std::int64_t longest_sleep(std::int64_t interval) {
    return std::max(interval, Loop::has_hooks_of_resources ? shortest_sleep : longest_rest);
  }
};

}  // namespace cca::detail
