#pragma once
// Steers: the orientation of the trunk as seen from a heading that turns as commanded. What follows holds the
// heading 0, so the robot turns.
//
//   in  "orientation"   trunk_orientation
//   out "relative"      the same, without the commanded heading
//   out "turn"          turn_rate, that of the heading; 0 before `start`
//
// An orientation that is not finite passes.
#include <tuple>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace walking {

struct helm {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::velocity, -2, 2>, turn),      // rad/s, to the left
                             (cca::quantity<cca::duration, 0, 3600>, start));  // s to stand first
  };
  parameters p{0, 0.2};

  auto process(cca::in<"orientation", oncilla::trunk_orientation> trunk, cca::beat now)
      -> std::tuple<cca::out<"relative", oncilla::trunk_orientation>, cca::out<"turn", turn_rate>> {
    const double time = static_cast<double>(now.time()) * 1e-9;
    const double turn = time >= p.start ? static_cast<double>(p.turn) : 0.0;
    heading_ = cca::wrap_signed(heading_ + now.dt() * turn);
    const double c = cca::math::cos(0.5 * heading_), s = cca::math::sin(0.5 * heading_);
    const auto& q = trunk.vector();  // x, y, z, w; a turn about the vertical by -heading, then q
    return {
        Eigen::Vector4d(c * q[0] + s * q[1], c * q[1] - s * q[0], c * q[2] - s * q[3], c * q[3] + s * q[2]),
        turn};
  }

private:
  double heading_ = 0;  // rad
};

}  // namespace walking
