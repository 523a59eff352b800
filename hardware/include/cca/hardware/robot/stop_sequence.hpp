// How a robot stops: its drives damp, then they are disabled, and each frame is repeated in every beat until
// each drive has confirmed that it is off, or until the time is over.
//
//   begin(damp)           from now on: `damping_beats` (1 s) of damping (none, where nothing moved), then
//                         disabling
//   hurry()               ends the damping early, so that the robot can start again
//   listen(joints, reports, gone)
//                         each beat, after the frames have been read. gone[b]: the frames that disable went
//                         over bus b
//   advance()             each beat, after the frames have been sent
//   stage()               none, damping or disabling
//   is_confirmed(i)       drive i has said in `confirmations` reports in a row, since the frames that disable
//                         went over the bus, that it holds nothing (is_off in joint_frames.hpp). A drive that
//                         can't say that has answered as often
//
// After `confirming_beats` (0.5 s) of disabling it ends, confirmed or not. Used by drive_synchronizer.hpp;
// shut_down.hpp goes through it to its end. Cost: some comparisons a joint. docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/robot/joint_frames.hpp>
#include <cca/hardware/safety/beats.hpp>

namespace cca::hardware {

enum class stop_stage : std::uint8_t { none, damping, disabling };

template <std::size_t Count, class Rate = cca::rate<1000>>
class stop_sequence {
public:
  static constexpr int damping_beats = beats<Rate>::in(1'000'000'000),
                       confirming_beats = beats<Rate>::in(500'000'000), confirmations = 3;

  // False: it is under way already, and goes on.
  bool begin(bool damp) {
    if (now == stop_stage::disabling || (now == stop_stage::damping && damp)) return false;
    now = damp ? stop_stage::damping : stop_stage::disabling;
    beats = 0;
    said.fill(0);
    return true;
  }
  void hurry() {
    if (now == stop_stage::damping) begin(false);
  }

  template <class... J, std::size_t Buses>
  void listen(joint_list<J...>,
              const std::array<drive_report, Count>& reports,
              const std::array<bool, Buses>& gone) {
    std::size_t i = 0;
    const auto one = [&]<class D>(std::size_t bus, std::type_identity<D>) {
      const drive_report& r = reports[i];
      const std::uint64_t number = r.states != 0 ? r.states : r.frames;
      if (now == stop_stage::disabling && gone[bus] && number != seen[i])
        said[i] = is_off<D>(r) ? said[i] + 1 : 0;
      seen[i++] = number;
    };
    (one(J::bus, std::type_identity<typename J::drive>()), ...);
  }
  void advance() {
    if (now == stop_stage::none) return;
    ++beats;
    if (now == stop_stage::damping && beats >= damping_beats) begin(false);
    else if (now == stop_stage::disabling && (are_all_confirmed() || beats >= confirming_beats))
      now = stop_stage::none;
  }

  stop_stage stage() const { return now; }
  bool is_confirmed(std::size_t i) const { return said[i] >= confirmations; }
  bool are_all_confirmed() const {
    return std::ranges::all_of(said, [](int n) { return n >= confirmations; });
  }

private:
  std::array<std::uint64_t, Count> seen{};
  std::array<int, Count> said{};
  int beats = 0;
  stop_stage now = stop_stage::none;
};

}  // namespace cca::hardware
