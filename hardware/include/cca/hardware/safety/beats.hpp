// Times of the robot's side, counted in beats of its rate.
//
//   beats<cca::rate<200>>::period        ns
//   beats<cca::rate<200>>::in(100'000'000)
//                                        20: as many beats as take that long, and at least one
//   beats<cca::rate<4000>>::lasting(3'000'000)
//                                        12: likewise, and at least three, since one or two frames may be
//                                        late or lost
//   beats<R>::patience(period)           after how many beats a report counts as missing that should come in
//                                        each period (ns; 0: each beat): three reports, and at least 3 ms
//
// At 1 kHz a millisecond is a beat.
#pragma once

#include <algorithm>
#include <cstdint>

#include <cca/space/space.hpp>

namespace cca::hardware {

template <class Rate>
struct beats {
  static constexpr auto period = static_cast<std::int64_t>(1e9 / Rate::hz);

  static constexpr int in(std::int64_t time) {
    return static_cast<int>(std::max<std::int64_t>(1, (time + period - 1) / period));
  }
  static constexpr int lasting(std::int64_t time, int least = 3) { return std::max(least, in(time)); }
  static constexpr int patience(std::int64_t report_period) {
    return std::max(3 * in(report_period), in(3'000'000));
  }
};

}  // namespace cca::hardware
