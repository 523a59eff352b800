// The derivatives of the dynamics of a free base, against dual numbers through the recorded algorithms as
// loops, and against central differences of the dynamics themselves.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <cca/robot/dynamics/floating_derivatives.hpp>
#include <cca/robots/oncilla/legged_body.hpp>

#include "../../../bench/quadruped.hpp"
#include "../../laws/space_laws.hpp"
#include "bodies.hpp"
#include "../dual.hpp"
#include "recorded_bodies.hpp"

namespace floating_derivatives_test {

using test::dual;
using namespace body_test;
namespace cd = cca::detail;

// What a derivative is taken by.
enum class variable { angles, velocities, input, angular_velocity, orientation, load };
constexpr std::array variables{variable::angles,           variable::velocities,  variable::input,
                               variable::angular_velocity, variable::orientation, variable::load};

template <class Body>
struct state {
  static constexpr int n = cca::axes_of<Body>::count, rows = 6 + n;
  static constexpr const auto& reduced = cd::reduced_body_of<Body>;
  using vector = Eigen::Matrix<double, n, 1>;
  using all_rows = Eigen::Matrix<double, rows, 1>;
  using matrix = Eigen::Matrix<double, rows, Eigen::Dynamic>;

  vector q, dq, input;  // the input: torques; accelerations, of inverse dynamics
  cca::base_motion base;
  Eigen::Matrix<double, 6, 1> load;  // the wrench; of inverse dynamics, the accelerations of the base

  static state random(laws::source& random) {
    state s;
    for (auto& x : s.q) x = random(-3, 3);
    for (auto& x : s.dq) x = random(-2, 2);
    for (auto& x : s.input) x = random(-5, 5);
    s.base = {random.vector(10), random.vector(2), {0, 0, 0}, {0, 0, 0}};
    s.load << random.vector(3), random.vector(5);
    return s;
  }
  static constexpr int columns(variable v) {
    return v == variable::load ? 6 : v == variable::angular_velocity || v == variable::orientation ? 3 : n;
  }
  cca::body_pose<Body> pose() const { return cca::body_pose<Body>(q); }
  cca::base_motion moving_base() const {
    return {base.gravity, base.angular_velocity, load.template head<3>(), load.template tail<3>()};
  }
  auto forward() const { return cca::floating_forward_dynamics_derivatives(pose(), dq, input, base, load); }
  auto inverse() const {
    return cca::floating_inverse_dynamics_derivatives(pose(), dq, input, moving_base());
  }

  // By column k of a variable.
  all_rows by_dual_numbers(bool forward, variable by, int k) const {
    const auto seeded = [&](const auto& v, variable own) {
      std::array<dual, static_cast<std::size_t>(std::decay_t<decltype(v)>::RowsAtCompileTime)> d;
      for (std::size_t c = 0; c < d.size(); ++c)
        d[c] = {v[static_cast<Eigen::Index>(c)], by == own && k == static_cast<int>(c) ? 1.0 : 0.0};
      return d;
    };
    const auto angle = seeded(q, variable::angles), speed = seeded(dq, variable::velocities),
               given = seeded(input, variable::input);
    const auto w = seeded(base.angular_velocity, variable::angular_velocity);
    const auto on_base = seeded(load, variable::load);
    const auto joints =
        cd::placed_joints<dual>(reduced, test::joint_values_at<cd::reduced_body_of<Body>>(angle));
    // A turn about axis k of the base changes gravity along its axes by gravity x axis.
    std::array<dual, 3> gravity;
    for (std::size_t i = 0; i < 3; ++i) gravity[i] = base.gravity[static_cast<Eigen::Index>(i)];
    if (by == variable::orientation) {
      const auto x = static_cast<std::size_t>(k + 1) % 3, y = static_cast<std::size_t>(k + 2) % 3;
      gravity[x].slope = gravity[y].value;
      gravity[y].slope = -gravity[x].value;
    }
    cd::link_motion<dual> root;
    for (std::size_t i = 0; i < 3; ++i) {
      root.w[i] = w[i];
      if (forward) root.a[i] = -gravity[i];
      else root.dw[i] = on_base[i], root.a[i] = on_base[3 + i] - gravity[i];
    }
    std::array<dual, static_cast<std::size_t>(n)> torques{};
    const auto wrench =
        cd::add_newton_euler(reduced, joints, root, speed, forward ? decltype(torques){} : given, torques);
    std::array<dual, static_cast<std::size_t>(rows)> x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = wrench.moment[i], x[3 + i] = wrench.force[i];
    for (std::size_t c = 0; c < torques.size(); ++c) x[6 + c] = torques[c];
    if (forward) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = (i < 6 ? on_base[i] : given[i - 6]) - x[i];
      cd::square<dual, rows> m;
      cd::add_mass_matrix<true>(reduced, joints, m);
      CHECK(cd::solve(m, x, cd::order_of_solution<true, rows>(reduced)));
    }
    all_rows result;
    for (int r = 0; r < rows; ++r) result[r] = x[static_cast<std::size_t>(r)].slope;
    return result;
  }

  void move(variable by, int k, double step) {
    if (by == variable::angles) q[k] += step;
    if (by == variable::velocities) dq[k] += step;
    if (by == variable::input) input[k] += step;
    if (by == variable::angular_velocity) base.angular_velocity[k] += step;
    if (by == variable::load) load[k] += step;
    if (by == variable::orientation)
      base.gravity = Eigen::AngleAxisd(-step, Eigen::Vector3d::Unit(k)) * base.gravity;
  }
  all_rows value(bool forward) const {
    all_rows r;
    if (forward) {
      const auto f = cca::floating_forward_dynamics(pose(), dq, input, base, load);
      r << f.base.angular_acceleration, f.base.acceleration, f.accelerations;
    } else {
      const auto i = cca::inverse_dynamics(pose(), dq, input, moving_base());
      r << i.wrench, i.torques;
    }
    return r;
  }
  // Sixth order.
  all_rows by_differences(bool forward, variable by, int k) const {
    const auto at = [&](double step) {
      state s = *this;
      s.move(by, k, step);
      return s.value(forward);
    };
    const double h = 2e-3;
    return (45 * (at(h) - at(-h)) - 9 * (at(2 * h) - at(-2 * h)) + (at(3 * h) - at(-3 * h))) / (60 * h);
  }
  matrix all(all_rows (state::*way)(bool, variable, int) const, bool forward, variable by) const {
    matrix m(rows, columns(by));
    for (int k = 0; k < m.cols(); ++k) m.col(k) = (this->*way)(forward, by, k);
    return m;
  }
};

template <class Result>
Eigen::MatrixXd found(const Result& d, variable by) {
  if (by == variable::angles) return d.by_angles;
  if (by == variable::velocities) return d.by_velocities;
  if (by == variable::angular_velocity) return d.by_angular_velocity;
  if (by == variable::orientation) return d.by_orientation;
  if constexpr (requires { d.by_wrench; }) {
    return by == variable::load ? Eigen::MatrixXd(d.by_wrench) : Eigen::MatrixXd(d.by_torques);
  } else {
    const Eigen::MatrixXd m = d.by_accelerations;
    return by == variable::load ? m.leftCols(6) : m.rightCols(m.cols() - 6);
  }
}
double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  REQUIRE(a.rows() == b.rows());
  REQUIRE(a.cols() == b.cols());
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

using oncilla = cca::robots::oncilla::legged_body;
using bench::quadruped;

}  // namespace floating_derivatives_test

using namespace floating_derivatives_test;

TEST_SUITE("derivatives of a free base") {
  TEST_CASE_TEMPLATE("as by dual numbers, and by differences", Body, quadruped, oncilla, random_tree_body,
                     hound, arm, humanoid) {
    using s = state<Body>;
    laws::source random{std::mt19937_64{191}};
    for (int round = 0; round < (s::n > 15 ? 2 : 10); ++round) {
      const s at = s::random(random);
      const auto inverse = at.inverse();
      const auto forward = at.forward();
      for (const variable by : variables) {
        INFO("variable ", static_cast<int>(by));
        const auto of_loads = at.all(&s::by_dual_numbers, false, by),
                   of_motion = at.all(&s::by_dual_numbers, true, by);
        CHECK(difference(found(inverse, by), of_loads) < 1e-12);
        CHECK(difference(found(inverse, by), at.all(&s::by_differences, false, by)) < 1e-8);
        CHECK(difference(found(forward, by), of_motion) < 1e-10);
        CHECK(difference(found(forward, by), at.all(&s::by_differences, true, by)) < 1e-7);
      }
    }
  }

  TEST_CASE_TEMPLATE("values, the mass matrix, and the derivatives of a base that is held", Body, quadruped,
                     oncilla, random_tree_body) {
    using s = state<Body>;
    laws::source random{std::mt19937_64{192}};
    for (int round = 0; round < 10; ++round) {
      const s at = s::random(random);
      const auto now = at.pose();
      const auto inverse = at.inverse();
      const auto values = cca::inverse_dynamics(now, at.dq, at.input, at.moving_base());
      CHECK(difference(inverse.torques, values.torques) < 1e-12);
      CHECK(difference(inverse.wrench, values.wrench) < 1e-12);
      CHECK(difference(inverse.by_accelerations, cca::floating_mass_matrix(now)) < 1e-12);
      // The rows of the joints are those of a base that moves as it is told.
      const auto held = cca::inverse_dynamics_derivatives(now, at.dq, at.input, at.moving_base());
      CHECK(difference(inverse.by_angles.template bottomRows<s::n>(), held.by_angles) < 1e-12);
      CHECK(difference(inverse.by_velocities.template bottomRows<s::n>(), held.by_velocities) < 1e-12);

      const auto forward = at.forward();
      const auto motion = cca::floating_forward_dynamics(now, at.dq, at.input, at.base, at.load);
      CHECK(forward.accelerations == motion.accelerations);
      CHECK(forward.base.acceleration == motion.base.acceleration);
      CHECK(forward.base.angular_acceleration == motion.base.angular_acceleration);
      Eigen::Matrix<double, s::rows, s::rows> inverse_mass;
      inverse_mass << forward.by_wrench, forward.by_torques;
      CHECK((inverse_mass * cca::floating_mass_matrix(now) - decltype(inverse_mass)::Identity())
                .cwiseAbs()
                .maxCoeff() < 1e-9);
    }
  }

  TEST_CASE_TEMPLATE("a number that is not finite does not come out finite", Body, quadruped, oncilla) {
    using s = state<Body>;
    laws::source random{std::mt19937_64{193}};
    const s good = s::random(random);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      for (int k = 0; k < s::n; ++k) {
        INFO("coordinate ", k);
        s at = good;
        at.q[k] = bad;
        auto d = at.forward();
        CHECK(!d.accelerations.allFinite());
        CHECK(!d.by_angles.col(k).allFinite());
        CHECK(!d.by_angular_velocity.allFinite());
        CHECK(!d.by_wrench.allFinite());
        CHECK(!d.by_torques.col(k).allFinite());
        auto of_loads = at.inverse();
        CHECK(!of_loads.by_angles.col(k).allFinite());
        CHECK(!of_loads.by_accelerations.col(6 + k).allFinite());
        CHECK(!of_loads.by_orientation.allFinite());
        at = good, at.dq[k] = bad;
        CHECK(!at.forward().by_angles.col(k).allFinite());
        CHECK(!at.inverse().by_velocities.col(k).allFinite());
        at = good, at.input[k] = bad;
        CHECK(!at.forward().by_angles.col(k).allFinite());
      }
      for (int k = 0; k < 3; ++k) {
        INFO("of the base ", k);
        s at = good;
        at.base.gravity[k] = bad;
        CHECK(!at.forward().by_orientation.allFinite());
        CHECK(!at.inverse().by_orientation.allFinite());
        at = good, at.base.angular_velocity[k] = bad;
        CHECK(!at.forward().by_angles.allFinite());
        CHECK(!at.forward().by_angular_velocity.allFinite());
        at = good, at.load[k] = bad;
        CHECK(!at.forward().by_angles.allFinite());
      }
    }
  }
}
