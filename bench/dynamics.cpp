// The dynamics of an arm of seven joints, by the library and by Orocos KDL.
//
//   dynamics NAME cca|kdl ROUNDS   (two_ways.hpp)
//
// Each round begins with the angles: no side reuses the kinematics of the round before. KDL's solvers are
// made once.
#include <cstdio>
#include <string_view>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>

#include "arm.hpp"
#include "two_ways.hpp"

namespace bench {

using vector = Eigen::Matrix<double, 7, 1>;
using pose = cca::body_pose<arm>;

struct state {
  vector q, dq, input;  // the input: accelerations or torques
};

KDL::Chain with_flange(KDL::Chain chain) {
  const auto& tip = arm_chain::tip.translation;
  chain.addSegment(KDL::Segment("flange", KDL::Joint("flange", KDL::Joint::None),
                                KDL::Frame(KDL::Vector(tip[0], tip[1], tip[2]))));
  return chain;
}

struct by_kdl {
  static constexpr const char* name = "KDL";
  KDL::Chain chain = kdl_arm();
  KDL::ChainDynParam parameters{chain, KDL::Vector(0, 0, -9.81)};
  KDL::ChainIdSolver_RNE inverse{chain, KDL::Vector(0, 0, -9.81)};
  KDL::ChainFdSolver_RNE forward{chain, KDL::Vector(0, 0, -9.81)};
  KDL::Chain to_flange = with_flange(chain);
  KDL::ChainJntToJacSolver jacobians{to_flange};
  KDL::JntArray q{7}, dq{7}, input{7}, result{7};
  KDL::JntSpaceInertiaMatrix mass{7};
  KDL::Jacobian jacobian{7};
  KDL::Wrenches none{7};

  void take(const state& s) { q.data = s.q, dq.data = s.dq, input.data = s.input; }
};

struct mass_matrix {
  static constexpr const char* name = "mass matrix";
  static Eigen::Matrix<double, 7, 7> cca(const state& s) { return cca::mass_matrix(pose(s.q)); }
  static Eigen::Matrix<double, 7, 7> other(by_kdl& k) {
    k.parameters.JntToMass(k.q, k.mass);
    return k.mass.data;
  }
};
struct coriolis {
  static constexpr const char* name = "Coriolis torques";
  static vector cca(const state& s) { return cca::coriolis_torques(pose(s.q), s.dq); }
  static vector other(by_kdl& k) {
    k.parameters.JntToCoriolis(k.q, k.dq, k.result);
    return k.result.data;
  }
};
struct gravity {
  static constexpr const char* name = "gravity torques";
  static vector cca(const state& s) { return cca::gravity_torques(pose(s.q)); }
  static vector other(by_kdl& k) {
    k.parameters.JntToGravity(k.q, k.result);
    return k.result.data;
  }
};
struct inverse {
  static constexpr const char* name = "inverse dynamics";
  static vector cca(const state& s) { return cca::inverse_dynamics(pose(s.q), s.dq, s.input).torques; }
  static vector other(by_kdl& k) {
    k.inverse.CartToJnt(k.q, k.dq, k.input, k.none, k.result);
    return k.result.data;
  }
};
struct forward {
  static constexpr const char* name = "forward dynamics";
  static vector cca(const state& s) { return cca::forward_dynamics(pose(s.q), s.dq, s.input); }
  static vector other(by_kdl& k) {
    k.forward.CartToJnt(k.q, k.dq, k.input, k.none, k.result);
    return k.result.data;
  }
};
struct jacobian {
  static constexpr const char* name = "Jacobian";
  static Eigen::Matrix<double, 6, 7> cca(const state& s) { return pose(s.q).jacobian<"arm">(); }
  static Eigen::Matrix<double, 6, 7> other(by_kdl& k) {
    k.jacobians.JntToJac(k.q, k.jacobian);
    Eigen::Matrix<double, 6, 7> j;
    j << k.jacobian.data.bottomRows<3>(), k.jacobian.data.topRows<3>();
    return j;
  }
};

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::beside_another<bench::state, bench::by_kdl>, bench::mass_matrix,
                        bench::coriolis, bench::gravity, bench::inverse, bench::forward, bench::jacobian>(
      argc, argv);
}
