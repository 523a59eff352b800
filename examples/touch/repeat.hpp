#pragma once
// The movement that was shown, as an adaptive component: a movement primitive of a pose with its learner, and
// the criterion that the hand has reached the goal.
#include <tuple>

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/reaching_criterion.hpp>
#include <cca/motor/modules/dmp_pose_module.hpp>

#include "spaces.hpp"

namespace touch {

// A sample of "begin" starts the movement anew, from "start".
struct shown_movement : cca::dmp_pose_module<hand, flange, 60> {
  using module = cca::dmp_pose_module<hand, flange, 60>;
  shown_movement() { p.stiffness = 25; }

  auto process(cca::in<"reference", hand> reference,
               cca::optional_in<"start", hand> start,
               cca::optional_in<"begin", cca::restart_signal> begin,
               cca::beat now) -> std::tuple<cca::maybe<"command", hand>,
                                            cca::maybe<"velocity", cca::twist_of<hand, flange>>,
                                            cca::maybe<"progress", cca::movement_progress>,
                                            cca::out<"ode", cca::ode_status_port>,
                                            cca::out<"module", cca::module_status_port>> {
    if (begin && begin.fresh()) on_start();
    return module::process(reference, start, {}, {}, {}, {}, now);
  }
};

struct at_goal : cca::reaching_goal<hand> {
  at_goal() { p.limits = {0.002, 0.004, 10, 0.2}; }
};

struct repeated : cca::adaptive_component<shown_movement, at_goal> {};

}  // namespace touch
