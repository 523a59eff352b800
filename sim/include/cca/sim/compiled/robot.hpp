// Any described robot in compiled physics, as a graph: the nodes and ports of cca::sim::robot<R>, without an
// engine.
//
//   cca::node<"robot", cca::sim::robot<cca::robots::arm::description, cca::sim::compiled>>
//
// Set its world before the start:
//
//   controller.get<"robot.simulator">().put_down(cca::sim::compiled_world<R>(room));
//
// Without that it is as R::start has it, with nothing around it. Errors: as cca/sim/robot.hpp, and
// robot.compiled. Cost: docs/physics.md. Example: tests/runtime/compiled_world/node.cpp.
#pragma once

#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/robot/robot_graph.hpp>

namespace cca::sim {

// In place of a world: that of this robot, compiled.
struct compiled {};

namespace detail {

template <class R>
struct world_named<R, compiled> {
  using type = compiled_world<R>;
};

}  // namespace detail
}  // namespace cca::sim
