// A described robot in a simulator, as a graph: its nodes and ports, whatever world it is in.
//
// cca/sim/robot.hpp has it in the Open Dynamics Engine, cca/sim/compiled/robot.hpp in compiled physics.
#pragma once

#include <type_traits>

#include <cca/robots/ports.hpp>
#include <cca/sim/robot/simulated_node.hpp>

namespace cca::sim {

namespace detail {

// In place of the simulator of a robot whose description is refused, for programs that ask for its world.
template <class World>
struct refused_simulator {
  World& world();
  template <class... Given>
  void put_down(Given&&...) {}
  template <class Given>
  void disturb(Given&&) {}
};

template <class R, class World, class Mistake = robots::detail::description_mistake<R, true>>
struct robot_of : graph<node<"simulator", refused_simulator<World>>> {
  using cca_refused_by = Mistake;
};
template <class R, class World>
struct robot_of<R, World, void> : robots::graph_of_robot<R,
                                                         "simulator",
                                                         simulated_robot<R, World>,
                                                         "simulator",
                                                         joints_of<R>::template node> {};

}  // namespace detail

template <class R, class World = robot_world>
struct robot : detail::robot_of<R, World> {
  static_assert(robots::check_description<R>());
};

}  // namespace cca::sim
