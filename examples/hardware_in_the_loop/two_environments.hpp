#pragma once
// The trot on drives in two environments: the side of the buses, in real time where the system allows it, and
// the gait beside it. docs/hardware.md
//
// A beat of the first has sensors, limiter, safety chain and frames, and nothing that could make it late. If
// the gait is late for more than 3 beats in a row, that is a fault, and the robot stops in order.
#include <cca/deployment.hpp>
#include <cca/runtime/environments/realtime.hpp>

#include "beside_buses.hpp"
#include "in_memory.hpp"

namespace hil {

// [two environments]
template <class Bus>
struct two_environments
    : cca::deployment<trot_beside_buses<Bus>,
                      cca::environment<"buses", cca::nodes<"robot", "limits">, cca::realtime_if_allowed<80>>,
                      cca::environment<"gait", cca::other_nodes>> {};
// [two environments end]

using two_in_memory = in_memory<two_environments<memory_end>, cca::deployed<two_environments<memory_end>>>;

}  // namespace hil
