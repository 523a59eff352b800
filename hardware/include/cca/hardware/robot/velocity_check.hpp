// Whether the velocity that a drive reports is the change of its angle: a wrong range of the firmware, a
// wrong sign or a frozen number makes damping wrong, and the overspeed check too.
//
//   velocity_check check;
//   check.compare(angle, speed, time);   // each measured angle, with the newest speed: rad, rad/s, ns
//   check.disagrees()                    // `most_bad` blocks of 5 ms disagree, and none in between agrees
//   check.passed()                       // a block has been compared, and none disagreed since the last that
//   agreed
//
// A block compares the way that the angle went with the sum of velocity times time. They disagree if they
// differ by more than 3 mrad and 30 % of the larger one. So a speed of the wrong sign is found above 0.6
// rad/s, and one of half or twice the size above 3 rad/s. Blocks with less than 3 mrad decide nothing. Cost:
// ten operations a report. Example: tests/runtime/drive_chain/start_and_stop.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cca::hardware {

class velocity_check {
public:
  static constexpr std::int64_t block = 5'000'000, longest_pause = 50'000'000;  // ns
  static constexpr double least = 0.003, part = 0.3;                            // rad, of the larger way
  static constexpr int most_bad = 6;

  void restart() { *this = {}; }

  void compare(double angle, double speed, std::int64_t time) {
    if (!begun || time - at > longest_pause) return begin(angle, speed, time);
    if (time <= at) return;  // a frame that came twice, or late
    told += 0.5 * (speed + former) * static_cast<double>(time - at) * 1e-9;
    former = speed;
    at = time;
    if (at - from < block) return;
    judge(angle - start);
    begin(angle, speed, time);
  }

  bool disagrees() const { return bad >= most_bad; }
  bool passed() const { return compared && bad == 0; }

private:
  void begin(double angle, double speed, std::int64_t time) {
    begun = true;
    start = angle, former = speed, told = 0;
    from = at = time;
  }
  void judge(double moved) {
    compared = true;
    const double way = std::max(std::abs(moved), std::abs(told));
    if (way < least) return;
    bad = std::abs(moved - told) > least + part * way ? std::min(bad + 1, most_bad) : 0;
  }

  double start = 0, former = 0, told = 0;
  std::int64_t from = 0, at = 0;
  int bad = 0;
  bool begun = false, compared = false;
};

}  // namespace cca::hardware
