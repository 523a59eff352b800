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
    : cca::graph<cca::rate<1000>,                                   // beats per second
                 cca::node<"plan", change_sides, cca::timed<100>>,  // every 100th beat: 10 Hz
                 cca::node<"balance", balance>,                     // whenever something new arrives: 1000 Hz
                 cca::node<"limits", cca::limiter<torques>>,
                 cca::node<"robot", Robot>,

                 cca::wire<"plan.place", "balance.place", cca::latest>,  // 10 Hz, read at 1000 Hz
                 cca::wire<"robot.angles", "balance.angles">,
                 cca::wire<"robot.velocities", "balance.velocities">,
                 cca::wire<"balance.torques", "limits.command">,
                 cca::wire<"limits.safe", "robot.torque">> {};

}  // namespace my_robot
