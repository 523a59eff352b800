#pragma once
// A reflex that keeps the paw at the ball while the trunk sways on its springs.
//
// A Reaching Controller moves in a bell shape, a third of a second long: that is how long the trunk takes to
// sway once to and fro. A paw that follows the ball in that way comes when the ball is already on the other
// side. So near the ball the leg is given at once what its Reaching Controllers have not made up yet of the
// way to the aim.
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

//   in  "legs", "abduction"     leg_angles, abduction_angles: what the Reaching Controllers ask for
//   in  "ball", "paw", "aim"    point_in_trunk: where they are, and where to send the paw
//   in  "side"                  side_port: which paw
//   in  "step"                  step_port of the sequencer: it acts in `reach` and `touch`
//   out "angles", "abducted"    leg_angles, abduction_angles: the same, but for that leg
//
// By one damped step of Newton's method from where the leg is asked to be (compare Wampler, 1986).
struct steadying {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::length, 0, 0.2>,
                              near),  // acts within this distance of the ball
                             (cca::quantity<cca::duration, 0.001, 2>, onset),  // until it acts in full
                             (cca::quantity<cca::length, 0, 0.1>, most),       // of the way to the aim
                             (cca::quantity<cca::length, 0.0001, 0.1>,
                              damping));  // against a lever arm as short as this
  };
  parameters p{0.01, 0.1, 0.03, 0.005};

  auto process(cca::in<"legs", cca::sim::leg_angles> legs,
               cca::in<"abduction", cca::sim::abduction_angles> abduction,
               cca::in<"ball", point_in_trunk> ball,
               cca::in<"paw", point_in_trunk> paw,
               cca::in<"aim", point_in_trunk> aim,
               cca::in<"side", side_port> side,
               cca::in<"step", cca::step_port> step,
               cca::beat now) -> std::tuple<cca::out<"angles", cca::sim::leg_angles>,
                                            cca::out<"abducted", cca::sim::abduction_angles>> {
    const int now_on = static_cast<int>(step[cca::step_axis{}]);
    const bool reaching = plan::at<"reach"> <= now_on && now_on <= plan::at<"touch">;
    const bool near = (ball.vector() - paw.vector()).norm() < p.near;
    share = std::clamp(share + (reaching && near ? +1 : -1) * now.dt() / p.onset, 0.0, 1.0);

    cca::sim::leg_angles::vector_type angles = legs.vector();
    cca::sim::abduction_angles::vector_type abducted = abduction.vector();
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
    return {angles, abducted};
  }

  void on_start() { share = 0; }

private:
  // By which angles the leg's foot comes to a point.
  template <class Leg>
  Eigen::Vector3d way(const Eigen::Vector3d& joints, const Eigen::Vector3d& point) const {
    const cca::chain_pose<Leg> leg(joints);
    const Eigen::Matrix3d jacobian = leg.jacobian().template bottomRows<3>();
    const Eigen::Vector3d missing = (point - leg.tip().at).cwiseMax(-p.most).cwiseMin(+p.most);
    const Eigen::Matrix3d square =
        jacobian.transpose() * jacobian + p.damping * p.damping * Eigen::Matrix3d::Identity();
    return square.inverse() * (jacobian.transpose() * missing);
  }

  double share = 0;  // 0: as asked; 1: wholly
};

}  // namespace skills
