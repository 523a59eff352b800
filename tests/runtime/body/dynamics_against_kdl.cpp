// Mass matrix, Coriolis terms and forward dynamics against the Orocos Kinematics and Dynamics Library, on
// random chains, trees and states.
#include <doctest/doctest.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>

#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>

#include "random_states.hpp"

using namespace body_test;
namespace cd = cca::detail;

namespace {

constexpr double exact = 1e-9;

template <std::size_t Value>
using count = std::integral_constant<std::size_t, Value>;

// KDL's torques of a motion.
template <std::size_t Count>
state<Count> torques_of(const random_tree<Count>& t,
                        const state<Count>& q,
                        const state<Count>& dq,
                        const state<Count>& ddq,
                        const Eigen::Vector3d& gravity) {
  KDL::TreeIdSolver_RNE id(t.tree, kdl(gravity));
  KDL::JntArray torques(static_cast<unsigned>(Count));
  REQUIRE(id.CartToJnt(t.joints(q), t.joints(dq), t.joints(ddq), {}, torques) >= 0);
  return in_order(t, torques);
}

}  // namespace

TEST_SUITE("against KDL") {
  TEST_CASE_TEMPLATE("mass matrix of trees", Count, count<1>, count<2>, count<3>, count<6>, count<9>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{34}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3);
      const auto ours = cd::joint_space_inertia<static_cast<int>(n)>(
          t.links, cd::composite_bodies<n>(t.links, placed(t, q), {}));
      for (int i = 0; i < static_cast<int>(n); ++i) {
        const state<n> theirs =
            torques_of<n>(t, q, state<n>::Zero(), state<n>::Unit(i), Eigen::Vector3d::Zero());
        CHECK((ours.col(i) - theirs).norm() < exact * (1 + theirs.norm()));
      }
    }
  }

  TEST_CASE_TEMPLATE("Coriolis terms of trees", Count, count<1>, count<2>, count<3>, count<6>, count<9>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{35}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 2);
      const auto c = cd::coriolis_of<static_cast<int>(n)>(t.links, placed(t, q), dq);
      const state<n> theirs = torques_of<n>(t, q, dq, state<n>::Zero(), Eigen::Vector3d::Zero());
      CHECK((c * dq - theirs).norm() < exact * (1 + theirs.norm()));
    }
  }

  // A base that accelerates equals one in another gravity.
  TEST_CASE_TEMPLATE("forward dynamics of trees", Count, count<1>, count<2>, count<3>, count<6>, count<9>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{36}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 2),
                 ddq = random_state<n>(random, 5);
      cca::base_motion base;
      base.gravity = random.vector(10);
      base.acceleration = random.vector(3);
      const state<n> torques = torques_of<n>(t, q, dq, ddq, base.gravity - base.acceleration);
      const auto ours = cd::articulated_body<false>(t.links, placed(t, q), {}, dq, torques, base,
                                                    cd::vector6(cd::vector6::Zero()));
      // Relative to the torques, through the least inertia: an error of the torques is one of ddq.
      CHECK((ours.accelerations - ddq).norm() < exact * (1 + ddq.norm() + torques.norm()));
    }
  }

  // KDL's algorithms for chains: composite bodies, and Newton-Euler of its own.
  TEST_CASE_TEMPLATE("chains", Count, count<1>, count<4>, count<7>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{37}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, true);
      KDL::Chain chain;
      REQUIRE(t.tree.getChain("base", std::to_string(n - 1), chain));
      KDL::ChainDynParam dynamics(chain, KDL::Vector(0, 0, -9.81));
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 2);
      const auto links = placed(t, q);
      KDL::JntSpaceInertiaMatrix mass(n);
      KDL::JntArray coriolis(n), angles(n), velocities(n);
      angles.data = q, velocities.data = dq;
      REQUIRE(dynamics.JntToMass(angles, mass) >= 0);
      REQUIRE(dynamics.JntToCoriolis(angles, velocities, coriolis) >= 0);
      const auto ours =
          cd::joint_space_inertia<static_cast<int>(n)>(t.links, cd::composite_bodies<n>(t.links, links, {}));
      CHECK((ours - mass.data).norm() < exact * (1 + mass.data.norm()));
      const auto c = cd::coriolis_of<static_cast<int>(n)>(t.links, links, dq);
      CHECK((c * dq - coriolis.data).norm() < exact * (1 + coriolis.data.norm()));
    }
  }
}
