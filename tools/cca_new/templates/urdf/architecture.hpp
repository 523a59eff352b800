// The architecture: which components there are, and what flows between them. `Robot` is the simulated robot,
// or cca::hardware::robot<description, ...> on drives.
#pragma once

#include <cca/cca.hpp>
#include <cca/robot/limiter.hpp>

#include "controller.hpp"
#include "robot.hpp"

namespace my_robot {

template <class Robot>
struct architecture : cca::graph<cca::node<"plan", sway, cca::timed<1>>,
                                 cca::node<"follow", follow, cca::timed<1>>,
                                 cca::node<"limits", cca::limiter<torques>>,
                                 cca::node<"robot", Robot>,

                                 cca::wire<"plan.angles", "follow.wanted">,
                                 cca::wire<"plan.velocities", "follow.wanted_velocities">,
                                 cca::wire<"robot.angles", "follow.angles">,
                                 cca::wire<"robot.velocities", "follow.velocities">,
                                 cca::wire<"follow.torques", "limits.command">,
                                 cca::wire<"limits.safe", "robot.torque">> {};

}  // namespace my_robot
