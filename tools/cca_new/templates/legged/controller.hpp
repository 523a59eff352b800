// The components: the clock of the steps, what keeps the heading, and the shape of a step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include <cca/cca.hpp>

#include "robot.hpp"

namespace my_robot {

struct step : cca::dimension<"step"> {};  // one step of each leg
struct yaw : cca::dimension<"yaw"> {};

struct step_phase : cca::space<cca::phase, cca::axes<step>, cca::rate<1000>> {};
struct step_size : cca::space<cca::number, cca::axes<step>, cca::rate<1000>> {};  // 0: stand, 1: full steps
struct turning : cca::space<cca::number, cca::axes<yaw>> {};  // positive: the right legs swing farther

// The steps begin small.
//
//   out phase   step_phase   of the left front leg
//   out size    step_size
struct step_clock {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::frequency, 0, 8>, frequency),  // of the steps, Hz
                             (cca::bounded<double, 0.0, 1.2>, size),
                             (cca::quantity<cca::duration, 0.1, 10>, start));  // until the steps are full, s
  };
  parameters p{4.0, 0.85, 1.0};

  auto process(cca::beat now) -> std::tuple<cca::out<"phase", step_phase>, cca::out<"size", step_size>> {
    const double time = 1e-9 * static_cast<double>(now.time());
    return {cca::wrap_turn(2 * cca::pi * p.frequency * time), p.size * std::min(time / p.start, 1.0)};
  }
};

// Turns against the yaw of the trunk, and against its sum, which is about how far the robot has come aside.
//
//   in  orientation   orientation
//   out turn          turning
struct heading {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.0, 10.0>, gain),   // turning per rad
                             (cca::bounded<double, 0.0, 10.0>, drift),  // turning per rad s
                             (cca::bounded<double, 0.0, 1.0>, most));   // turning
  };
  parameters p{1.2, 0.4, 0.5};

  auto process(cca::in<"orientation", orientation> trunk, cca::beat now) -> cca::out<"turn", turning> {
    if (const double angle = trunk.yaw(); std::isfinite(angle)) {
      aside = std::clamp(aside + now.dt() * angle, -1.0, 1.0);
      turn = std::clamp(-p.gain * angle - p.drift * aside, -p.most, +p.most);
    }
    return turn;
  }

  double aside = 0, turn = 0;
};

struct leg_shape {
  BOOST_HANA_DEFINE_STRUCT(leg_shape,
                           (cca::quantity<cca::angle, -1.2, 1.2>, hip),  // of the standing leg
                           (cca::quantity<cca::angle, 0.6, 2.6>, knee),
                           (cca::quantity<cca::angle, 0, 1>, swing),  // of the hip, to each side
                           (cca::quantity<cca::angle, 0, 2>, lift));  // of the knee, in the air
};

// The shape of a step. In stance a foot moves back at constant speed, so that it does not slip; in the air
// the hip swings forward and the knee flexes.
//
//   in  phase    step_phase
//   in  size     step_size
//   in  turn     turning
//   out angles   angles       rad
struct gait {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (leg_shape, front),
                             (leg_shape, hind),
                             (cca::bounded<double, 0.2, 0.8>, duty),  // the part of a step on the ground
                             (std::array<double, 4>, offsets));       // of the legs, in steps
  };
  parameters p{{0.79, 1.63, 0.26, 0.70}, {0.63, 1.52, 0.32, 0.93}, 0.59, {0, 0.5, 0.373, 0.873}};

  auto process(cca::in<"phase", step_phase> phase,
               cca::in<"size", step_size> size,
               cca::in<"turn", turning> turn) -> cca::out<"angles", angles> {
    cca::out<"angles", angles> wanted;
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const leg_shape& shape = leg < 2 ? p.front : p.hind;
      const double left = leg % 2 == 0 ? 1 : -1;
      const double own = phase[step{}] / (2 * cca::pi) + p.offsets[leg], part = own - cca::math::floor(own);
      const auto joint = static_cast<Eigen::Index>(3 * leg);
      wanted.vector()[joint] = 0;
      wanted.vector()[joint + 1] =
          shape.hip + size[step{}] * (1 - left * turn[yaw{}]) * shape.swing * sweep(part);
      wanted.vector()[joint + 2] = shape.knee + size[step{}] * shape.lift * lifted(part);
    }
    return wanted;
  }

private:
  // 1 is foremost, where a foot lands; -1 is hindmost.
  double sweep(double part) const {
    if (part < p.duty) return 1 - 2 * part / p.duty;
    return -cca::math::cos(cca::pi * (part - p.duty) / (1 - p.duty));
  }
  double lifted(double part) const {
    if (part < p.duty) return 0;
    const double sine = cca::math::sin(cca::pi * (part - p.duty) / (1 - p.duty));
    return sine * sine;
  }
};

}  // namespace my_robot
