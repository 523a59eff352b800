#pragma once
// The sequence of skills: the order of the steps, the conditions that start each, and where to go if that
// takes too long.
//
// A condition stands with the step that it starts. Conditions depend on the status of the skills, not on
// time; only the paw is held at the ball for a second.
//
// Each step names the skills that it needs; the others rest. While the robot stands, the gait does: its
// movement primitive is most of what a beat computes.
#include <cca/adaptive/component_status.hpp>
#include <cca/adaptive/sequence.hpp>

#include "spaces.hpp"

namespace skills {

struct arrived : cca::all<cca::is<"hip_reaching.status", cca::ode_status::converged>,
                          cca::is<"knee_reaching.status", cca::ode_status::converged>> {};
struct still : cca::is<"trunk.status", cca::criterion_state::fulfilled> {};
struct follows : cca::is<"dmp.status.component", cca::component_status::reached> {};
struct at_ball : cca::is<"reaching.status.state", cca::criterion_state::fulfilled> {};

// [plan]
using gait = cca::needs<"cpg", "dmp">;
using walking = cca::needs<"cpg", "dmp", "heading">;
using touching = cca::needs<"aim", "reaching">;

struct plan
    : cca::steps<
          cca::step<"trot", walking>,
          cca::step<"stop", cca::is<"ball.status", ball_state::near>, walking>,
          cca::step<"shift weight",
                    cca::is<"cpg.status", cca::ode_status::converged>,
                    still,
                    gait,
                    cca::or_after<6000, "trot on">>,
          cca::step<"lift paw", arrived, still, follows, touching, cca::or_after<6000, "stand">>,
          cca::step<"reach",
                    arrived,
                    cca::is<"paw.status", paw_state::raised>,
                    touching,
                    cca::or_after<6000, "put down">>,
          cca::step<"touch", at_ball, touching, cca::or_after<6000, "draw back">>,
          cca::step<"draw back", at_ball, cca::held_for<1000>, touching, cca::or_after<6000, "draw back">>,
          cca::step<"put down", arrived, cca::or_after<6000, "put down">>,
          cca::step<"stand",
                    arrived,
                    cca::is<"paw.status", paw_state::grounded>,
                    still,
                    gait,
                    cca::or_after<6000, "stand">>,
          cca::step<"trot on", arrived, still, follows, walking, cca::or_after<6000, "trot on">>> {};
// [plan end]

}  // namespace skills
