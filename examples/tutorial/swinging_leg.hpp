// Tutorial, step 4: a graph with two rates. docs/tutorial/4_two_rates.md
#pragma once

#include <cca/base/math.hpp>

#include "impedance.hpp"
#include "simple_leg.hpp"

// [planner]
struct swing {
  auto process(cca::beat now) -> cca::out<"target", leg_target> {
    const double t = 1e-9 * static_cast<double>(now.time());
    return Eigen::Vector2d(0.3 * cca::math::sin(3 * t), -0.5);
  }
};
// [planner end]

// [graph]
struct swinging_leg
    : cca::graph<cca::rate<1000>,                            // beats per second
                 cca::node<"swing", swing, cca::timed<10>>,  // every 10th beat: 100 Hz
                 cca::node<"impedance", impedance>,          // whenever an input is fresh: 1000 Hz
                 cca::node<"limits", cca::limiter<leg_currents>>,
                 cca::node<"leg", simple_leg>,

                 cca::wire<"swing.target", "impedance.target", cca::latest>,  // 100 Hz read at 1000 Hz
                 cca::wire<"leg.angles", "impedance.angles">,
                 cca::wire<"leg.velocities", "impedance.velocities">,
                 cca::wire<"impedance.currents", "limits.command">,
                 cca::wire<"limits.safe", "leg.currents">> {};
// [graph end]
