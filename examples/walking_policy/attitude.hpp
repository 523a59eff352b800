#pragma once
// From the orientation of the trunk to what the policy observes of it. The policy has no memory, so sums over
// time are made here.
//
//   in  "orientation"   trunk_orientation
//   out "down"          downwards
//   out "course"        course: how far the robot has turned, about how far it has walked aside, and the mean
//                       pitch, which on a slope is that of the ground
//
// An orientation that is not finite passes to "down", so that the policy sees it; "course" stays as it is.
#include <algorithm>
#include <cmath>
#include <tuple>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace walking {

struct attitude {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::duration, 0.01, 60>, average),  // of the pitch
                             (cca::bounded<double, 0, 10>, farthest));           // of the integral, rad s
  };
  parameters p{1.0, 1.25};

  auto process(cca::in<"orientation", oncilla::trunk_orientation> trunk, cca::beat now)
      -> std::tuple<cca::out<"down", downwards>, cca::out<"course", course>> {
    const double yaw = trunk.yaw(), pitch = trunk.pitch();
    if (std::isfinite(yaw + pitch)) {
      at[0] = yaw;
      at[1] = std::clamp(at[1] + now.dt() * yaw, -p.farthest, +p.farthest);
      at[2] += std::min(1.0, now.dt() / p.average) * (pitch - at[2]);
    }
    const auto& q = trunk.vector();  // x, y, z, w; the last row of its rotation matrix is the way up
    return {Eigen::Vector3d(2 * (q[3] * q[1] - q[0] * q[2]), -2 * (q[1] * q[2] + q[3] * q[0]),
                            2 * (q[0] * q[0] + q[1] * q[1]) - 1),
            at};
  }

private:
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

}  // namespace walking
