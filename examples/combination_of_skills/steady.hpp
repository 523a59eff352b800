#pragma once
// A reflex that keeps the paw at the ball while the trunk sways on its springs.
//
// A Reaching Controller moves in a bell shape, a third of a second long, and the trunk sways once to and fro
// in the same time. So a paw that follows the ball with it arrives when the ball is on the other side. Near
// the ball, this component therefore adds to the leg at once the rest of the way to the aim.
#include <algorithm>
#include <cstddef>
#include <tuple>

#include <Eigen/LU>

#include <cca/adaptive/sequencer.hpp>
#include <cca/cca.hpp>
#include <cca/mapping/kinematics.hpp>

#include "legs.hpp"
#include "plan.hpp"

namespace skills {

//   in  "legs", "abduction"     leg_angles, abduction_angles: from the Reaching Controllers
//   in  "ball", "paw", "aim"    point_in_trunk: positions, and the point to send the paw to
//   in  "side"                  side_port: which paw
//   in  "step"                  step_port of the sequencer: acts in `reach` and `touch`
//   out "angles", "abducted"    leg_angles, abduction_angles: changed for that leg
//
// One damped step of Newton's method from the wanted angles of the leg (compare Wampler, 1986).
struct steadying {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::length, 0, 0.2>,
                              near),  // acts within this distance of the ball
                             (cca::quantity<cca::duration, 0.001, 2>, onset),  // until it acts in full
                             (cca::quantity<cca::length, 0, 0.1>, most),       // of the way to the aim
                             (cca::quantity<cca::length, 0.0001, 0.1>,
                              damping));  // of the Jacobian, m
  };
  parameters p{0.01, 0.1, 0.03, 0.005};

  auto process(cca::in<"legs", oncilla::leg_angles> legs,
               cca::in<"abduction", oncilla::abduction_angles> abduction,
               cca::in<"ball", point_in_trunk> ball,
               cca::in<"paw", point_in_trunk> paw,
               cca::in<"aim", point_in_trunk> aim,
               cca::in<"side", side_port> side,
               cca::in<"step", cca::step_port> step,
               cca::beat now) -> std::tuple<cca::out<"angles", oncilla::leg_angles>,
                                            cca::out<"abducted", oncilla::abduction_angles>> {
    const int now_on = static_cast<int>(step[cca::step_axis{}]);
    const bool reaching = plan::at<"reach"> <= now_on && now_on <= plan::at<"touch">;
    const bool near = (ball.vector() - paw.vector()).norm() < p.near;
    share = std::clamp(share + (reaching && near ? +1 : -1) * now.dt() / p.onset, 0.0, 1.0);

    oncilla::leg_angles::vector_type angles = legs.vector();
    oncilla::abduction_angles::vector_type abducted = abduction.vector();
    if (share > 0) {
      const bool right = side.is(paw_side::right);
      const int leg = right ? 1 : 0;
      const Eigen::Vector3d asked(abducted[leg], angles[leg], angles[4 + leg]);
      const Eigen::Vector3d more =
          share * (right ? way<right_front>(asked, aim.vector()) : way<left_front>(asked, aim.vector()));
      abducted[leg] += more[0];
      angles[leg] += more[1];
      angles[4 + leg] += more[2];
    }
    // The aim rests while no paw reaches; what it says then has no part in the angles.
    const std::int64_t origin =
        share > 0 ? oldest_origin(legs, abduction, aim) : oldest_origin(legs, abduction);
    return {cca::out<"angles", oncilla::leg_angles>(angles).with_origin(origin),
            cca::out<"abducted", oncilla::abduction_angles>(abducted).with_origin(origin)};
  }

  void on_start() { share = 0; }

private:
  // The change of angles that brings the leg's foot to a point.
  template <class Leg>
  Eigen::Vector3d way(const Eigen::Vector3d& joints, const Eigen::Vector3d& point) const {
    const cca::chain_pose<Leg> leg(joints);
    const Eigen::Matrix3d jacobian = leg.jacobian().template bottomRows<3>();
    const Eigen::Vector3d missing = (point - leg.tip().at).cwiseMax(-p.most).cwiseMin(+p.most);
    const Eigen::Matrix3d square =
        jacobian.transpose() * jacobian + p.damping * p.damping * Eigen::Matrix3d::Identity();
    return square.inverse() * (jacobian.transpose() * missing);
  }

  double share = 0;  // of the correction, 0 to 1
};

}  // namespace skills
