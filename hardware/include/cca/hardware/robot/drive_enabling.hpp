// Enables the drives of a robot: the class `enabling` of each drive leads it there step by step, until it
// holds its present position.
//
//   begin()                      a new start
//   next<J, I>(report, known, frames)
//                                the frames for joint I in this beat; `known`: it is measured (joint_monitor)
//   are_all_ready()              all drives are enabled, and all joints measured
//   count_beat(), is_over()      whether `most_beats` have passed: 1 s
//
// A drive that refuses, or falls back, is tried again every 50 ms, since a frame may be lost. Used by
// drive_synchronizer.hpp. Cost: some operations a joint, while it enables.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include <cca/hardware/drives/drive.hpp>
#include <cca/hardware/safety/beats.hpp>

namespace cca::hardware {

template <class... J>
class drive_enabling;

template <auto Hz, class... J>
class drive_enabling<cca::rate<Hz>, J...> {
public:
  static constexpr std::size_t count = sizeof...(J);
  static constexpr int most_beats = beats<cca::rate<Hz>>::in(1'000'000'000),
                       again = beats<cca::rate<Hz>>::in(50'000'000);

  void begin() { *this = {}; }

  template <class One, std::size_t I, class Frames>
  void next(const drive_report& report, bool known, Frames& frames) {
    const bool off = refused[I] || report.activity == drive_activity::disabled;
    if (off && beats_left % again == 0) std::get<I>(steps) = {}, refused[I] = false;
    if (!refused[I]) {
      const enable_step s = std::get<I>(steps).next(report);
      for (const can_frame& f : s.frames) frames.add(f);
      enabled[I] = enabled[I] || s.progress == enable_progress::done;
      refused[I] = !enabled[I] && s.progress == enable_progress::failed;
    }
    ready[I] = enabled[I] && report.activity != drive_activity::disabled && known;
  }
  void count_beat() { --beats_left; }

  bool is_enabled(std::size_t i) const { return enabled[i]; }
  bool are_all_ready() const {
    return std::ranges::all_of(ready, [](bool yes) { return yes; });
  }
  bool is_over() const { return beats_left <= 0; }

private:
  std::tuple<typename J::drive::enabling...> steps{};
  std::array<bool, count> ready{}, enabled{}, refused{};
  int beats_left = most_beats;
};

template <class... J>
class drive_enabling : public drive_enabling<cca::rate<1000>, J...> {};

}  // namespace cca::hardware
