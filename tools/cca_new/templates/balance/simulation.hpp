// The architecture in the simulator, and what a program says about a run.
#pragma once

#include <cstdio>

#include <cca/graph/items/shows.hpp>
#include <cca/sim/robot.hpp>

#include "architecture.hpp"

namespace my_robot {

struct simulated : architecture<cca::sim::robot<description>> {};
static_assert(cca::check<simulated>());  // the first mistake of the graph, in a sentence

// What recordings and pages show.
struct shown : cca::shows<body, "robot.angles"> {};

template <class Controller>
void put_down(Controller&) {}  // the rail is above the floor: nothing to do

template <class Controller>
void report(const Controller& c) {
  const auto& world = c.template get<"robot.simulator">().world();
  std::printf("after %.1f s: cart at %+.3f m, pole %+.2f degrees from upright\n", world.time(),
              world.joint("cart").angle, world.joint("pole").angle * 180 / cca::pi);
}

}  // namespace my_robot
