// The architecture: which components there are, and what flows between them. `Robot` is the simulated robot,
// or cca::hardware::robot<description, ...> on drives.
#pragma once

#include <cca/cca.hpp>
#include <cca/robot/limiter.hpp>

#include "controller.hpp"
#include "robot.hpp"

namespace my_robot {

template <class Robot>
struct architecture
    : cca::graph<cca::rate<1000>,                                // beats per second
                 cca::node<"clock", step_clock>,                 // every beat: 1000 Hz
                 cca::node<"heading", heading, cca::timed<10>>,  // every tenth beat: 100 Hz
                 cca::node<"gait", gait, cca::port_triggered<"phase">>,
                 cca::node<"limits", cca::limiter<angles>>,
                 cca::node<"robot", Robot>,

                 cca::wire<"robot.orientation", "heading.orientation", cca::latest>,  // 1000 Hz, at 100 Hz
                 cca::wire<"heading.turn", "gait.turn", cca::latest>,                 // 100 Hz, at 1000 Hz
                 cca::wire<"clock.phase", "gait.phase">,
                 cca::wire<"clock.size", "gait.size">,
                 cca::wire<"gait.angles", "limits.command">,
                 cca::wire<"robot.angles", "limits.measured">,  // it begins where the robot is
                 cca::wire<"limits.safe", "robot.position">> {};

}  // namespace my_robot
