#pragma once
// The accelerations of a compiled world beside those of the library: the test and the table of
// docs/physics.md.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

#include <Eigen/Dense>

#include <cca/robot/dynamics/forward_dynamics.hpp>

#include "robots.hpp"

namespace compiled_test {

// The largest relative error, of 100 random states with random torques.
template <class R>
double worst_acceleration() {
  constexpr auto n = static_cast<int>(coordinates<R>);
  using vector = Eigen::Matrix<double, n, 1>;
  constexpr std::size_t base = R::floats ? 6 : 0;
  laws::source random{std::mt19937_64{31}};
  double worst = 0;
  for (int round = 0; round < 100; ++round) {
    sim::detail::tree_motion<double, n, R::floats> m;
    m.q = random_numbers<R>(random, 3), m.dq = random_numbers<R>(random, 3);
    m.attitude.q = random_place(random).rotation;
    const Eigen::Vector3d turning = random.vector(3);
    if (R::floats) m.angular_velocity = {turning[0], turning[1], turning[2]};
    const numbers<R> torques = random_numbers<R>(random, 5);

    sim::detail::tree_step<R, double> step(0);
    step.begin(m, 9.81);
    auto found = step.now.forces;
    for (std::size_t c = 0; c < torques.size(); ++c)
      found[static_cast<std::size_t>(step.now.rows.row[base + c])] += torques[c];
    sim::detail::limb_solution<R, double>::factor_and_solve(step.now.mass, found);

    const cca::body_pose<typename R::body> pose(vector::Map(m.q.data()));
    const vector dq = vector::Map(m.dq.data()), t = vector::Map(torques.data());
    Eigen::Matrix<double, static_cast<int>(base) + n, 1> wanted;
    Eigen::Matrix3d turn;
    for (int k = 0; k < 3; ++k)
      for (int r = 0; r < 3; ++r)
        turn(r, k) = step.base.axes[static_cast<std::size_t>(k)][static_cast<std::size_t>(r)];
    cca::base_motion b;
    b.gravity = turn.transpose() * Eigen::Vector3d(0, 0, -9.81);
    if constexpr (R::floats) {
      b.angular_velocity = turn.transpose() * turning;
      const auto a = cca::floating_forward_dynamics(pose, dq, t, b);
      wanted << a.base.angular_acceleration, a.base.acceleration, a.accelerations;
    } else {
      wanted = cca::forward_dynamics(pose, dq, t, b);
    }
    double error = 0;
    for (std::size_t v = 0; v < base + torques.size(); ++v)
      error = std::max(error, std::abs(found[static_cast<std::size_t>(step.now.rows.row[v])] -
                                       wanted[static_cast<Eigen::Index>(v)]));
    worst = std::max(worst, error / wanted.norm());
  }
  return worst;
}

}  // namespace compiled_test
