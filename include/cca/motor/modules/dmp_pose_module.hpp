// A discrete movement primitive of a pose as an adaptive module: it learns the movement of a hand, position
// and orientation together, keeps it in a file, and repeats it to other goals.
//
//   cca::adaptive_component<cca::dmp_pose_module<hand_in_base, hand, 30>, cca::reaching_goal<hand_in_base>>
//
//   in  "reference"      S                  where the movement ends; may change during the movement
//   in  "start"          S                  optional: where it begins; else the zero of S
//   in  "duration"       movement_duration  s, optional: else the parameter; at least 1 ms; may change
//   in  "restart"        restart_signal     optional: each sample restarts the movement, and a demonstration
//   in  "demonstration"  S                  optional: the movement to learn, to the reference in the duration
//   in  "learn"          learning_request   optional: a request of another component
//   out "command"        S                  maybe; its quaternion has unit length
//   out "velocity"       twist_of<S, Tip>   maybe; rad/s and m/s of the origin of Tip, along Frame's axes
//   out "progress"       movement_progress  maybe; the canonical variable: from 1 to e^-decay at the end
//   out "ode"            ode_status_port    converged at rest
//   out "module"         module_status_port what the learner does, and whether this progress was trained
//
// S is a space of pose<Frame>; Tip is the frame that moves. Between two beats `demonstrate(movement, s)`
// teaches a whole movement that was recorded, for example while somebody led the arm by hand. Quaternions
// may have either sign. Between two samples it may turn by less than half a turn.
//
// Parameters, NaN and infinity, cost: as of dmp_discrete_module. Errors: learner.model; `cca::refused` for
// files and movements. Source: discrete_motion.hpp. Example: tests/runtime/adaptive/discrete_modules.cpp.
#pragma once

#include <cca/motor/modules/discrete_motion.hpp>

namespace cca {

template <Space S,
          class Tip,
          int N,
          int Decay = 5000,
          Learner Rule = recursive_least_squares<pose_shape<S, N, Decay>>,
          int Capacity = 2000,
          class Integrator = rk4>
struct dmp_pose_module : adaptive_module<discrete_motion<dmp_pose<S, Tip, N, Integrator>,
                                                         pose_shape<S, N, Decay>,
                                                         S,
                                                         twist_of<S, Tip>,
                                                         Decay>,
                                         Rule,
                                         Capacity> {};

}  // namespace cca
