// Tutorial, step 3: a component. docs/tutorial/3_component.md
#pragma once

#include "leg_spaces.hpp"

// [component]
// Joint impedance: a spring and a damper in each joint.
//
//   in  target      leg_target      where the springs pull
//   in  angles      leg_angles      measured
//   in  velocities  leg_velocities  measured
//   out currents    leg_currents    for the motors
struct impedance {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.0, 100.0>, stiffness),  // A/rad
                             (cca::bounded<double, 0.0, 5.0>, damping));     // A s/rad
  };
  parameters p{20.0, 1.0};

  auto process(cca::in<"target", leg_target> target,
               cca::in<"angles", leg_angles> angles,
               cca::in<"velocities", leg_velocities> velocities) -> cca::out<"currents", leg_currents> {
    return p.stiffness * (target.vector() - angles.vector()) - p.damping * velocities.vector();
  }
};
// [component end]
