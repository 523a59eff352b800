// The components: the way of the hand, and what makes it compliant.
#pragma once

#include <algorithm>
#include <tuple>

#include <Eigen/Core>

#include <cca/cca.hpp>
#include <cca/robot/body_pose.hpp>
#include <cca/robot/compliance/cartesian_impedance.hpp>

#include "robot.hpp"

namespace my_robot {

// An upright circle, which begins where the arm starts.
//
//   out pose     hand          m
//   out motion   hand_motion   rad/s, m/s
struct circle {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.0, 0.15>, radius),    // m
                             (cca::bounded<double, 1.0, 60.0>, seconds));  // a turn
  };
  parameters p{0.1, 4.0};

  auto process(cca::beat now) -> std::tuple<cca::out<"pose", hand>, cca::out<"motion", hand_motion>> {
    const double rate = 2 * cca::pi / p.seconds, angle = rate * 1e-9 * static_cast<double>(now.time());
    // It speeds up in the first turn, so that the arm begins at rest.
    const double s = std::min(angle / (2 * cca::pi), 1.0), size = p.radius * s * s * (3 - 2 * s),
                 growth = s < 1 ? p.radius * 6 * s * (1 - s) / p.seconds : 0;
    cca::out<"pose", hand> pose;
    cca::out<"motion", hand_motion> motion;
    const auto [sine, cosine] = cca::math::sine_and_cosine(angle);
    const Eigen::Vector3d way(0, sine, 1 - cosine), change(0, cosine, sine);
    pose.vector() << start.at + size * way, start_turn;
    motion.vector() << 0, 0, 0, size * rate * change + growth * way;
    return {pose, motion};
  }

  cca::rigid start = cca::body_pose<body>(angles::vector_type::Map(description::start.data())).tip<"arm">();
  Eigen::Vector4d start_turn = cca::rotation::from_matrix(start.turn);
};

// The hand is a spring and a damper about the way. Its parameters: `stiffness` about and along x, y, z
// (N m/rad, N/m), `damping_ratio`, and others; cca's docs/compliance.md.
struct compliance : cca::cartesian_impedance<body, "arm", angles, velocities, torques> {
  compliance() { p.stiffness << 30, 30, 30, 800, 800, 800; }
};

}  // namespace my_robot
