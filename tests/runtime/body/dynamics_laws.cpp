// The laws of dynamics, on random trees and on bodies.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/dynamics/momentum.hpp>
#include <cca/robot/dynamics/operational_space.hpp>

#include "bodies.hpp"
#include "random_states.hpp"

using namespace body_test;
namespace cd = cca::detail;

namespace {

constexpr double exact = 1e-9;

template <std::size_t Value>
using count = std::integral_constant<std::size_t, Value>;

template <std::size_t Count>
auto mass_of(const random_tree<Count>& t, const state<Count>& q) {
  return cd::joint_space_inertia<static_cast<int>(Count)>(
      t.links, cd::composite_bodies<Count>(t.links, placed(t, q), {}));
}

template <class Body>
auto random_coordinates(laws::source& random, double size) {
  typename cca::body_pose<Body>::vector_type v;
  for (auto& x : v) x = random(-size, size);
  return v;
}

cca::base_motion random_base(laws::source& random) {
  cca::base_motion base;
  base.gravity = random.vector(10);
  base.angular_velocity = random.vector(2);
  base.angular_acceleration = random.vector(3);
  base.acceleration = random.vector(5);
  return base;
}

}  // namespace

TEST_SUITE("dynamics") {
  TEST_CASE_TEMPLATE("the mass matrix is symmetric, positive definite, and gives the energy", Count, count<1>,
                     count<3>, count<6>, count<9>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{61}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 2);
      const auto m = mass_of<n>(t, q);
      CHECK((m - m.transpose()).norm() == 0);
      CHECK(m.llt().info() == Eigen::Success);
      // Of the links one by one, from the velocities of their centres.
      double energy = 0;
      const auto links = placed(t, q);
      for (std::size_t i = 0; i < n; ++i) {
        const auto& of = t.links[i].inertia;
        const Eigen::Vector3d centre =
            links[i].frame.at + links[i].frame.turn * Eigen::Vector3d::Map(of.centre.data());
        Eigen::Matrix<double, 6, static_cast<int>(n)> j;
        cd::fill_jacobian(t.links, links, static_cast<int>(i), centre, j);
        const Eigen::Matrix<double, 6, 1> v = j * dq;
        const Eigen::Vector3d w = links[i].frame.turn.transpose() * v.head<3>();
        energy += 0.5 * (of.mass * v.tail<3>().squaredNorm() + w.dot(cd::matrix_of(of.about_centre) * w));
      }
      CHECK(std::abs(0.5 * dq.dot(m * dq) - energy) < exact * (1 + energy));
    }
  }

  TEST_CASE_TEMPLATE("dM/dt - 2 C is skew-symmetric", Count, count<1>, count<2>, count<5>, count<8>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{62}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 1);
      const auto change = slope([&](double h) { return mass_of<n>(t, q + h * dq); });
      const auto c = cd::coriolis_of<static_cast<int>(n)>(t.links, placed(t, q), dq);
      CHECK((change - c - c.transpose()).norm() < exact * (1 + change.norm()));
    }
  }

  // The matrix is that of the Christoffel symbols: c_ij = sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) dq_k /
  // 2
  TEST_CASE("the Coriolis matrix consists of Christoffel symbols") {
    constexpr std::size_t n = 5;
    laws::source random{std::mt19937_64{63}};
    for (int round = 0; round < 50; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 1);
      std::array<Eigen::Matrix<double, 5, 5>, n> by;
      for (int k = 0; k < 5; ++k)
        by[static_cast<std::size_t>(k)] =
            slope([&](double h) { return mass_of<n>(t, q + h * state<n>::Unit(k)); });
      Eigen::Matrix<double, 5, 5> wanted = Eigen::Matrix<double, 5, 5>::Zero();
      for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
          for (int k = 0; k < 5; ++k)
            wanted(i, j) += 0.5 * dq[k] *
                            (by[static_cast<std::size_t>(k)](i, j) + by[static_cast<std::size_t>(j)](i, k) -
                             by[static_cast<std::size_t>(i)](j, k));
      const auto c = cd::coriolis_of<5>(t.links, placed(t, q), dq);
      CHECK((c - wanted).norm() < exact * (1 + wanted.norm()));
    }
  }

  TEST_CASE_TEMPLATE("the momentum of the joints, and its change", Count, count<1>, count<3>, count<7>) {
    constexpr std::size_t n = Count::value;
    laws::source random{std::mt19937_64{64}};
    for (int round = 0; round < laws::rounds; ++round) {
      const random_tree<n> t(random, round % 2 == 0);
      const auto q = random_state<n>(random, 3), dq = random_state<n>(random, 1);
      const auto links = placed(t, q);
      const auto found = cd::momentum_of_joints<static_cast<int>(n)>(t.links, links, dq);
      const state<n> p = mass_of<n>(t, q) * dq;
      CHECK((found.momentum - p).norm() < exact * (1 + p.norm()));
      const state<n> back = cd::coriolis_of<static_cast<int>(n)>(t.links, links, dq).transpose() * dq;
      CHECK((found.change - back).norm() < exact * (1 + back.norm()));
      for (int i = 0; i < static_cast<int>(n); ++i) {  // the energy's derivative with respect to q
        const auto energy = slope([&](double h) {
          return Eigen::Matrix<double, 1, 1>(0.5 * dq.dot(mass_of<n>(t, q + h * state<n>::Unit(i)) * dq));
        });
        CHECK(std::abs(found.change[i] - energy[0]) < exact * (1 + back.norm()));
      }
    }
  }

  TEST_CASE_TEMPLATE("forward dynamics undo inverse dynamics", Body, arm, hound, star_of_arms) {
    laws::source random{std::mt19937_64{65}};
    for (int round = 0; round < laws::rounds; ++round) {
      const cca::body_pose<Body> now(random_coordinates<Body>(random, 3));
      const auto dq = random_coordinates<Body>(random, 1), ddq = random_coordinates<Body>(random, 5);
      const cca::base_motion base = random_base(random);
      const auto load = cca::inverse_dynamics(now, dq, ddq, base);

      const auto held = cca::forward_dynamics(now, dq, load.torques, base);
      CHECK((held - ddq).norm() < exact * (1 + ddq.norm()));

      cca::base_motion unknown = base;
      unknown.angular_acceleration.setConstant(std::nan(""));
      unknown.acceleration.setConstant(std::nan(""));
      const auto free = cca::floating_forward_dynamics(now, dq, load.torques, unknown, load.wrench);
      CHECK((free.accelerations - ddq).norm() < exact * (1 + ddq.norm()));
      CHECK((free.base.angular_acceleration - base.angular_acceleration).norm() < 1e-8);
      CHECK((free.base.acceleration - base.acceleration).norm() < 1e-8);
    }
  }

  TEST_CASE_TEMPLATE("the floating mass matrix", Body, arm, hound, star_of_arms) {
    constexpr int n = cca::body_pose<Body>::size;
    laws::source random{std::mt19937_64{66}};
    for (int round = 0; round < laws::rounds; ++round) {
      const cca::body_pose<Body> now(random_coordinates<Body>(random, 3));
      const auto dq = random_coordinates<Body>(random, 1), ddq = random_coordinates<Body>(random, 5);
      const cca::base_motion base = random_base(random);
      cca::base_motion still = base;
      still.acceleration.setZero();
      still.angular_acceleration.setZero();
      const auto load = cca::inverse_dynamics(now, dq, ddq, base),
                 bias = cca::inverse_dynamics(now, dq, decltype(dq)::Zero(), still);
      const auto m = cca::floating_mass_matrix(now);
      CHECK((m - m.transpose()).norm() == 0);
      CHECK(m.llt().info() == Eigen::Success);
      CHECK((m.template bottomRightCorner<n, n>() - cca::mass_matrix(now)).norm() == 0);
      Eigen::Matrix<double, 6 + n, 1> motion, wanted;
      motion << base.angular_acceleration, base.acceleration, ddq;
      wanted << load.wrench - bias.wrench, load.torques - bias.torques;
      CHECK((m * motion - wanted).norm() < exact * (1 + wanted.norm()));
    }
  }

  // In free fall nothing turns: gravity acts on all links alike.
  TEST_CASE("free fall") {
    laws::source random{std::mt19937_64{67}};
    const cca::body_pose<star_of_arms> now(random_coordinates<star_of_arms>(random, 3));
    using vector = cca::body_pose<star_of_arms>::vector_type;
    const auto fall = cca::floating_forward_dynamics(now, vector(vector::Zero()), vector(vector::Zero()));
    CHECK(fall.accelerations.norm() < exact);
    CHECK(fall.base.angular_acceleration.norm() < exact);
    CHECK((fall.base.acceleration - Eigen::Vector3d(0, 0, -9.81)).norm() < exact);
  }

  TEST_CASE_TEMPLATE("centroidal momentum", Body, arm, hound, star_of_arms) {
    constexpr int n = cca::body_pose<Body>::size;
    laws::source random{std::mt19937_64{68}};
    for (int round = 0; round < laws::rounds; ++round) {
      const auto q = random_coordinates<Body>(random, 3), dq = random_coordinates<Body>(random, 1);
      Eigen::Matrix<double, 6, 1> base;
      base << random.vector(1), random.vector(1);
      const cca::body_pose<Body> now(q);
      const auto h = cca::centroidal_momentum(now, dq, base);
      Eigen::Matrix<double, 6 + n, 1> motion;
      motion << base, dq;
      CHECK((cca::floating_centroidal_momentum_matrix(now) * motion - h).norm() < exact * (1 + h.norm()));
      const auto of_joints = cca::centroidal_momentum(now, dq);
      CHECK((cca::centroidal_momentum_matrix(now) * dq - of_joints).norm() < exact);

      // Linear: mass times the velocity of the centre of mass.
      constexpr double mass = [] {
        double sum = Body::base.mass;
        for (const auto& l : cd::body_tree_of<Body>.links) sum += l.inertia.mass;
        return sum;
      }();
      const Eigen::Vector3d velocity =
          slope([&](double t) { return cca::body_pose<Body>(q + t * dq).centre_of_mass(); });
      CHECK((of_joints.template tail<3>() - mass * velocity).norm() < exact);

      // Angular: each link turns about its own centre, and the links move as points.
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < cd::body_tree_of<Body>.links.size(); ++i) {
        const auto& of = cd::body_tree_of<Body>.links[i].inertia;
        const auto& frame = now.links()[i].frame;
        const Eigen::Vector3d centre = frame.at + frame.turn * Eigen::Vector3d::Map(of.centre.data());
        Eigen::Matrix<double, 6, n> j;
        cd::fill_jacobian(cd::body_tree_of<Body>.links, now.links(), static_cast<int>(i), centre, j);
        const Eigen::Matrix<double, 6, 1> v = j * dq;
        sum +=
            frame.turn * (cd::matrix_of(of.about_centre) * (frame.turn.transpose() * v.template head<3>())) +
            of.mass * (centre - now.centre_of_mass()).cross(v.template tail<3>());
      }
      CHECK((of_joints.template head<3>() - sum).norm() < exact);
    }
  }

  // Nothing outside acts: momentum stays, so M a + bias = 0 says it for the base too.
  TEST_CASE("the centroidal momentum of a body that nothing holds stays") {
    using body = star_of_arms;
    laws::source random{std::mt19937_64{69}};
    for (int round = 0; round < 50; ++round) {
      const auto q = random_coordinates<body>(random, 3), dq = random_coordinates<body>(random, 1),
                 torques = random_coordinates<body>(random, 0.2);
      cca::base_motion base;
      base.gravity.setZero();
      base.angular_velocity = random.vector(1);
      Eigen::Matrix<double, 6, 1> motion;
      motion << base.angular_velocity, Eigen::Vector3d::Zero();
      const auto a = cca::floating_forward_dynamics(cca::body_pose<body>(q), dq, torques, base);
      Eigen::Matrix<double, 6, 1> change;
      change << a.base.angular_acceleration, a.base.acceleration;
      // Along the axes of the base, which turn.
      const auto h = cca::centroidal_momentum(cca::body_pose<body>(q), dq, motion);
      const Eigen::Matrix<double, 6, 1> slope_of_h = slope(
          [&](double t) {
            return cca::centroidal_momentum(cca::body_pose<body>(q + t * dq + 0.5 * t * t * a.accelerations),
                                            dq + t * a.accelerations, motion + t * change);
          },
          2e-4);
      CHECK((slope_of_h.head<3>() + base.angular_velocity.cross(h.head<3>())).norm() < 1e-8);
      CHECK((slope_of_h.tail<3>() + base.angular_velocity.cross(h.tail<3>())).norm() < 1e-8);
    }
  }

  TEST_CASE("operational space of an arm") {
    laws::source random{std::mt19937_64{70}};
    for (int round = 0; round < laws::rounds; ++round) {
      auto q = random_coordinates<arm>(random, 2.5);
      if (std::abs(q[3]) < 0.3 || std::abs(q[5]) < 0.3 || std::abs(q[1]) < 0.3) continue;  // singular
      const cca::body_pose<arm> now(q);
      const auto m = cca::mass_matrix(now);
      const auto j = now.jacobian<"arm">();
      const cca::operational_space task(m, j);
      CHECK((task.inertia - task.inertia.transpose()).norm() < exact * task.inertia.norm());
      const Eigen::Matrix<double, 6, 6> mobility = j * m.llt().solve(j.transpose());
      CHECK((task.inertia * mobility - Eigen::Matrix<double, 6, 6>::Identity()).norm() < 1e-8);
      CHECK((j * task.inverse - Eigen::Matrix<double, 6, 6>::Identity()).norm() < 1e-8);
      const auto t = random_coordinates<arm>(random, 10), dq = random_coordinates<arm>(random, 1);
      CHECK((j * m.llt().solve(task.free_torques(t))).norm() < 1e-8);
      CHECK((j * task.free_motion(dq)).norm() < 1e-8);
      CHECK(task.free_torques(t).norm() > 1e-3);
      // Of all motions that move the end like dq, this one has the least energy.
      const Eigen::Matrix<double, 7, 1> least = task.inverse * (j * dq), other = dq - least;
      CHECK(std::abs(least.dot(m * other)) < exact * (1 + dq.dot(m * dq)));
      // The position alone.
      const Eigen::Matrix<double, 3, 7> rows = j.bottomRows<3>();
      const cca::operational_space position(m, rows);
      CHECK((rows * position.inverse - Eigen::Matrix3d::Identity()).norm() < 1e-8);
    }
  }

  TEST_CASE_TEMPLATE("operational space, recorded and by loops", Rows, std::integral_constant<int, 6>,
                     std::integral_constant<int, 3>, std::integral_constant<int, 1>) {
    constexpr int rows = Rows::value;
    using quantity = cca::detail::recorded_mobility<rows, 7>;
    static_assert(cca::detail::is_recorded<quantity>());
    static_assert(!cca::detail::is_recorded<cca::detail::recorded_mobility<6, 9>>());
    using columns = Eigen::Matrix<double, 7, rows>;
    using square = Eigen::Matrix<double, rows, rows>;
    laws::source random{std::mt19937_64{73}};
    for (int round = 0; round < laws::rounds; ++round) {
      const cca::body_pose<arm> now(random_coordinates<arm>(random, 2.5));
      Eigen::Matrix<double, 7, 7> m = cca::mass_matrix(now);
      Eigen::Matrix<double, rows, 7> j = now.jacobian<"arm">().template bottomRows<rows>();
      columns moved;
      square mobility;
      cca::detail::straight_line<quantity>::evaluate({moved.data(), mobility.data()}, m.data(), j.data());
      const columns wanted = m.llt().solve(j.transpose());
      CHECK((moved - wanted).cwiseAbs().maxCoeff() < 1e-12 * wanted.cwiseAbs().maxCoeff());
      const square pushed = j * wanted;
      CHECK((mobility - pushed).cwiseAbs().maxCoeff() < 1e-12 * pushed.cwiseAbs().maxCoeff());
      CHECK(mobility == mobility.transpose());

      const cca::operational_space task(m, j);
      square inertia;
      columns inverse;
      cca::detail::operational_space_by_loops(m, j, inertia, inverse);
      // Near a direction in which the end can't move, rounding counts more.
      const double exactly = 1e-14 * mobility.norm() * inertia.norm();
      CHECK((task.inertia - inertia).norm() < exactly * inertia.norm());
      CHECK((task.inverse - inverse).norm() < exactly * inverse.norm());

      // Only the lower triangle counts; in all else no NaN is lost.
      m(2, 5) = std::nan("");
      CHECK(cca::operational_space(m, j).inverse == task.inverse);
      m(2, 5) = 0, m(5, 2) = std::nan("");
      CHECK(!cca::operational_space(m, j).inverse.allFinite());
      m(5, 2) = 0, m(3, 3) = std::numeric_limits<double>::infinity();
      CHECK(!cca::operational_space(m, j).inverse.allFinite());
      CHECK(cca::operational_space(m, j).inertia.allFinite());
      m(3, 3) = 1, j(0, round % 7) = std::nan("");
      CHECK(!cca::operational_space(m, j).inverse.allFinite());
    }
  }

  TEST_CASE("operational space where the end can't move in all directions") {
    laws::source random{std::mt19937_64{71}};
    Eigen::Matrix<double, 7, 1> stretched = Eigen::Matrix<double, 7, 1>::Zero();
    for (int round = 0; round < 50; ++round) {
      stretched[0] = random(-2, 2), stretched[4] = random(-2, 2);
      const cca::body_pose<arm> now(stretched);
      const cca::operational_space task(cca::mass_matrix(now), now.jacobian<"arm">());
      const auto t = random_coordinates<arm>(random, 10), dq = random_coordinates<arm>(random, 1);
      CHECK(task.inertia.allFinite());
      CHECK(task.inverse.allFinite());
      CHECK((task.jacobian * task.free_motion(dq)).norm() < 1e-6);
      CHECK((task.jacobian * cca::mass_matrix(now).llt().solve(task.free_torques(t))).norm() < 1e-6);
    }
    // More rows than joints.
    const cca::body_pose<hound> now(random_coordinates<hound>(random, 1));
    const cca::operational_space task(cca::mass_matrix(now), now.jacobian<"toe">());
    const auto dq = random_coordinates<hound>(random, 1);
    CHECK((task.jacobian * task.free_motion(dq)).norm() < 1e-9);
    CHECK((task.jacobian * task.inverse * task.jacobian - task.jacobian).norm() < 1e-9);
  }
}
