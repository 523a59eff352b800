#pragma once
// The shape of the trot: the angles of hips and knees at each phase of the stride.
//
//   in  "phase"       gait_phase, of the left front leg; the other legs have offsets
//   in  "amplitude"   gait_amplitude, 0: stand; 1: the full gait
//   in  "turn"        turning: the legs of one side swing farther, those of the other side less
//   in  "lean"        leaning: hips forward or back, knees of one side flexed, of the other extended; uphill
//                     the hips swing farther, the front legs extend, and the hind legs flex
//   out "angles"      leg_angles
//
// A hip swings as a cosine of the phase, its stance stretched to `duty` of the stride. `even` blends this
// with a stance of constant speed: the trunk's speed is almost constant, so a foot that follows a cosine must
// slip. A knee flexes as a squared sine: much in swing, so that the foot clears the ground; a little in
// stance, so that the spring carries and not the cable.
//
// Uphill the hind feet carry more. Then the front feet touch the ground late and leave it early, and the hind
// feet, which push, slip. `squat` extends the front legs and flexes the hind ones.
#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace trot {

using oncilla::degrees;

struct leg_shape {
  BOOST_HANA_DEFINE_STRUCT(leg_shape,
                           (cca::quantity<cca::angle, -1.2, 1.2>, hip),  // of the standing leg
                           (cca::quantity<cca::angle, 0.6, 2.6>, knee),
                           (cca::quantity<cca::angle, 0, 1>, swing),  // of the hip, to each side
                           (cca::quantity<cca::angle, 0, 2>, lift));  // of the knee, in swing
};

struct gait {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (leg_shape, front),
                             (leg_shape, hind),
                             (cca::bounded<double, 0.2, 0.8>, duty),        // stance, as part of the stride
                             (cca::bounded<double, 0, 1>, even),            // 1: constant speed in stance
                             (cca::quantity<cca::angle, -0.5, 0.5>, give),  // flexion of the knee in stance
                             (cca::bounded<double, -0.5, 0.5>,
                              lead),  // of the knee before the hip, in strides
                             (std::array<double, 4>,
                              offsets),  // left and right front, left and right hind, in strides
                             (cca::bounded<double, 0, 3>, squat));  // of the knees, rad per rad of lean
  };
  parameters p{{degrees(47), degrees(96.6), degrees(18.3), degrees(51.6)},
               {degrees(36.1), degrees(91.8), degrees(19.3), degrees(58.4)},
               0.536,
               0.925,
               degrees(0.4),
               -0.035,
               {0.0, 0.5, 0.379, -0.121},
               0.8};

  auto process(cca::in<"phase", gait_phase> phase,
               cca::in<"amplitude", gait_amplitude> amplitude,
               cca::in<"turn", turning> turn,
               cca::in<"lean", leaning> lean) -> cca::out<"angles", oncilla::leg_angles> {
    oncilla::leg_angles::vector_type angles;
    const double squat = p.squat * std::max(0.0, -lean[pitch{}]);
    for (std::size_t leg = 0; leg < oncilla::leg_count; ++leg) {
      const leg_shape& shape = oncilla::is_front(leg) ? p.front : p.hind;
      const double own = phase[stride{}] + whole * p.offsets[leg];
      const double farther = 1 - oncilla::side_of(leg) * turn[yaw{}] - lean[pitch{}];
      angles[oncilla::hip_of(leg)] = shape.hip + lean[pitch{}] +
                                     amplitude[stride{}] * farther * shape.swing * sweep(cca::wrap_turn(own));
      angles[oncilla::knee_of(leg)] =
          shape.knee + oncilla::side_of(leg) * lean[roll{}] + (oncilla::is_front(leg) ? -squat : squat) +
          amplitude[stride{}] * flexion(cca::wrap_turn(own + whole * p.lead), shape.lift);
    }
    return angles;
  }

private:
  static constexpr double whole = 2 * std::numbers::pi, half = std::numbers::pi;

  // From 1, foremost, back to -1 in stance, and forward again in swing. The blended parts have equal slopes
  // where stance and swing meet: the cosine's are 0, the other's are the constant speed.
  double sweep(double phase) const {
    const double landing = whole * p.duty;
    const bool in_stance = phase < landing;
    const double part = in_stance ? phase / landing : (phase - landing) / (whole - landing);
    const double cosine = cca::math::cos(half * (in_stance ? part : 1 + part));
    const double slope = -2 * (1 - p.duty) / p.duty;  // of the swing, at both ends
    const double straight =
        in_stance ? 1 - 2 * part : -1 + part * (slope + part * (3 * (2 - slope) + part * 2 * (slope - 2)));
    return cosine + p.even * (straight - cosine);
  }

  double flexion(double phase, double lift) const {
    const double landing = whole * p.duty;
    const bool in_stance = phase <= landing;
    const double part = in_stance ? phase / landing : (phase - landing) / (whole - landing);
    const double height = in_stance ? static_cast<double>(p.give) : lift;
    const double sine = cca::math::sin(half * part);
    return height * sine * sine;
  }
};

}  // namespace trot
