// The accelerations of a robot in the engine, from two steps of it.
//
// The engine integrates velocities of bodies, with joints as constraints on them. A step holds the
// constraints of its beginning, so the acceleration that the turning of the joints causes shows in the step
// after it: the difference of the speeds after two steps of h from a consistent state is the acceleration up
// to an error that is linear in h. Two extrapolations, with h, h/2 and h/4, remove its first two orders.
// Measured on the arm, relative: 5e-5 for h = 1e-5 s as it is, 2e-8 extrapolated once, 1e-11 twice.
#pragma once

#include <doctest/doctest.h>

#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

#include "../body/random_links.hpp"

namespace world_test {

inline constexpr double h = 1e-5;  // s

using vector = Eigen::VectorXd;

struct motion {
  vector q, dq, torques;
  cca::sim::moving_frame base;
};

// Nothing acts but the torques.
inline cca::sim::robot_model without_losses(cca::sim::robot_model m) {
  for (auto& d : m.drives) d = {.motor = {1e9, 1e9}};
  m.stops.assign(m.drives.size(), {});
  return m;
}

// Of the coordinates, then of the base: angular, linear, in the world.
inline vector accelerations_in_steps(cca::sim::robot_model m, const motion& s, double step) {
  m.beat = step;
  cca::sim::robot_world_settings exact;
  exact.steps_per_beat = 1;
  exact.engine.erp = exact.engine.cfm = 0;
  for (std::size_t k = 0; k < 3; ++k)
    exact.mount.translation[k] = s.base.where.at[static_cast<Eigen::Index>(k)];
  const Eigen::Vector4d turn = cca::detail::quaternion_of(s.base.where.turn);
  exact.mount.rotation = {turn[0], turn[1], turn[2], turn[3]};
  cca::sim::robot_world w(m, {}, exact);
  const auto n = static_cast<std::size_t>(s.q.size());
  w.place({s.q.data(), n}, {s.dq.data(), n}, s.base);
  std::vector<cca::sim::joint_law> laws(n);
  for (std::size_t i = 0; i < n; ++i) laws[i].torque = s.torques[static_cast<Eigen::Index>(i)];
  const auto speeds = [&] {
    w.advance(laws);
    vector v(s.q.size() + 6);
    for (std::size_t i = 0; i < n; ++i) v[static_cast<Eigen::Index>(i)] = w.joints()[i].velocity;
    v.tail<6>() << w.frame(-1).angular_velocity, w.frame(-1).velocity;
    return v;
  };
  const vector first = speeds();
  for (std::size_t i = 0; i < n; ++i)
    CHECK(std::abs(w.joints()[i].angle - s.q[static_cast<Eigen::Index>(i)]) < 100 * step);
  return (speeds() - first) / step;
}

inline vector accelerations(const cca::sim::robot_model& m, const motion& s) {
  const vector a = accelerations_in_steps(m, s, h), b = accelerations_in_steps(m, s, h / 2),
               c = accelerations_in_steps(m, s, h / 4);
  return (4 * (2 * c - b) - (2 * b - a)) / 3;
}

inline vector random_vector(laws::source& random, Eigen::Index size, double limit) {
  vector v(size);
  for (double& x : v) x = random(-limit, limit);
  return v;
}

inline cca::sim::moving_frame random_base(laws::source& random) {
  return {cca::rigid{} * body_test::random_placement(random), random.vector(1), random.vector(1)};
}

inline double error(const vector& found, const vector& wanted) {
  return (found - wanted).norm() / (1 + wanted.norm());
}

template <class R>
using pose_of = cca::body_pose<typename R::body>;

// What the dynamics of the library say: of the coordinates, then of the base.
template <class R>
vector wanted(const motion& s, const vector& extra) {
  using pose = pose_of<R>;
  constexpr int n = pose::size;
  const typename pose::vector_type q = s.q, dq = s.dq, torques = s.torques + extra.head(n);
  const Eigen::Matrix3d& turn = s.base.where.turn;
  cca::base_motion base;
  base.gravity = turn.transpose() * base.gravity;
  vector a = vector::Zero(n + 6);
  if constexpr (cca::robots::floats<R>) {
    base.angular_velocity = turn.transpose() * s.base.angular_velocity;
    const Eigen::Matrix<double, 6, 1> wrench = extra.tail<6>();
    const auto found = cca::floating_forward_dynamics(pose(q), dq, torques, base, wrench);
    a << found.accelerations, turn * found.base.angular_acceleration, turn * found.base.acceleration;
  } else {
    a.head<n>() = cca::forward_dynamics(pose(q), dq, torques, base);
  }
  return a;
}

template <class R>
double worst_error(unsigned seed, auto extra, const cca::sim::robot_model& model = cca::sim::model_of<R>()) {
  constexpr int n = pose_of<R>::size;
  laws::source random{std::mt19937_64{seed}};
  double worst = 0;
  for (int round = 0; round < 40; ++round) {
    motion s{random_vector(random, n, 1), random_vector(random, n, 3), random_vector(random, n, 2),
             random_base(random)};
    if (!cca::robots::floats<R>) s.base.angular_velocity.setZero(), s.base.velocity.setZero();
    worst = std::max(worst, error(accelerations(without_losses(model), s), wanted<R>(s, extra(s))));
  }
  MESSAGE("largest relative error: ", worst);
  return worst;
}
template <class R>
vector nothing(const motion&) {
  return vector::Zero(pose_of<R>::size + 6);
}

}  // namespace world_test
