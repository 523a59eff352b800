#pragma once
// How the flange moves and what the world does to it, along the axes of the base.
#include <tuple>

#include <cca/robot/body_pose.hpp>

#include "spaces.hpp"

namespace touch {

struct flange_motion {
  auto process(cca::in<"angles", arm::angles> angles,
               cca::in<"velocities", arm::velocities> velocities,
               cca::in<"load", load_in_flange> sensed)
      -> std::tuple<cca::out<"twist", hand_motion>, cca::out<"load", load>> {
    const cca::body_pose<arm::body> now(angles.vector());
    const Eigen::Matrix3d turn = now.tip<"arm">().turn;
    load::vector_type turned;
    turned << turn * sensed.vector().head<3>(), turn * sensed.vector().tail<3>();
    return {hand_motion::vector_type(now.jacobian<"arm">() * velocities.vector()), turned};
  }
};

}  // namespace touch
