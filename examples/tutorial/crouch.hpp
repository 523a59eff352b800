// Tutorial, step 8: an architecture for any robot with the ports of the Oncilla. docs/tutorial/8_simulator.md
#pragma once

#include <cca/cca.hpp>
#include <cca/sim/oncilla.hpp>

// [crouch]
// Bends and stretches all four legs once per second.
//
//   out angles  sim::leg_angles  four hips, then four knees
struct crouch {
  auto process(cca::beat now) -> cca::out<"angles", cca::sim::leg_angles> {
    const double t = 1e-9 * static_cast<double>(now.time());
    const double lift = 0.01 * (1 - cca::math::cos(2 * cca::pi * t));  // of the feet, 0 to 20 mm
    const auto leg = cca::sim::leg_angles_for(cca::sim::oncilla_defaults, {0.04, -0.165 + lift});
    cca::sim::leg_angles::vector_type angles;
    angles << Eigen::Vector4d::Constant(leg.hip), Eigen::Vector4d::Constant(leg.knee);
    return angles;
  }
};

template <class Robot>
struct crouching : cca::graph<cca::rate<1000>,
                              cca::node<"crouch", crouch>,
                              cca::node<"limits", cca::limiter<cca::sim::leg_angles>>,
                              cca::node<"robot", Robot>,
                              cca::wire<"crouch.angles", "limits.command">,
                              cca::wire<"robot.angles", "limits.measured">,
                              cca::wire<"limits.safe", "robot.command">> {};
// [crouch end]
