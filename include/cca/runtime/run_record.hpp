// What a controller keeps of its runs at wall-clock speed, and what it does however a run ends.
#pragma once

#include <concepts>
#include <cstdint>

#include <cca/component/fault.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/runtime/pace.hpp>
#include <cca/runtime/tracing/trace_track.hpp>

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
  fault wait(Pace& pace, std::int64_t time) {
    pace.wait(time);
    if constexpr (OnClock<Pace>) {
      last_begun = pace.last_begun();
      overruns = overruns_before + pace.overruns();
      lost_periods = lost_before + pace.lost_periods();
      return pace.fault();
    } else {
      return {};
    }
  }
  // The same, and tells a trace of an overrun.
  template <class Pace>
  fault wait(Pace& pace, std::int64_t time, trace_track* track) {
    const std::int64_t seen = overruns, periods = lost_periods;
    const fault late = wait(pace, time);
    if (track && overruns > seen) track->overrun(lost_periods - periods);
    return late;
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

struct nothing_between {
  template <class Controller>
  constexpr void operator()(Controller&) const {}
};

// Between two beats: true, the run goes on.
template <class Between, class Controller>
bool goes_on_after(Between& between, Controller& c) {
  if constexpr (requires { between.goes_on(c); }) return between.goes_on(c);  // cca::live_access
  else if constexpr (std::same_as<decltype(between(c)), bool>) return between(c);
  else return between(c), true;
}

}  // namespace cca::detail
