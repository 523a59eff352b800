// What a thread of resource nodes does while it waits for others: their hook `on_idle` runs once a period, so
// that a robot goes on getting frames, however long the others take.
//
//   idle_beats idle(period, 0);
//   idle.until([&](patience&) { return is_over(); }, [&] { call_on_idle(); });
//
// Bound: no two calls of the hook are more than a period apart, beyond what the system and the hook take.
// Calls are never caught up in a burst.
#pragma once

#include <algorithm>
#include <cstdint>

#include <cca/base/monotonic_clock.hpp>
#include <cca/runtime/environments/waiting/patience.hpp>

namespace cca::detail {

class idle_beats {
public:
  // In ns of the machine's clock. `grace`: so long it waits before it begins to idle.
  idle_beats(std::int64_t every, std::int64_t grace)
      : period(std::max<std::int64_t>(every, shortest)), most_patient(grace) {
    begin(monotonic_clock::now());
  }

  // The last beat began at this time.
  void begin(std::int64_t beat) { due = std::max(beat + period, monotonic_clock::now() + most_patient); }

  // `is_over(patience)` is asked as often as the patience of the thread says.
  template <class IsOver, class Idle>
  void until(IsOver is_over, Idle idle) {
    for (patience waiting; !is_over(waiting); waiting.wait(due)) {
      const std::int64_t now = monotonic_clock::now();
      if (now < due) continue;
      idle();
      due = due + period > now ? due + period : now + period;
    }
  }

private:
  static constexpr std::int64_t shortest = 20'000;

  std::int64_t period, most_patient, due = 0;
};

// In a run at this pace: in a wall-clock run the period of its beats. In a fast run that of the architecture,
// and not before others have taken 100 ms: they hang then. Sooner a result would depend on the machine's
// speed.
template <class Pace>
idle_beats idle_beats_at(const Pace& pace, std::int64_t period_of_architecture) {
  if constexpr (requires { pace.duration_of(period_of_architecture); })
    return idle_beats(pace.duration_of(period_of_architecture), 0);
  else return idle_beats(period_of_architecture, 100'000'000);
}

}  // namespace cca::detail
