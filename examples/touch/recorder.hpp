#pragma once
// Keeps the movement by which somebody leads the hand: from when it begins to move until it rests again.
//
//   in  "step"    step_port
//   in  "pose"    hand
//   in  "twist"   hand_motion
//   out "first"   hand           where the movement began
//   out "last"    hand           where it ended
//   out "status"  recording_port
#include <array>
#include <cstddef>
#include <span>
#include <tuple>

#include <cca/adaptive/sequencer.hpp>

#include "plan.hpp"

namespace touch {

class recorder {
public:
  static constexpr double interval = 0.005;  // s, between two samples
  static constexpr std::size_t most = 2000;

  auto process(cca::in<"step", cca::step_port> step,
               cca::in<"pose", hand> pose,
               cca::in<"twist", hand_motion> twist,
               cca::beat now)
      -> std::tuple<cca::out<"first", hand>, cca::out<"last", hand>, cca::out<"status", recording_port>> {
    const bool guided = static_cast<int>(step[cca::step_axis{}]) == plan::at<"guided">;
    const double speed = twist.vector().tail<3>().norm();
    if (guided && state == recording::idle && speed > 0.01) state = recording::running;
    if (state == recording::running) {
      since += now.dt();
      if (since >= interval && count < most) kept[count++] = pose.vector(), since -= interval;
      rests = speed < 0.005 ? rests + now.dt() : 0;
      if (rests > 0.5 || count == most) finish();
    }
    return {count > 0 ? kept[0] : pose.vector(), count > 0 ? kept[count - 1] : pose.vector(),
            cca::status_of(state)};
  }

  std::span<const hand::vector_type> movement() const { return std::span(kept).first(count); }

  void on_start() { *this = {}; }

private:
  // Without the rest at the end.
  void finish() {
    const auto resting = static_cast<std::size_t>(rests / interval);
    if (count > resting + 3) count -= resting;
    state = recording::complete;
  }

  std::array<hand::vector_type, most> kept{};
  std::size_t count = 0;
  double since = interval, rests = 0;
  recording state = recording::idle;
};

}  // namespace touch
