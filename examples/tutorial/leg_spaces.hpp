// Tutorial, step 2: the spaces of a leg with two joints, and a domain type for motor currents.
// docs/tutorial/2_spaces.md
#pragma once

#include <cca/cca.hpp>

// [axes]
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits =
      cca::limits{cca::angle{-0.9, 0.9}, cca::velocity{-5.0, 5.0}, cca::current{-8.0, 8.0}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits =
      cca::limits{cca::angle{-1.8, 0.0}, cca::velocity{-5.0, 5.0}, cca::current{-8.0, 8.0}};
};
// [axes end]

// [domain type]
// Motor currents, one number per axis, in ampere.
struct motor_currents {
  using quantity = cca::current;          // the limiter reads the axes' limits of this quantity
  static constexpr bool actuated = true;  // commands an actuator: axes need limits, wires a limiter
  static constexpr int width(int axes) { return axes; }  // numbers in a sample over so many axes
  static constexpr double zero(int, int) { return 0; }   // what an input holds before its first sample

  template <class Self>
  struct methods {  // what a sample can do
    // Heat in the windings in W, for windings of `resistance` ohm.
    double heat(double resistance) const {
      return resistance * static_cast<const Self&>(*this).vector().squaredNorm();
    }
  };
};
// [domain type end]

// [spaces]
using leg_axes = cca::axes<hip, knee>;
struct leg_angles : cca::space<cca::joint_angles, leg_axes, cca::rate<1000>> {};
struct leg_velocities : cca::space<cca::joint_velocities, leg_axes, cca::rate<1000>> {};
struct leg_currents : cca::space<motor_currents, leg_axes, cca::rate<1000>> {};
struct leg_target : cca::space<cca::joint_angles, leg_axes> {};  // no rate: any planner may write it
// [spaces end]
