// The dynamics of the arm of dynamics.cpp by Pinocchio 3, whose model is built from the same numbers.
//
//   pinocchio_dynamics NAME cca|pinocchio ROUNDS   (two_ways.hpp)
//
// Debian has no Pinocchio: `measure.py --only pinocchio --pinocchio FOLDER` compiles this against its
// headers. The calls are those of its own benchmarks: the data are made once, each round begins with the
// angles.
#include <cstdio>
#include <string_view>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody/data.hpp>
#include <pinocchio/multibody/model.hpp>

#include <cca/robot/dynamics/forward_dynamics.hpp>

#include "arm.hpp"
#include "two_ways.hpp"

namespace bench {

using vector = Eigen::Matrix<double, 7, 1>;
using pose = cca::body_pose<arm>;

struct state {
  vector q, dq, input;  // the input: accelerations or torques
};

inline Eigen::Vector3d of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

pinocchio::Model pinocchio_arm() {
  pinocchio::Model model;
  pinocchio::JointIndex last = 0;
  for (std::size_t i = 0; i < arm_chain::joints.size(); ++i) {
    const cca::joint& j = arm_chain::joints[i];
    const cca::link_inertia& link = arm_chain::links[i];
    const auto& m = link.about_centre;
    const pinocchio::SE3 where(Eigen::Matrix3d::Identity(), of(j.where.translation));
    const std::string name = std::to_string(i);
    // Its joints about an axis of the frame have a type each, which is its fastest form.
    if (j.axis[2] == 1) last = model.addJoint(last, pinocchio::JointModelRZ(), where, name);
    else last = model.addJoint(last, pinocchio::JointModelRY(), where, name);
    Eigen::Matrix3d about;
    about << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
    model.appendBodyToJoint(last, pinocchio::Inertia(link.mass, of(link.centre), about));
  }
  return model;
}

struct by_pinocchio {
  static constexpr const char* name = "Pinocchio";
  pinocchio::Model model = pinocchio_arm();
  pinocchio::Data data{model};
  Eigen::VectorXd q = Eigen::VectorXd::Zero(7), dq = q, input = q;

  void take(const state& s) { q = s.q, dq = s.dq, input = s.input; }
};

struct mass_matrix {
  static constexpr const char* name = "mass matrix";
  static Eigen::Matrix<double, 7, 7> cca(const state& s) { return cca::mass_matrix(pose(s.q)); }
  static Eigen::Matrix<double, 7, 7> other(by_pinocchio& p) {
    ::pinocchio::crba(p.model, p.data, p.q, ::pinocchio::Convention::WORLD);
    return p.data.M.selfadjointView<Eigen::Upper>();
  }
};
struct gravity {
  static constexpr const char* name = "gravity torques";
  static vector cca(const state& s) { return cca::gravity_torques(pose(s.q)); }
  static vector other(by_pinocchio& p) {
    return ::pinocchio::computeGeneralizedGravity(p.model, p.data, p.q);
  }
};
struct inverse {
  static constexpr const char* name = "inverse dynamics";
  static vector cca(const state& s) { return cca::inverse_dynamics(pose(s.q), s.dq, s.input).torques; }
  static vector other(by_pinocchio& p) { return ::pinocchio::rnea(p.model, p.data, p.q, p.dq, p.input); }
};
struct forward {
  static constexpr const char* name = "forward dynamics";
  static vector cca(const state& s) { return cca::forward_dynamics(pose(s.q), s.dq, s.input); }
  static vector other(by_pinocchio& p) {
    return ::pinocchio::aba(p.model, p.data, p.q, p.dq, p.input, ::pinocchio::Convention::LOCAL);
  }
};

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::beside_another<bench::state, bench::by_pinocchio>, bench::mass_matrix,
                        bench::gravity, bench::inverse, bench::forward>(argc, argv);
}
