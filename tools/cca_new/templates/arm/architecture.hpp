// The architecture: which components there are, and what flows between them. `Robot` is the simulated arm, or
// cca::hardware::robot<description, ...> on drives.
#pragma once

#include <cca/cca.hpp>
#include <cca/robot/limiter.hpp>

#include "controller.hpp"
#include "robot.hpp"

namespace my_robot {

template <class Robot>
struct architecture : cca::graph<cca::rate<1000>,                               // beats per second
                                 cca::node<"way", circle, cca::timed<2>>,       // every second beat: 500 Hz
                                 cca::node<"hand", compliance, cca::timed<1>>,  // every beat: 1000 Hz
                                 cca::node<"limits", cca::limiter<torques>>,
                                 cca::node<"robot", Robot>,

                                 cca::wire<"way.pose", "hand.reference", cca::latest>,  // 500 Hz, at 1000 Hz
                                 cca::wire<"way.motion", "hand.reference_twist", cca::latest>,
                                 cca::wire<"robot.angles", "hand.angles">,
                                 cca::wire<"robot.velocities", "hand.velocities">,
                                 cca::wire<"hand.torques", "limits.command">,
                                 cca::wire<"limits.safe", "robot.torque">> {};

}  // namespace my_robot
