// Kinematics and dynamics against the Orocos Kinematics and Dynamics Library, on random chains, trees and
// states.
#include <doctest/doctest.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <kdl/treejnttojacsolver.hpp>

#include "random_states.hpp"

using namespace body_test;

namespace {

constexpr double exact = 1e-10;

template <std::size_t Value>
using count = std::integral_constant<std::size_t, Value>;

}  // namespace

TEST_SUITE("against KDL") {
  TEST_CASE_TEMPLATE("positions of the links, and their Jacobians", Count, count<1>, count<2>, count<3>,
                     count<6>, count<9>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{31}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3);
      const auto links = placed(t, q);
      KDL::TreeFkSolverPos_recursive fk(t.tree);
      KDL::TreeJntToJacSolver jac(t.tree);
      for (std::size_t i = 0; i < n; ++i) {
        KDL::Frame frame;
        REQUIRE(fk.JntToCart(t.joints(q), frame, std::to_string(i)) >= 0);
        CHECK((links[i].frame.at - eigen(frame.p)).norm() < exact);
        CHECK((links[i].frame.turn - eigen(frame.M)).norm() < exact);

        Eigen::Matrix<double, 6, static_cast<int>(n)> ours;
        cca::detail::fill_jacobian(t.links, links, static_cast<int>(i), links[i].frame.at, ours);
        KDL::Jacobian theirs(static_cast<unsigned>(n));
        REQUIRE(jac.JntToJac(t.joints(q), theirs, std::to_string(i)) >= 0);
        for (std::size_t k = 0; k < n; ++k) {
          const KDL::Twist column = theirs.getColumn(static_cast<unsigned>(t.number(k)));
          CHECK((ours.col(static_cast<int>(k)).template head<3>() - eigen(column.rot)).norm() < exact);
          CHECK((ours.col(static_cast<int>(k)).template tail<3>() - eigen(column.vel)).norm() < exact);
        }
      }
    }
  }

  // The base of KDL's trees cannot move; an accelerating base equals a base in another gravity.
  TEST_CASE_TEMPLATE("inverse dynamics and gravity", Count, count<1>, count<2>, count<3>, count<6>,
                     count<9>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{32}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 2),
                 ddq = random_state<n>(random, 5);
      const auto links = placed(t, q);
      cca::base_motion base;
      base.gravity = random.vector(10);
      base.acceleration = random.vector(3);
      KDL::TreeIdSolver_RNE id(t.tree, kdl(Eigen::Vector3d(base.gravity - base.acceleration)));
      KDL::JntArray torques(static_cast<unsigned>(n));
      const auto ours = cca::detail::newton_euler<n, static_cast<int>(n)>(t.links, links, {}, dq, ddq, base);
      REQUIRE(id.CartToJnt(t.joints(q), t.joints(dq), t.joints(ddq), {}, torques) >= 0);
      const auto theirs = in_order(t, torques);
      CHECK((ours.torques - theirs).norm() < exact * (1 + theirs.norm()));

      // At rest.
      using vector = Eigen::Matrix<double, static_cast<int>(n), 1>;
      const vector zero = vector::Zero();
      KDL::TreeIdSolver_RNE resting(t.tree, kdl(base.gravity));
      REQUIRE(resting.CartToJnt(t.joints(q), t.joints(zero), t.joints(zero), {}, torques) >= 0);
      const auto held = cca::detail::torques_at_rest<static_cast<int>(n)>(t.links, links, base.gravity);
      CHECK((held - in_order(t, torques)).norm() < exact * (1 + held.norm()));
    }
  }

  // Mass matrix and gravity by KDL's other algorithm (composite rigid bodies; chains only).
  TEST_CASE("mass matrix, Coriolis and gravity terms of a chain") {
    constexpr std::size_t n = 6;
    using vector = Eigen::Matrix<double, static_cast<int>(n), 1>;
    laws::source random{std::mt19937_64{33}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, true);
      KDL::Chain chain;
      REQUIRE(t.tree.getChain("base", std::to_string(n - 1), chain));
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 2),
                 ddq = random_state<n>(random, 5);
      const auto links = placed(t, q);
      cca::base_motion base;
      KDL::ChainDynParam dynamics(chain, kdl(base.gravity));
      KDL::JntSpaceInertiaMatrix mass(n);
      KDL::JntArray coriolis(n), gravity(n), angles(n), velocities(n);
      angles.data = q, velocities.data = dq;
      REQUIRE(dynamics.JntToMass(angles, mass) >= 0);
      REQUIRE(dynamics.JntToCoriolis(angles, velocities, coriolis) >= 0);
      REQUIRE(dynamics.JntToGravity(angles, gravity) >= 0);
      const vector theirs = mass.data * ddq + coriolis.data + gravity.data;
      const vector ours =
          cca::detail::newton_euler<n, static_cast<int>(n)>(t.links, links, {}, dq, ddq, base).torques;
      CHECK((ours - theirs).norm() < exact * (1 + theirs.norm()));
      CHECK((cca::detail::torques_at_rest<static_cast<int>(n)>(t.links, links, base.gravity) - gravity.data)
                .norm() < exact * (1 + gravity.data.norm()));
    }
  }
}
