// The components: where the cart should go, and how it keeps the pole upright.
#pragma once

#include <cca/cca.hpp>

#include "robot.hpp"

namespace my_robot {

struct cart_place : cca::space<cca::joint_angles, cca::axes<cart>> {
};  // m; no rate: any planner may write it

// The cart changes sides.
//
//   out place   cart_place
struct change_sides {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.0, 0.5>, distance),   // from the middle, m
                             (cca::bounded<double, 2.0, 60.0>, seconds));  // on each side
  };
  parameters p{0.3, 4.0};

  auto process(cca::beat now) -> cca::out<"place", cart_place> {
    const double time = 1e-9 * static_cast<double>(now.time());
    const double side = cca::math::fmod(time, 2 * p.seconds) < p.seconds ? 1 : -1;
    return side * p.distance;
  }
};

// Feedback of all four coordinates. The cart runs under the pole, so all gains are positive.
//
//   in  place        cart_place   m
//   in  angles       angles       m, rad
//   in  velocities   velocities   m/s, rad/s
//   out torques      torques      N; of the pole 0
struct balance {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.0, 100.0>, place),     // N/m
                             (cca::bounded<double, 0.0, 100.0>, speed),     // N s/m
                             (cca::bounded<double, 0.0, 500.0>, tilt),      // N/rad
                             (cca::bounded<double, 0.0, 100.0>, turning));  // N s/rad
  };
  parameters p{7.7, 7.9, 47.9, 9.4};

  auto process(cca::in<"place", cart_place> goal,
               cca::in<"angles", angles> now,
               cca::in<"velocities", velocities> moving) -> cca::out<"torques", torques> {
    const double force = p.place * (now[cart{}] - goal[cart{}]) + p.speed * moving[cart{}] +
                         p.tilt * now[pole{}] + p.turning * moving[pole{}];
    return torques::vector_type{force, 0};
  }
};

}  // namespace my_robot
