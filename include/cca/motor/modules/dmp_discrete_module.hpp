// A discrete movement primitive as an adaptive module: it learns a movement from a start to a goal, keeps it
// in a file, and repeats it to other goals.
//
//   cca::adaptive_component<cca::dmp_discrete_module<arm_angles, 20>, cca::reaching_goal<arm_angles>>
//
//   in  "reference"      S                  where the movement ends; may change during the movement
//   in  "start"          S                  optional: where it begins; else the zero of S
//   in  "duration"       movement_duration  s, optional: else the parameter; at least 1 ms; may change
//   in  "restart"        restart_signal     optional: each sample restarts the movement, and a demonstration
//   in  "demonstration"  S                  optional: the movement to learn, to the reference in the duration
//   in  "learn"          learning_request   optional: a request of another component
//   out "command"        S                  maybe
//   out "velocity"       velocity_of<S>     maybe; unit of S per s
//   out "progress"       movement_progress  maybe; the canonical variable: from 1 to e^-decay at the end
//   out "ode"            ode_status_port    converged at rest
//   out "module"         module_status_port what the learner does, and whether this progress was trained
//
// S is any space with one number per axis. Between two beats `demonstrate(movement, s)` teaches a whole
// movement that was recorded with a sample every s seconds: its last sample is the goal, its length the
// duration. Filter noise before: accelerations come from differences.
//
// Parameters: duration, stiffness, goal_rate, scaled (the shape grows with the way from start to goal; else,
// the default, a demonstration may end where it began), settling, settings (of the learner), files. A file
// that was learned with another stiffness or `scaled` is refused. The learner is recursive least squares.
//
// Inputs (input_status.hpp): as of dmp_discrete: while one is NaN or infinite, the movement stands still, the
// velocity is 0, nothing else but the statuses is published, and "ode" is `unreadable`; too large or too fast
// is cut, with `clamped`. A demonstration that is NaN or infinite is never learned.
//
// Errors: learner.model; `cca::refused` for files and movements. Cost: dmp_discrete, and 2 N^2 products for
// the trained region; with a demonstration 2 N^2 more. Source: discrete_motion.hpp.
// Example: tests/runtime/adaptive/discrete_modules.cpp.
#pragma once

#include <cca/motor/modules/discrete_motion.hpp>

namespace cca {

template <detail::LinearSpace S,
          int N,
          int Decay = 5000,
          Learner Rule = recursive_least_squares<discrete_shape<S, N, Decay>>,
          int Capacity = 2000,
          class Integrator = rk4>
struct dmp_discrete_module : adaptive_module<discrete_motion<dmp_discrete<S, N, Integrator>,
                                                             discrete_shape<S, N, Decay>,
                                                             S,
                                                             velocity_of<S>,
                                                             Decay>,
                                             Rule,
                                             Capacity> {};

}  // namespace cca
