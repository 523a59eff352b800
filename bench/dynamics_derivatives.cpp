// The derivatives of the dynamics of an arm of seven joints and of a quadruped of twelve, whose bases stand,
// and the arm's Coriolis matrix, momentum and operational space: recorded at compile time, and by the loops
// that larger bodies use.
//
//   dynamics_derivatives NAME cca|loops ROUNDS      (two_ways.hpp)
//
// Each round begins with the angles; operational space with mass matrix and Jacobian.
#include <cstdio>
#include <string_view>

#include <cca/robot/dynamics/derivatives.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/robot/dynamics/momentum.hpp>
#include <cca/robot/dynamics/operational_space.hpp>

#include "arm.hpp"
#include "quadruped.hpp"
#include "two_ways.hpp"

namespace bench {

namespace cd = cca::detail;

template <class Body>
struct state_of {
  static constexpr int n = cca::axes_of<Body>::count;
  Eigen::Matrix<double, n, 1> q, dq, input;  // the input: accelerations or torques

  cca::body_pose<Body> pose() const { return cca::body_pose<Body>(q); }
};
struct state {
  state_of<arm> of_arm;
  state_of<quadruped> of_quadruped;
  Eigen::Matrix<double, 7, 7> mass;  // of the arm, and of its end the Jacobian
  Eigen::Matrix<double, 6, 7> jacobian;
};
template <class Derivatives>
auto all_of(const Derivatives& d) {
  constexpr int n = decltype(d.by_angles)::RowsAtCompileTime;
  Eigen::Matrix<double, n, 3 * n + 1> all;
  if constexpr (requires { d.torques; }) all << d.torques, d.by_angles, d.by_velocities, d.by_accelerations;
  else all << d.accelerations, d.by_angles, d.by_velocities, d.by_torques;
  return all;
}

template <class Body>
auto placed(const state_of<Body>& s) {
  std::array<cd::placed_link, cd::weighed_links_of<Body>.size()> all;
  cd::place_links(cd::weighed_links_of<Body>, s.q, all);
  return all;
}
template <class Body>
auto inverse_by_loops(const state_of<Body>& s) {
  constexpr const auto& links = cd::weighed_links_of<Body>;
  return all_of(
      cd::derivatives_of_torques<state_of<Body>::n, links.size()>(links, placed(s), s.dq, s.input, {}));
}

struct inverse_of_arm {
  static constexpr const char* name = "derivatives of inverse dynamics of the arm";
  static auto cca(const state& s) {
    return all_of(cca::inverse_dynamics_derivatives(s.of_arm.pose(), s.of_arm.dq, s.of_arm.input));
  }
  static auto loops(const state& s) { return inverse_by_loops(s.of_arm); }
};
struct forward_of_arm {
  static constexpr const char* name = "derivatives of forward dynamics of the arm";
  static auto cca(const state& s) {
    return all_of(cca::forward_dynamics_derivatives(s.of_arm.pose(), s.of_arm.dq, s.of_arm.input));
  }
  static auto loops(const state& both) {
    constexpr const auto& links = cd::weighed_links_of<arm>;
    const auto& s = both.of_arm;
    const auto now = placed(s);
    const cd::vector6 none = cd::vector6::Zero();
    const auto ddq = cd::articulated_body<false>(links, now, {}, s.dq, s.input, {}, none).accelerations;
    return all_of(cd::derivatives_of_solution<arm>(
        ddq, cd::derivatives_of_torques<7, links.size()>(links, now, s.dq, ddq, {})));
  }
};
struct inverse_of_quadruped {
  static constexpr const char* name = "derivatives of inverse dynamics of the quadruped";
  static auto cca(const state& both) {
    const auto& s = both.of_quadruped;
    return all_of(cca::inverse_dynamics_derivatives(s.pose(), s.dq, s.input));
  }
  static auto loops(const state& s) { return inverse_by_loops(s.of_quadruped); }
};

struct coriolis_of_arm {
  static constexpr const char* name = "Coriolis matrix of the arm";
  static auto cca(const state& s) { return cca::coriolis_matrix(s.of_arm.pose(), s.of_arm.dq); }
  static auto loops(const state& s) {
    return cd::coriolis_of<7>(cd::weighed_links_of<arm>, placed(s.of_arm), s.of_arm.dq);
  }
};

struct momentum_of_arm {
  static constexpr const char* name = "momentum of the arm and its change";
  static auto joined(const cca::joint_momentum_result<7>& r) {
    Eigen::Matrix<double, 7, 2> both;
    both << r.momentum, r.change;
    return both;
  }
  static auto cca(const state& s) { return joined(cca::joint_momentum(s.of_arm.pose(), s.of_arm.dq)); }
  static auto loops(const state& s) {
    return joined(cd::momentum_of_joints<7>(cd::weighed_links_of<arm>, placed(s.of_arm), s.of_arm.dq));
  }
};

template <int Rows>
struct operational_space_of_arm {
  static constexpr const char* name =
      Rows == 6 ? "operational space of the arm" : "operational space of the arm, position alone";
  using rows = Eigen::Matrix<double, Rows, 7>;
  static rows of(const state& s) { return s.jacobian.template bottomRows<Rows>(); }
  static auto joined(const Eigen::Matrix<double, Rows, Rows>& inertia,
                     const Eigen::Matrix<double, 7, Rows>& inverse) {
    Eigen::Matrix<double, 7 + Rows, Rows> both;
    both << inertia, inverse;
    return both;
  }
  static auto cca(const state& s) {
    const cca::operational_space task(s.mass, of(s));
    return joined(task.inertia, task.inverse);
  }
  static auto loops(const state& s) {
    Eigen::Matrix<double, Rows, Rows> inertia;
    Eigen::Matrix<double, 7, Rows> inverse;
    cd::operational_space_by_loops(s.mass, of(s), inertia, inverse);
    return joined(inertia, inverse);
  }
};

struct states {
  static constexpr double tolerance = 1e-10;
  static state next(int round) {
    state s;
    spread(s.of_arm, round), spread(s.of_quadruped, round);
    const auto now = s.of_arm.pose();
    s.mass = cca::mass_matrix(now), s.jacobian = now.template jacobian<"arm">();
    return s;
  }
};

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::beside_loops<bench::states>, bench::inverse_of_arm, bench::forward_of_arm,
                        bench::inverse_of_quadruped, bench::coriolis_of_arm, bench::momentum_of_arm,
                        bench::operational_space_of_arm<6>, bench::operational_space_of_arm<3>>(argc, argv);
}
