#pragma once
// The simulator and what is around the robot: the ball, the pushes, the referee. It plays a whole run by
// itself, so it can run in a program of its own, on another machine than the robot's controller.
//
//   sense   out one port for each joint, the sensors   as of cca::sim::simulator
//           out "ball", maybe                          point_in_trunk: what a camera on the trunk sees
//   act     in  one port for each joint                as of cca::sim::simulator
//           in  "step", "timed_out"                    of the sequencer, for the referee
//
// The world stands still until the first targets of all joints have come: the robot may start later than its
// world.
#include <cmath>
#include <cstdint>
#include <tuple>

#include <cca/base/monotonic_clock.hpp>
#include <cca/adaptive/sequencer.hpp>
#include <cca/sim/oncilla/simulator.hpp>

#include "../combination_of_skills/referee.hpp"

namespace deployed {

namespace oncilla = cca::robots::oncilla;
using built = oncilla::as_built;

template <class Axes>
class stage_of;

template <class... Axes>
class stage_of<cca::axes<Axes...>> : public cca::sim::simulator {
public:
  // Before start().
  void set_scene(const skills::circumstances& run) {
    referee = skills::referee(run);
    put_down(referee.put_down<cca::sim::world>(skills::orders().p), referee.disturbance());
  }

  auto sense() {
    cca::maybe<"ball", skills::point_in_trunk> ball;
    if (const auto seen = referee.ball(world())) ball = *seen;
    return std::tuple_cat(cca::sim::simulator::sense(), std::tuple(ball));
  }

  auto act(cca::in<Axes::label, cca::robots::wanted_joint<built, Axes>>... wanted,
           cca::in<"step", cca::step_port> step,
           cca::in<"timed_out", cca::step_flag> timed_out) -> cca::fault {
    // Of a joint without a command nothing is finite.
    const bool has_robot = ((wanted.origin() != cca::never && std::isfinite(wanted.vector()[0])) && ...);
    if (!has_robot) return {};
    const double begins = world().time();
    const cca::fault fault = cca::sim::simulator::act(wanted...);
    if (referee.note(begins, world(), static_cast<int>(step[cca::step_axis{}]),
                     timed_out[cca::timed_out_axis{}] != 0, [] { return std::nan(""); }))
      disturb(referee.disturbance());
    return fault;
  }

  bool is_over() const { return referee.is_over(); }
  skills::result judgement() const { return referee.judgement(); }

private:
  skills::referee referee;
};

struct stage : stage_of<cca::robots::measured_axes_of<built>> {
  // From here on it gets no command, by this machine's clock (ns).
  void on_fault() { stopped_at = cca::detail::monotonic_clock::now(); }
  std::int64_t stopped_at = 0;
};

}  // namespace deployed
