#pragma once
// How the flange moves and what the world does to it, along the axes of the base.
#include <tuple>

#include <cca/robot/derived_of_body.hpp>

#include "spaces.hpp"

namespace touch {

// [derived]
struct flange_motion {
  auto process(cca::in<"angles", arm::angles> angles,
               cca::in<"velocities", arm::velocities> velocities,
               cca::in<"load", load_in_flange> sensed,
               cca::derived<cca::end_of<arm::body, "arm">, "angles"> end,
               cca::derived<cca::jacobian_of<arm::body, "arm">, "angles"> jacobian)
      -> std::tuple<cca::out<"twist", hand_motion>, cca::out<"load", load>> {
    const Eigen::Matrix3d& turn = end.of(angles).turn;
    load::vector_type turned;
    turned << turn * sensed.vector().head<3>(), turn * sensed.vector().tail<3>();
    return {hand_motion::vector_type(jacobian.of(angles) * velocities.vector()), turned};
  }
};
// [derived end]

}  // namespace touch
