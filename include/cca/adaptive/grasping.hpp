// The Grasping Criterion: does the gripper hold something? (the source document, chapter 3, *Criterion*)
//
//   cca::grasping<aperture, grip_torque>
//
//   in  "target"     S                one axis: the commanded aperture
//   in  "feedback"   S                the measured aperture
//   in  "effort"     E                one axis: torque or force of the grip; its sign does not count
//   out "error"      criterion_error  unit of S: distance to the target, which a grasped thing keeps from 0
//   out "state"      criterion_port
//
// Fulfilled: for `hold` s the effort is at least `firm`, the speed at most `still` per s and the aperture
// wider than `empty`. It stays fulfilled until the effort falls below `slack` or the aperture to `empty`.
// Lost: for `hold` s the aperture is at most `empty`, so the gripper closed on nothing; open again when it is
// wider. Before each input has a sample it is open.
//
// While the aperture is NaN or infinite: error 1e12, `lost` after `hold` s; while the effort is: not
// fulfilled. Neither is kept. Afterwards `hold` restarts.
//
// Errors: none. Cost: negligible. Example: tests/runtime/adaptive/kinds.cpp.
#pragma once

#include <cmath>
#include <tuple>

#include <cca/adaptive/criterion.hpp>

namespace cca {

template <Space S, Space E>
  requires(S::size == 1 && E::size == 1)
struct grasping {
  static constexpr criterion_target compares = criterion_target::command;
  static constexpr bool at_rest = false;
  using pressing = quantity<typename E::domain::quantity, 0, infinity>;
  using wide = quantity<typename S::domain::quantity>;
  using period = quantity<duration, 0, infinity>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (pressing, firm),
                             (pressing, slack),
                             (wide, empty),
                             (bounded<double, 0, infinity>, still),
                             (period, hold));
    std::string_view check() const { return slack <= firm ? "" : "`slack` is above `firm`"; }
  };
  parameters p{1.0, 0.5, 0.01, 0.05, 0.1};

  auto process(in<"target", S> target, in<"feedback", S> feedback, in<"effort", E> effort, beat now)
      -> std::tuple<out<"error", criterion_error>, out<"state", criterion_port>> {
    if (target.origin() == never || feedback.origin() == never || effort.origin() == never)
      return {0.0, status_of(state)};
    const double width = feedback.vector()[0], force = std::abs(effort.vector()[0]);
    const double speed = seen && now.dt() > 0 ? std::abs(width - before) / now.dt() : infinity;
    seen = std::isfinite(width);
    if (seen) before = width;
    const bool closed = !(width > p.empty), holds = !closed && force >= p.firm && speed <= p.still;
    for_held = holds ? for_held + now.dt() : 0;
    for_closed = closed ? for_closed + now.dt() : 0;
    constexpr double rounding = 1e-9;
    if (closed && for_closed + rounding >= p.hold) state = criterion_state::lost;
    else if (holds && for_held + rounding >= p.hold) state = criterion_state::fulfilled;
    else if (state == criterion_state::fulfilled ? closed || !(force >= p.slack) : !closed)
      state = criterion_state::open;
    return {error_to_publish(std::abs(target.vector()[0] - width)), status_of(state)};
  }

  void on_start() {
    seen = false;
    for_held = for_closed = 0;
    state = criterion_state::open;
  }

private:
  double before = 0, for_held = 0, for_closed = 0;
  bool seen = false;
  criterion_state state = criterion_state::open;
};

}  // namespace cca
