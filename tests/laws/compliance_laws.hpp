// The laws of compliant components, run on a simulated arm that nothing but the component, gravity and a
// passive environment moves.
//
//   energy_created       the energy of the arm, the environment and the springs of the component never grows
//   is_as_stiff          under a constant load the arm rests where the stiffness says
//   has_damping_ratio    each mode of the linearised loop has the ratio that was asked for
//
// A model is a function object `torques = model(q, dq)` with `stored(q)`, the energy of its springs in J. The
// torques include gravity compensation, so the gravity of the arm cancels.
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>

#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>

#include "law.hpp"
#include "space_laws.hpp"

namespace laws {

// A damped spring between the end of a part and a point, and a wall of springs that pushes but does not pull.
template <class Body, cca::fixed_string Part>
struct passive_world {
  using vector = typename cca::body_pose<Body>::vector_type;
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
  double stiffness = 0, damping = 0;         // N/m, N s/m
  double floor = -1e9, floor_stiffness = 0;  // m, N/m: along z
  vector load = vector::Zero();              // N m, constant: a weight on a rope
  Eigen::Matrix<double, 6, 1> wrench = Eigen::Matrix<double, 6, 1>::Zero();  // on the end, constant

  vector torques(const cca::body_pose<Body>& now, const vector& dq) const {
    const auto jacobian = now.template jacobian<Part>();
    const Eigen::Vector3d at = now.template tip<Part>().at, v = jacobian.template bottomRows<3>() * dq;
    Eigen::Vector3d f = stiffness * (anchor - at) - damping * v;
    f[2] += floor_stiffness * std::max(0.0, floor - at[2]);
    return jacobian.template bottomRows<3>().transpose() * f + load + jacobian.transpose() * wrench;
  }
  double stored(const cca::body_pose<Body>& now) const {
    const Eigen::Vector3d at = now.template tip<Part>().at;
    const double below = std::max(0.0, floor - at[2]);
    return 0.5 * stiffness * (at - anchor).squaredNorm() + 0.5 * floor_stiffness * below * below;
  }
};

// The arm in its world.
template <class Body, cca::fixed_string Part>
struct simulated_arm {
  using vector = typename cca::body_pose<Body>::vector_type;
  vector q = vector::Zero(), dq = vector::Zero();
  passive_world<Body, Part> world{};

  vector acceleration(const vector& at, const vector& v, const vector& drive) const {
    const cca::body_pose<Body> now(at);
    return cca::forward_dynamics(now, v, vector(drive + world.torques(now, v)));
  }
  // Runge and Kutta's fourth order; `drive(q, dq)` is asked at each stage.
  template <class Drive>
  void step(const Drive& drive, double dt) {
    const auto a = [&](const vector& at, const vector& v) { return acceleration(at, v, drive(at, v)); };
    const vector a1 = a(q, dq), v2 = dq + 0.5 * dt * a1, a2 = a(q + 0.5 * dt * dq, v2),
                 v3 = dq + 0.5 * dt * a2, a3 = a(q + 0.5 * dt * v2, v3), v4 = dq + dt * a3,
                 a4 = a(q + dt * v3, v4);
    q += dt / 6 * (dq + 2 * v2 + 2 * v3 + v4);
    dq += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  // As a drive does: the torques stay for the whole step.
  void hold(const vector& torques, double dt) {
    step([&](const vector&, const vector&) { return torques; }, dt);
  }
  double energy() const {
    const cca::body_pose<Body> now(q);
    return 0.5 * dq.dot(cca::mass_matrix(now) * dq) + world.stored(now);
  }
};

// The largest growth of the energy, in J, over a run of `seconds`; the torques follow the state without
// delay.
template <class Arm, class Model>
double energy_created(Arm arm, const Model& model, double seconds, double dt) {
  double least = arm.energy() + model.stored(arm.q), grown = 0;
  for (int k = 0; k * dt < seconds; ++k) {
    arm.step(model, dt);
    const double now = arm.energy() + model.stored(arm.q);
    if (!std::isfinite(now)) return std::numeric_limits<double>::infinity();  // no number, so no bound holds
    grown = std::max(grown, now - least);
    least = std::min(least, now);
  }
  return grown;
}
// The same with torques that are held for a step of `dt`, as in a loop.
template <class Arm, class Model>
double energy_created_in_a_loop(Arm arm, const Model& model, double seconds, double dt) {
  const double before = arm.energy() + model.stored(arm.q);
  double grown = 0;
  for (int k = 0; k * dt < seconds; ++k) {
    arm.hold(model(arm.q, arm.dq), dt);
    const double now = arm.energy() + model.stored(arm.q);
    if (!std::isfinite(now)) return std::numeric_limits<double>::infinity();
    grown = std::max(grown, now - before);
  }
  return grown;
}

// Brings the arm to rest under its load.
template <class Arm, class Model>
void settle(Arm& arm, const Model& model, double seconds = 10, double dt = 1e-3) {
  for (int k = 0; k * dt < seconds; ++k) arm.hold(model(arm.q, arm.dq), dt);
  CHECK(arm.dq.norm() < 1e-7);
}

// Of each mode of the loop, linearised by differences at a state of rest: its damping ratio. Modes that do
// not oscillate and have no stiffness are left out.
template <class Arm, class Model>
Eigen::VectorXd damping_ratios(const Arm& arm, const Model& model) {
  constexpr int n = Arm::vector::RowsAtCompileTime;
  Eigen::Matrix<double, 2 * n, 2 * n> a = Eigen::Matrix<double, 2 * n, 2 * n>::Zero();
  a.template topRightCorner<n, n>().setIdentity();
  const double h = 1e-5;
  for (int i = 0; i < n; ++i) {
    typename Arm::vector e = Arm::vector::Zero();
    e[i] = h;
    const auto f = [&](const auto& q, const auto& dq) { return arm.acceleration(q, dq, model(q, dq)); };
    a.template bottomLeftCorner<n, n>().col(i) = (f(arm.q + e, arm.dq) - f(arm.q - e, arm.dq)) / (2 * h);
    a.template bottomRightCorner<n, n>().col(i) = (f(arm.q, arm.dq + e) - f(arm.q, arm.dq - e)) / (2 * h);
  }
  const Eigen::VectorXcd roots = Eigen::EigenSolver<Eigen::MatrixXd>(a).eigenvalues();
  Eigen::VectorXd ratios(roots.size());
  int count = 0;
  for (const auto& root : roots)
    if (std::abs(root.imag()) > 1e-3) ratios[count++] = -root.real() / std::abs(root);
  ratios.conservativeResize(count);
  return ratios;
}

// Under a load along its joints the arm rests where springs of this stiffness let it.
template <class Arm, class Model>
void is_as_stiff(Arm arm,
                 const Model& model,
                 const typename Arm::vector& stiffness,
                 const typename Arm::vector& push) {
  const typename Arm::vector from = arm.q, expected = push.cwiseQuotient(stiffness);
  arm.world.load = push;
  settle(arm, model);
  MESSAGE("largest error of the deflection: " << ((arm.q - from) - expected).cwiseAbs().maxCoeff() << " rad");
  for (int i = 0; i < push.size(); ++i)
    CHECK(arm.q[i] - from[i] == doctest::Approx(expected[i]).epsilon(1e-6));
}

// `modes`: how many roots of the loop oscillate.
template <class Arm, class Model>
void has_damping_ratio(const Arm& arm, const Model& model, double ratio, int modes) {
  const auto found = damping_ratios(arm, model);
  REQUIRE(found.size() == modes);
  for (const double one : found) CHECK(one == doctest::Approx(ratio).epsilon(1e-5));
}

}  // namespace laws
