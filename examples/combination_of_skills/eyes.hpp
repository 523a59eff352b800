#pragma once
// The positions of ball and paw, and the point to send the paw to. All from measurements, without a model of
// the world.
#include <tuple>

#include <cca/cca.hpp>
#include <cca/mapping/kinematics.hpp>

#include "legs.hpp"

namespace skills {

// A camera on the trunk. The program, or a driver, sets whether it sees the ball, and where.
struct camera {
  auto sense() -> cca::maybe<"ball", point_in_trunk> {
    if (!sees) return {};
    return ball;
  }

  Eigen::Vector3d ball{0, 0, 0};
  bool sees = false;
};

// The way to walk until the ball is in reach of a front paw, m.
inline constexpr double reach_ahead =
    0.096;  // of the hip; less than it reaches, since a push can end a stop early
inline double way_left(const cca::sample<point_in_trunk>& ball) {
  return ball[cca::x{}] - hip_in_trunk(0)[0] - reach_ahead;
}

// Is the robot near enough to the ball to stop?
//
//   in  "ball"     point_in_trunk
//   out "status"   ball_status
struct ball_watch {
  auto process(cca::in<"ball", point_in_trunk> ball) -> cca::out<"status", ball_status> {
    if (ball.origin() == cca::never) return cca::status_of(ball_state::unseen);
    return cca::status_of(way_left(ball) < 0 ? ball_state::near : ball_state::ahead);
  }
};

// The position of the front paw that is nearer to the ball, by forward kinematics of the measured angles. The
// side is chosen when the ball is first seen, and kept: later a little yaw could change it.
//
//   in  "ball"                    point_in_trunk
//   in  "angles", "abducted"      of the robot
//   in  "contacts"                foot_contacts
//   out "paw"                     point_in_trunk
//   out "side"                    side_port
//   out "status"                  paw_status
struct nearer_paw {
  auto process(cca::in<"ball", point_in_trunk> ball,
               cca::in<"angles", oncilla::leg_angles> angles,
               cca::in<"abducted", oncilla::abduction_angles> abducted,
               cca::in<"contacts", oncilla::foot_contacts> contacts) -> std::
      tuple<cca::out<"paw", point_in_trunk>, cca::out<"side", side_port>, cca::out<"status", paw_status>> {
    if (!settled && ball.origin() != cca::never) {
      settled = true;
      right = ball[cca::y{}] < 0;
    }
    const int leg = right ? 1 : 0;
    const Eigen::Vector3d joints(abducted.vector()[leg], angles.vector()[leg], angles.vector()[4 + leg]);
    const Eigen::Vector3d paw =
        right ? cca::chain_pose<right_front>(joints).tip().at : cca::chain_pose<left_front>(joints).tip().at;
    return {paw, cca::status_of(right ? paw_side::right : paw_side::left),
            cca::status_of(contacts.vector()[leg] != 0 ? paw_state::grounded : paw_state::raised)};
  }

private:
  bool settled = false, right = false;
};

// The point to send the paw to: the ball, plus the integral of the paw's error (springs yield, gravity
// pulls). It integrates only near the ball.
//
//   in  "ball", "paw"   point_in_trunk
//   out "aim"           point_in_trunk
struct aim {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 20>, gain),          // 1/s
                             (cca::quantity<cca::length, 0, 0.2>, near),   // integrates within this distance
                             (cca::quantity<cca::length, 0, 0.1>, most));  // along each axis
  };
  parameters p{3.0, 0.03, 0.03};

  auto process(cca::in<"ball", point_in_trunk> ball, cca::in<"paw", point_in_trunk> paw, cca::beat now)
      -> cca::out<"aim", point_in_trunk> {
    const Eigen::Vector3d missing = ball.vector() - paw.vector();
    if (missing.norm() < p.near)
      correction = (correction + p.gain * now.dt() * missing).cwiseMax(-p.most).cwiseMin(+p.most).eval();
    else correction.setZero();
    return Eigen::Vector3d(ball.vector() + correction);
  }

private:
  Eigen::Vector3d correction{0, 0, 0};
};

}  // namespace skills
