// What other threads want of the run of a deployment, for the loop that gives the beat: a pause, another
// speed.
#pragma once

#include <cca/runtime/run_record.hpp>

namespace cca::detail {

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
  // goes_on(): once a period, while it is paused. False: the run ends. After a pause nothing is caught up.
  template <class GoesOn>
  bool operator()([[maybe_unused]] GoesOn goes_on) const {
    if constexpr (Controls<Between, Deployed>) {
      if (!between.control().obey(pace, Deployed::period(),
                                  [&] { return goes_on() && between.while_paused(all); }))
        return false;
      runs.begin(pace, Deployed::period());
    }
    return true;
  }
};

}  // namespace cca::detail
