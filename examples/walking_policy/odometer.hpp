#pragma once
// How fast the trunk moves forward, from the legs: a foot that carries stands still, so the trunk moves
// against it.
//
//   in  "angles"       leg_angles
//   in  "velocities"   leg_velocities
//   in  "rates"        trunk_angular_velocity
//   in  "loads"        foot_loads
//   out "speed"        trunk_speed, towards the nose: a mean over `average`; 0 until a foot carries
//
// The leg in its plane: x forward, z up; segments as in <cca/mapping/pantograph.hpp>, the toe straight. The
// foot is a ball that rolls, so the point that stands still is the lowest one of the ball:
//
//   v = -(r' + w x p),  p from the trunk's centre to that point, r' its velocity in the trunk
//
// A foot that slips forward, or whose toe gives way, misleads it: that is what `scale` is for. Both happen
// most while a foot carries little, and to the front feet, so a foot counts as the square of its load, times
// `front` if it is one of those. While no foot carries, the speed is that of before. A firing in which a
// number is not finite changes nothing.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <cca/cca.hpp>
#include <cca/robots/oncilla/body.hpp>

#include "spaces.hpp"

namespace walking {

struct odometer {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::duration, 0.01, 60>, average),
                             (cca::bounded<double, 0, 1>, front),  // how much a front foot counts
                             (cca::quantity<cca::force, 0.1, 1e4>,
                              lightest),                               // N, else no foot carries
                             (cca::bounded<double, 0.1, 10>, scale));  // of the output
  };
  parameters p{0.25, 0.1, 4, 1.2};

  auto process(cca::in<"angles", oncilla::leg_angles> angles,
               cca::in<"velocities", oncilla::leg_velocities> velocities,
               cca::in<"rates", oncilla::trunk_angular_velocity> rates,
               cca::in<"loads", oncilla::foot_loads> loads,
               cca::beat now) -> cca::out<"speed", trunk_speed> {
    double weight = 0, moved = 0;  // N^2, N^2 m/s
    for (std::size_t leg = 0; leg < oncilla::leg_count; ++leg) {
      const double load = loads.vector()[leg];
      const double counts = load * load * (oncilla::is_front(leg) ? static_cast<double>(p.front) : 1.0);
      weight += counts;
      moved += counts * against(leg, angles.vector(), velocities.vector(), rates.vector());
    }
    if (std::isfinite(weight + moved)) {
      if (weight > p.lightest * p.lightest) last_ = p.scale * moved / weight;
      mean_ += std::min(1.0, now.dt() / p.average) * (last_ - mean_);
    }
    return mean_;
  }

private:
  // m/s: how fast the trunk would move forward if this foot stood still.
  static double against(std::size_t leg,
                        const oncilla::leg_angles::vector_type& angles,
                        const oncilla::leg_velocities::vector_type& velocities,
                        const oncilla::trunk_angular_velocity::vector_type& rates) {
    constexpr auto& body = oncilla::body;
    const double hip = angles[oncilla::hip_of(leg)], hip_rate = velocities[oncilla::hip_of(leg)];
    const double middle = hip - angles[oncilla::knee_of(leg)],
                 middle_rate = hip_rate - velocities[oncilla::knee_of(leg)];
    // How far the ends of the segments are below their beginnings; the ball is carried by the outer ones.
    const double outer = (body.upper_length + body.foot_lever()) * cca::math::cos(hip) + body.foot_radius,
                 inner = body.middle_length * cca::math::cos(middle);
    return -(outer * hip_rate + inner * middle_rate) + rates[1] * (body.trunk_above_hips + outer + inner) +
           rates[2] * oncilla::side_of(leg) * body.hip_y;
  }

  double last_ = 0, mean_ = 0;  // m/s
};

}  // namespace walking
