#pragma once
// The oscillator of the trot: a point that runs around the origin, on a circle of the wanted radius. For a
// negative amplitude the circle shrinks to a point (a Hopf bifurcation; the source document, section 6.3):
// the legs come to rest where they stand.
//
//   in  "amplitude"   wanted_amplitude, the radius of the circle
//   out "phase"       gait_phase
//   out "amplitude"   gait_amplitude, the radius now
//
// x' = g x - w y, y' = g y + w x with w = 2 pi f and g = c (1 - r^2 / a^2): the normal form of the Hopf
// bifurcation in units of the circle, so the point approaches a small circle as fast as a large one. The
// library's cca::hopf has g = c (a |a| - r^2): it approaches a small circle slower. Euler's method; at 1 ms
// the radius errs by 1 %, the frequency by 0.01 %.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <Eigen/Core>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace trot {

struct stride_oscillator {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::frequency, 0, 10>, frequency),  // Hz
                             (cca::bounded<double, 0, 100>, convergence));       // 1/s
  };
  parameters p{4.0, 10.0};

  auto process(cca::in<"amplitude", wanted_amplitude> wanted, cca::beat now)
      -> std::tuple<cca::out<"phase", gait_phase>, cca::out<"amplitude", gait_amplitude>> {
    const double amplitude = wanted[stride{}];
    const double square = state.squaredNorm();
    double growth = amplitude > 0 ? std::max(-1.0, 1 - square / (amplitude * amplitude)) : -1.0;
    if (amplitude <= 0 && square < rest * rest) growth = 0;  // so that it can wake up again
    const double along = p.convergence * growth, around = 2 * std::numbers::pi * p.frequency;
    state += now.dt() *
             Eigen::Vector2d(along * state.x() - around * state.y(), along * state.y() + around * state.x());
    return {cca::math::atan2(state.y(), state.x()), cca::math::sqrt(state.squaredNorm())};
  }

  void on_start() { state = {rest, 0}; }

private:
  static constexpr double rest = 0.01;
  Eigen::Vector2d state{rest, 0};
};

}  // namespace trot
