// The components: where the joints should go, and the torques that take them there.
#pragma once

#include <tuple>

#include <cca/cca.hpp>
#include <cca/robot/body_dynamics.hpp>

#include "robot.hpp"

namespace my_robot {

// Each joint that has a motor goes slowly to and fro, from where it starts towards the farther end of its
// range, or both ways around by half a radian if it has no end.
//
//   out angles       angles
//   out velocities   velocities
struct sway {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.0, 0.9>, size),       // as a part of the way to that end
                             (cca::bounded<double, 0.5, 60.0>, seconds));  // to and fro
  };
  parameters p{0.1, 4.0};

  auto process(cca::beat now) -> std::tuple<cca::out<"angles", angles>, cca::out<"velocities", velocities>> {
    const double rate = 2 * cca::pi / p.seconds, phase = rate * 1e-9 * static_cast<double>(now.time());
    return {angles::vector_type(from + p.size * way * (1 - cca::math::cos(phase)) / 2),
            velocities::vector_type(p.size * way * rate * cca::math::sin(phase) / 2)};
  }

private:
  static angles::vector_type ways() {
    constexpr double far = 1e6;
    // What the limits of the axes leave of numbers that are too large.
    const auto low = cca::sample<angles>(angles::vector_type(angles::vector_type::Constant(-far))).clamped(),
               high = cca::sample<angles>(angles::vector_type(angles::vector_type::Constant(far))).clamped();
    const angles::vector_type at = start();
    angles::vector_type all = angles::vector_type::Zero();
    for (Eigen::Index joint = 0; joint < all.size(); ++joint) {
      if (!has_motor(joint)) continue;
      const double up = high.vector()[joint] - at[joint], down = low.vector()[joint] - at[joint];
      all[joint] = up > far / 2 ? 0.5 : up > -down ? up : down;
    }
    return all;
  }
  angles::vector_type from = start(), way = ways();
};

// Computed torque: each joint is accelerated towards its place as by a spring and a damper, and the masses of
// the whole robot, its weight and its friction say which torques that takes. So it suits a robot of any size.
//
//   in  wanted              angles
//   in  wanted_velocities   velocities
//   in  angles              angles       measured
//   in  velocities          velocities   measured
//   out torques             torques
struct follow {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::frequency, 0.1, 20>, frequency),  // of the spring, Hz
                             (cca::bounded<double, 0.0, 3.0>, damping));           // 1: no overshoot
  };
  parameters p{3.0, 1.0};

  auto process(cca::in<"wanted", angles> wanted,
               cca::in<"wanted_velocities", velocities> wanted_velocities,
               cca::in<"angles", angles> now,
               cca::in<"velocities", velocities> moving) -> cca::out<"torques", torques> {
    const double w = 2 * cca::pi * p.frequency;
    using vector = angles::vector_type;
    vector acceleration = w * w * cca::difference_of<angles>(wanted.vector(), now.vector()) +
                          2 * p.damping * w * (wanted_velocities.vector() - moving.vector());
    vector friction = moving.vector();
    for (Eigen::Index joint = 0; joint < acceleration.size(); ++joint) {
      if (!has_motor(joint)) acceleration[joint] = 0;
      friction[joint] *= description::drives[static_cast<std::size_t>(joint)].friction;
    }
    vector all =
        cca::inverse_dynamics(cca::body_pose<body>(now.vector()), moving.vector(), acceleration).torques +
        friction;
    for (Eigen::Index joint = 0; joint < all.size(); ++joint)
      if (!has_motor(joint)) all[joint] = 0;
    return all;
  }
};

}  // namespace my_robot
