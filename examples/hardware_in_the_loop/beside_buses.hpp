#pragma once
// The trot on drives, for two environments (two_environments.hpp): what the gait and the side of the buses
// tell each other arrives a beat later. Also the graph of its twin, which has no environments
// (docs/door.md).
#include "../deployed/with_items.hpp"
#include "../trot/architecture.hpp"
#include "robot.hpp"

namespace hil {

// [beside buses]
template <class Bus>
struct trot_beside_buses
    : deployed::with_items<trot::architecture<oncilla<Bus>>,
                           cca::wire<"robot.orientation", "posture.orientation", cca::delayed<1>>,
                           cca::wire<"gait.angles", "limits.command", cca::delayed<1>>> {};
// [beside buses end]

}  // namespace hil
