// A described robot in a simulator, as a graph: its nodes and ports, whatever world it is in.
//
// cca/sim/robot.hpp has it in the Open Dynamics Engine, cca/sim/compiled/robot.hpp in compiled physics.
#pragma once

#include <type_traits>

#include <cca/robots/ports.hpp>
#include <cca/sim/robot/simulated_node.hpp>

namespace cca::sim {

template <class R, class World = robot_world>
struct robot : robots::graph_of_robot<std::enable_if_t<robots::check_description<R>(), R>,
                                      "simulator",
                                      simulated_robot<R, World>,
                                      "simulator",
                                      detail::joints_of<R>::template node> {};

}  // namespace cca::sim
