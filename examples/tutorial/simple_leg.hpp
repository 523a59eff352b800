// Tutorial, step 4: a leg to control, instead of a robot. docs/tutorial/4_two_rates.md
#pragma once

#include <tuple>

#include <cca/base/math.hpp>

#include "leg_spaces.hpp"

// [leg]
// Two geared motors that carry an upper and a lower segment. Simplified: the joints have fixed inertias.
//
//   out angles      leg_angles      rad
//   out velocities  leg_velocities  rad/s
//   in  currents    leg_currents    A
struct simple_leg {
  auto sense() -> std::tuple<cca::out<"angles", leg_angles>, cca::out<"velocities", leg_velocities>> {
    return {angles, velocities};
  }
  void act(cca::in<"currents", leg_currents> currents, cca::beat now) {
    constexpr double inertia = 0.02, friction = 0.05;  // kg m^2, N m s/rad; the gears give 1 N m/A
    const double upper = 1.2 * cca::math::sin(angles[0]), lower = 0.5 * cca::math::sin(angles[0] + angles[1]);
    const Eigen::Vector2d weight(upper + lower, lower);  // N m
    velocities += now.dt() / inertia * (currents.vector() - friction * velocities - weight);
    angles += now.dt() * velocities;
  }
  Eigen::Vector2d angles{0, -0.5}, velocities{0, 0};
};
// [leg end]
