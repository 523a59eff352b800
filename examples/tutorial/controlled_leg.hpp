// Tutorial, step 6: a skeleton, which is a class template that is a graph. docs/tutorial/6_skeleton.md
#pragma once

#include "simple_leg.hpp"

// [skeleton]
// A leg under any controller with the ports of `impedance`.
//
//   in  target  leg_target  where the leg shall go
//   out angles  leg_angles  measured
template <class Controller>
struct controlled_leg : cca::graph<cca::node<"controller", Controller>,
                                   cca::node<"limits", cca::limiter<leg_currents>>,
                                   cca::node<"leg", simple_leg>,
                                   cca::wire<"leg.angles", "controller.angles">,
                                   cca::wire<"leg.velocities", "controller.velocities">,
                                   cca::wire<"controller.currents", "limits.command">,
                                   cca::wire<"limits.safe", "leg.currents">,
                                   cca::expose<"controller.target", "target">,
                                   cca::expose<"leg.angles", "angles">> {};
// [skeleton end]
