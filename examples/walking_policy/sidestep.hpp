#pragma once
// Steps aside in a circle: while the trunk turns, the place of a standing foot moves sideways under it, to
// the right in front and to the left behind where it turns left. The legs follow by abduction, so the feet
// need not slip.
//
//   in  "phase"       gait_phase, of the left front leg
//   in  "amplitude"   gait_amplitude; below `full` the legs step aside less, at rest not at all
//   in  "turn"        turn_rate
//   out "abduction"   abduction_angles
//
//   y = share turn x stance / 2 * s(phase),  abduction = y / height, outward
//
// x: of the foot before the trunk's centre; s: from 1 where the foot lands, evenly to -1 where it lifts off,
// and as a cosine back. With a share of 1 the feet of a trunk that turns about its centre stand still. Less
// is better, because the legs of one side also swing farther (measured: docs/walking_policy.md).
#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace walking {

struct sidestep {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 2>, share),
                             (cca::bounded<double, 0.01, 1>, full),   // amplitude
                             (cca::bounded<double, 0.2, 0.8>, duty),  // stance, as part of the stride
                             (cca::quantity<cca::duration, 0, 1>, stance),
                             (std::array<double, 4>, offsets),  // of the legs, in strides (trot::gait)
                             (double, front),                   // x of the feet, m
                             (double, hind),
                             (cca::quantity<cca::length, 0.01, 1>, height));  // of the hips
  };
  parameters p{0.7, 0.2, 0.587, 0.14, {0.0, 0.5, 0.373, -0.127}, 0.145, -0.11, 0.16};

  auto process(cca::in<"phase", trot::gait_phase> phase,
               cca::in<"amplitude", trot::gait_amplitude> amplitude,
               cca::in<"turn", turn_rate> turn) -> cca::out<"abduction", oncilla::abduction_angles> {
    const double part = p.share * std::clamp(amplitude[trot::stride{}] / p.full, 0.0, 1.0);
    oncilla::abduction_angles::vector_type angles;
    for (std::size_t leg = 0; leg < oncilla::leg_count; ++leg) {
      const double own = cca::wrap_turn(phase[trot::stride{}] + whole * p.offsets[leg]);
      const double x = oncilla::is_front(leg) ? p.front : p.hind;
      const double aside = part * turn[trot::yaw{}] * x * (p.stance / 2) * sweep(own / whole);
      angles[leg] = oncilla::side_of(leg) * aside / p.height;
    }
    return angles;
  }

private:
  static constexpr double whole = 2 * std::numbers::pi;

  double sweep(double part) const {
    if (part < p.duty) return 1 - 2 * part / p.duty;
    return -cca::math::cos(std::numbers::pi * (part - p.duty) / (1 - p.duty));
  }
};

}  // namespace walking
