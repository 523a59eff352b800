// What other threads want of the run of a deployment, for the loop that gives the beat: a pause, another
// speed.
#pragma once

#include <concepts>

#include <cca/runtime/run_record.hpp>

namespace cca::detail {

// While an environment waits for others there is no beat after which `between` could be asked; what ends a
// run at any time has `is_over()` (cca::interruption).
template <class Between>
bool wants_end([[maybe_unused]] const Between& between) {
  if constexpr (requires {
                  { between.is_over() } -> std::same_as<bool>;
                })
    return between.is_over();
  else return false;
}

// Wants to look at each environment between two of its beats, in its thread.
template <class Between, class Deployed> concept LooksAfterEach =
    requires(Between& between, Deployed& all) { between.template after_beat<0>(all); };

template <class Deployed, class Pace, class Between>
struct obeyed_control {
  Deployed& all;
  run_record& runs;
  Pace& pace;
  Between& between;

  bool has_news() const {
    if constexpr (Controls<Between, Deployed>) return between.control().has_news();
    else return false;
  }
  // After operator(): it makes a single beat in a pause.
  bool holds_pause() const {
    if constexpr (Controls<Between, Deployed>) return between.control().holds_pause();
    else return false;
  }
  // Looks for what others want while the next beat is far off. False: the run ends.
  template <class GoesOn>
  bool looks_until_it_is_near([[maybe_unused]] bool is_single, [[maybe_unused]] GoesOn goes_on) const {
    if constexpr (Controls<Between, Deployed>)
      while ((is_single || !has_news()) && goes_on() && dozes(pace, Deployed::period()))
        if (!between.while_paused(all)) return false;
    return true;
  }
  // idle(): once a period, while it is paused. False: the run ends. After a pause nothing is caught up.
  template <class Idle, class GoesOn>
  bool operator()([[maybe_unused]] Idle idle, [[maybe_unused]] GoesOn goes_on) const {
    if constexpr (Controls<Between, Deployed>) {
      if (!between.control().obey(pace, Deployed::period(), idle,
                                  [&] { return goes_on() && between.while_paused(all); }))
        return false;
      runs.begin(pace, Deployed::period());
    }
    return true;
  }
};

}  // namespace cca::detail
