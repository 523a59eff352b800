// What a controller keeps of its wall-clock runs, how others pause a run and change its speed, and
// what it does however a run ends.
#pragma once

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <string>
#include <utility>

#include <cca/base/monotonic_clock.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/runtime/observers/begun_anew.hpp>
#include <cca/runtime/observers/loop_observers.hpp>
#include <cca/runtime/pace.hpp>

namespace cca::detail {

// A pace that counts overruns, as `at_speed` does.
template <class Pace> concept OnClock = requires(Pace& pace) {
  pace.begin(std::int64_t{}, std::int64_t{});
  { pace.fault() } -> std::same_as<fault>;
  { pace.last_begun() } -> std::same_as<std::int64_t>;
  { pace.duration_of(std::int64_t{}) } -> std::same_as<std::int64_t>;
  { pace.overruns() } -> std::same_as<std::int64_t>;
  { pace.lost_periods() } -> std::same_as<std::int64_t>;
};

struct run_record {
  std::int64_t last_begun = at_speed::never_begun;
  std::int64_t overruns = 0, lost_periods = 0;

  template <class Pace>
  void begin(Pace& pace, std::int64_t period) {
    overruns_before = overruns, lost_before = lost_periods;
    if constexpr (OnClock<Pace>) pace.begin(period, last_begun);
    else pace.begin();
  }
  // Waits for the next beat; the fault of a pace that gives up.
  template <class Pace>
  fault wait(Pace& pace, std::int64_t time, loop_observers to) {
    pace.wait(time);
    if constexpr (OnClock<Pace>) {
      last_begun = pace.last_begun();
      const std::int64_t seen = std::exchange(overruns, overruns_before + pace.overruns());
      const std::int64_t periods = std::exchange(lost_periods, lost_before + pace.lost_periods());
      if (overruns > seen) to.overrun(lost_periods - periods);
      return pace.fault();
    } else {
      return {};
    }
  }

private:
  std::int64_t overruns_before = 0, lost_before = 0;
};

// On every way out of a run, also by an exception.
struct end_of_run {
  state& now;
  ~end_of_run() {
    if (now == state::running) now = after(transition::pause, now);
  }
};

// A run whose beats are far apart looks so often for what others want of it, ns.
inline constexpr std::int64_t a_while = 20'000'000;

// Sleeps so long if the next beat is farther off. False: it is not.
template <class Pace>
bool dozes(Pace& pace, std::int64_t period) {
  if constexpr (requires { pace.dozes(period, a_while); }) return pace.dozes(period, a_while);
  else return false;
}

// From any thread to the loop that gives the beat, which looks at one number between two beats: a pause,
// single beats in a pause, another speed. Nobody waits for the other.
class run_control {
public:
  // ---- any thread ----

  // A pause, and the end of one, also end the single beats that were to come.
  void pause() noexcept { end_steps(), is_wanted.store(true, std::memory_order_release), note(); }
  void go_on() noexcept { end_steps(), is_wanted.store(false, std::memory_order_release), note(); }
  void end_steps() noexcept { steps.store(0, std::memory_order_release); }
  // In a pause: one beat more.
  void step() noexcept { steps.fetch_add(1, std::memory_order_release), note(); }
  // Why not; empty: it is asked, in the pause or after the fault that holds the run. No single beat comes
  // before it.
  std::string ask_anew(begun_anew::wish what) {
    end_steps();
    return anew.ask(what, is_pause_wanted());
  }
  // Times the clock.
  void set_speed(double factor) noexcept {
    speed.store(factor, std::memory_order_relaxed);
    is_speed_set.store(true, std::memory_order_relaxed);
    has_speed.store(true, std::memory_order_release), note();
  }
  bool is_pause_wanted() const noexcept { return is_wanted.load(std::memory_order_acquire); }
  // The loop has paused, and no single beat is to come but the one that it may be in.
  bool is_paused() const noexcept { return holds_pause() && steps.load(std::memory_order_acquire) == 0; }
  // In a fast run there is no clock whose speed could be changed.
  bool has_refused_speed() const noexcept { return refuses_speed.load(std::memory_order_acquire); }

  // ---- the loop's, between two beats ----

  bool has_news() const noexcept { return news.load(std::memory_order_acquire); }
  // After obey(): the next beat is a single one in a pause.
  bool holds_pause() const noexcept { return holds.load(std::memory_order_acquire); }

  // Does what is wanted, and returns when there is to be a beat. While it is paused, idle() is called once a
  // period, and goes_on() as well, or more often if a period is long; false ends the pause and the run.
  template <class Pace, class Idle, class GoesOn>
  bool obey(Pace& pace, std::int64_t period, Idle idle, GoesOn goes_on) {
    (void)news.exchange(false, std::memory_order_acq_rel);
    if (has_speed.exchange(false, std::memory_order_acquire)) {
      if constexpr (requires { pace.set_speed(1.0); })
        refuses_speed.store(!pace.set_speed(speed.load(std::memory_order_relaxed)),
                            std::memory_order_release);
      else refuses_speed.store(true, std::memory_order_release);
    }
    bool runs = true;
    if constexpr (requires { pace.duration_of(period); }) period = pace.duration_of(period);
    period = std::max(period, shortest);
    std::int64_t due = monotonic_clock::now();
    while (runs && is_wanted.load(std::memory_order_acquire)) {
      holds.store(true, std::memory_order_release);
      int left = steps.load(std::memory_order_acquire);
      if (left > 0 && steps.compare_exchange_strong(left, left - 1, std::memory_order_acq_rel)) {
        note();  // it pauses again after that beat
        return true;
      }
      if (const std::int64_t now = monotonic_clock::now(); now >= due) {
        idle();
        due = std::max(due + period, now);
      }
      runs = goes_on();
      monotonic_clock::sleep_until(std::min(due, monotonic_clock::now() + a_while));
    }
    steps.store(0, std::memory_order_relaxed);
    holds.store(false, std::memory_order_release);
    return runs;
  }

  // The run is over. A pause that is wanted holds for the next one.
  void end_run() noexcept { holds.store(false, std::memory_order_release); }
  // Before a run that goes on where another one has ended: after its first beat it looks at what still holds,
  // the pause and the speed.
  void hold_for_next_run() noexcept {
    has_speed.store(is_speed_set.load(std::memory_order_relaxed), std::memory_order_release);
    note();
  }

  begun_anew anew{};  // after a fault or a pause

private:
  static constexpr std::int64_t shortest = 100'000;  // ns

  // Exchanged on both sides: the loop that takes the news sees what each of two threads had stored before.
  void note() noexcept { (void)news.exchange(true, std::memory_order_acq_rel); }

  std::atomic<bool> news{false}, is_wanted{false}, holds{false}, has_speed{false}, is_speed_set{false},
      refuses_speed{false};
  std::atomic<int> steps{0};
  std::atomic<double> speed{1};
};

// A `between` that can pause the run: control(), and while_paused(controller), which returns false to end it.
template <class Between, class Controller> concept Controls = requires(Between& between, Controller& c) {
  { between.control() } -> std::same_as<run_control&>;
  { between.while_paused(c) } -> std::same_as<bool>;
};

struct nothing_between {
  template <class Controller>
  constexpr void operator()(Controller&) const {}
};

// After a run, however it ended: other threads see its state.
template <class Between, class Controller>
void tell_end([[maybe_unused]] Between& between, [[maybe_unused]] Controller& c) {
  if constexpr (requires { between.run_ended(c); }) between.run_ended(c);
}

// Between two beats: true, the run goes on.
template <class Between, class Controller>
bool goes_on_after(Between& between, Controller& c) {
  if constexpr (requires { between.goes_on(c); }) return between.goes_on(c);  // cca::live_access
  else if constexpr (std::same_as<decltype(between(c)), bool>) return between(c);
  else return between(c), true;
}

}  // namespace cca::detail
