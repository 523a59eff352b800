// The world that a simulated robot is said to be in, by its type or by a tag: where `World` stands in
// `cca::sim::robot<R, World>` and `cca::sim::plant<R, World>`.
#pragma once

#include <cca/sim/robot/model/robot_model.hpp>

namespace cca::sim {

class robot_world;

namespace detail {

// Itself, or that of a tag (cca/sim/compiled/robot.hpp).
template <class R, class World>
struct world_named {
  using type = World;
};

// As it is put down unless a program does.
template <class R, class World>
World world_at_start() {
  if constexpr (requires { World::at_start(); }) return World::at_start();
  else return World(model_of<R>());
}

}  // namespace detail
}  // namespace cca::sim
