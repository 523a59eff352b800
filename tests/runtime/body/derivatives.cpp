// The derivatives of dynamics, against dual numbers through the recorded algorithms as loops, and against
// central differences: recorded bodies, and larger ones, which use loops.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <cca/robot/dynamics/derivatives.hpp>
#include <cca/robots/oncilla/legged_body.hpp>

#include "../../laws/space_laws.hpp"
#include "bodies.hpp"
#include "../dual.hpp"
#include "recorded_bodies.hpp"

namespace derivatives_test {

using test::dual;
using namespace body_test;
namespace cd = cca::detail;

template <class Body>
struct state {
  static constexpr int n = cca::axes_of<Body>::count;
  static constexpr const auto& links = cd::weighed_links_of<Body>;
  static constexpr const auto& reduced = cd::reduced_body_of<Body>;
  using vector = Eigen::Matrix<double, n, 1>;
  using matrix = Eigen::Matrix<double, n, n>;
  using duals = std::array<dual, static_cast<std::size_t>(n)>;

  vector q, dq, input;  // the input: accelerations or torques
  cca::base_motion base;

  static state random(laws::source& random) {
    state s;
    for (auto& x : s.q) x = random(-3, 3);
    for (auto& x : s.dq) x = random(-2, 2);
    for (auto& x : s.input) x = random(-5, 5);
    s.base = {random.vector(10), random.vector(2), random.vector(3), random.vector(5)};
    return s;
  }
  vector& part(int which) { return which == 0 ? q : which == 1 ? dq : input; }
  cca::body_pose<Body> pose() const { return cca::body_pose<Body>(q); }

  // The derivative by one coordinate of q, dq or the input.
  vector by_dual_numbers(bool forward, int which, int k) const {
    const auto seeded = [&](const vector& v, int i) {
      duals d;
      for (int c = 0; c < n; ++c) d[static_cast<std::size_t>(c)] = {v[c], which == i && k == c ? 1.0 : 0.0};
      return d;
    };
    const duals angle = seeded(q, 0), speed = seeded(dq, 1), given = seeded(input, 2);
    const auto joints =
        cd::placed_joints<dual>(reduced, test::joint_values_at<cd::reduced_body_of<Body>>(angle));
    cd::link_motion<dual> root;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto e = static_cast<Eigen::Index>(i);
      root.w[i] = base.angular_velocity[e], root.dw[i] = base.angular_acceleration[e];
      root.a[i] = base.acceleration[e] - base.gravity[e];
    }
    duals torques{};
    cd::add_newton_euler(reduced, joints, root, speed, forward ? duals{} : given, torques);
    if (forward) {
      for (std::size_t c = 0; c < torques.size(); ++c) torques[c] = given[c] - torques[c];
      cd::square<dual, n> m;
      cd::add_mass_matrix<false>(reduced, joints, m);
      CHECK(cd::solve(m, torques, cd::order_of_solution<false, n>(reduced)));
    }
    vector result;
    for (int c = 0; c < n; ++c) result[c] = torques[static_cast<std::size_t>(c)].slope;
    return result;
  }
  // Sixth order.
  vector by_differences(bool forward, int which, int k) const {
    const auto at = [&](double step) {
      state s = *this;
      s.part(which)[k] += step;
      if (forward) return vector(cca::forward_dynamics(s.pose(), s.dq, s.input, s.base));
      return vector(cca::inverse_dynamics(s.pose(), s.dq, s.input, s.base).torques);
    };
    const double h = 2e-3;
    return (45 * (at(h) - at(-h)) - 9 * (at(2 * h) - at(-2 * h)) + (at(3 * h) - at(-3 * h))) / (60 * h);
  }
  std::array<matrix, 3> all_by(vector (state::*way)(bool, int, int) const, bool forward) const {
    std::array<matrix, 3> all;
    for (int which = 0; which < 3; ++which)
      for (int k = 0; k < n; ++k)
        all[static_cast<std::size_t>(which)].col(k) = (this->*way)(forward, which, k);
    return all;
  }

  auto loops() const {
    std::array<cd::placed_link, links.size()> placed;
    cd::place_links(links, q, placed);
    return cd::derivatives_of_torques<n, links.size()>(links, placed, dq, input, base);
  }
};

using oncilla = cca::robots::oncilla::legged_body;
template <class Body>
constexpr bool is_recorded = cd::is_recorded<cd::recorded_torque_derivatives<Body, true>>();
static_assert(is_recorded<arm> && !is_recorded<random_tree_body> && !is_recorded<humanoid>);
static_assert(cd::is_recorded<cd::recorded_torque_derivatives<oncilla, false>>());

template <class Matrix>
double difference(const Matrix& a, const Matrix& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}
template <class Matrix>
std::array<Matrix, 3> matrices(const Matrix& a, const Matrix& b, const Matrix& c) {
  return {a, b, c};
}
template <class Result>
auto inverse_matrices(const Result& d) {
  return matrices(d.by_angles, d.by_velocities, d.by_accelerations);
}
template <class Result>
auto forward_matrices(const Result& d) {
  return matrices(d.by_angles, d.by_velocities, d.by_torques);
}
template <class Matrices>
void check(const char* what, const Matrices& found, const Matrices& wanted, double bound) {
  INFO(what);
  for (std::size_t i = 0; i < 3; ++i) {
    INFO("by the ", i == 0 ? "angles" : i == 1 ? "velocities" : "input");
    CHECK(difference(found[i], wanted[i]) < bound);
  }
}

// Each entry that is not finite in `wanted` is not finite in `found`.
template <class Matrix>
int lost(const Matrix& found, const Matrix& wanted) {
  int count = 0;
  for (int k = 0; k < found.size(); ++k)
    count += std::isfinite(found.data()[k]) && !std::isfinite(wanted.data()[k]);
  return count;
}

}  // namespace derivatives_test

using namespace derivatives_test;

TEST_SUITE("derivatives of dynamics") {
  TEST_CASE_TEMPLATE("as by dual numbers, and by differences", Body, arm, hound, star_of_arms, oncilla,
                     random_tree_body, humanoid) {
    using s = state<Body>;
    laws::source random{std::mt19937_64{91}};
    for (int round = 0; round < (s::n > 10 ? 3 : 20); ++round) {
      const s at = s::random(random);
      const auto inverse =
                     inverse_matrices(cca::inverse_dynamics_derivatives(at.pose(), at.dq, at.input, at.base)),
                 wanted = at.all_by(&s::by_dual_numbers, false);
      check("inverse dynamics", inverse, wanted, 1e-12);
      check("inverse dynamics by loops", inverse_matrices(at.loops()), wanted, 1e-12);
      check("inverse dynamics and differences", inverse, at.all_by(&s::by_differences, false), 1e-8);

      const auto forward =
          forward_matrices(cca::forward_dynamics_derivatives(at.pose(), at.dq, at.input, at.base));
      check("forward dynamics", forward, at.all_by(&s::by_dual_numbers, true), 1e-10);
      check("forward dynamics and differences", forward, at.all_by(&s::by_differences, true), 1e-7);
    }
  }

  TEST_CASE_TEMPLATE("a base that stands", Body, arm, hound, oncilla, random_tree_body) {
    using s = state<Body>;
    laws::source random{std::mt19937_64{92}};
    for (int round = 0; round < 20; ++round) {
      s at = s::random(random);
      at.base = {};
      const auto now = at.pose();
      const auto inverse = cca::inverse_dynamics_derivatives(now, at.dq, at.input);
      check("inverse dynamics", inverse_matrices(inverse), at.all_by(&s::by_dual_numbers, false), 1e-12);
      const auto forward = cca::forward_dynamics_derivatives(now, at.dq, at.input);
      check("forward dynamics", forward_matrices(forward), at.all_by(&s::by_dual_numbers, true), 1e-10);
      // Of a base that stands, the torques are quadratic in the velocities: Christoffel symbols.
      CHECK(difference<typename s::matrix>(inverse.by_velocities, 2 * cca::coriolis_matrix(now, at.dq)) <
            1e-12);
      CHECK(difference<typename s::matrix>(inverse.by_accelerations, cca::mass_matrix(now)) < 1e-12);
      CHECK((forward.by_torques * inverse.by_accelerations - s::matrix::Identity()).norm() < 1e-9);
      CHECK(difference<typename s::vector>(inverse.torques,
                                           cca::inverse_dynamics(now, at.dq, at.input).torques) < 1e-12);
      CHECK(forward.accelerations == cca::forward_dynamics(now, at.dq, at.input));
    }
  }

  TEST_CASE_TEMPLATE("a number that is not finite does not come out finite", Body, arm, hound, oncilla,
                     random_tree_body) {
    using s = state<Body>;
    laws::source random{std::mt19937_64{93}};
    const s good = s::random(random);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      const auto check_lost = [&](s at) {
        for (const bool stands : {false, true}) {
          if (stands) at.base = {};
          const auto loops = at.loops();
          const auto d = stands ? cca::inverse_dynamics_derivatives(at.pose(), at.dq, at.input)
                                : cca::inverse_dynamics_derivatives(at.pose(), at.dq, at.input, at.base);
          CHECK(lost(d.torques, loops.torques) == 0);
          CHECK(lost(d.by_angles, loops.by_angles) == 0);
          CHECK(lost(d.by_velocities, loops.by_velocities) == 0);
          CHECK(lost(d.by_accelerations, loops.by_accelerations) == 0);
        }
      };
      for (int k = 0; k < s::n; ++k)
        for (int which = 0; which < 3; ++which) {
          INFO("part ", which, ", coordinate ", k);
          s at = good;
          at.part(which)[k] = bad;
          check_lost(at);
          const auto forward = cca::forward_dynamics_derivatives(at.pose(), at.dq, at.input, at.base);
          CHECK(!forward.accelerations.allFinite());
          if (which < 2) CHECK(!forward.by_angles.col(k).allFinite());
          if (which == 0) CHECK(!forward.by_torques.col(k).allFinite());
        }
      for (int k = 0; k < 3; ++k) {
        INFO("of the base ", k);
        s at = good;
        at.base.gravity[k] = bad, check_lost(at);
        at = good, at.base.angular_velocity[k] = bad, check_lost(at);
        at = good, at.base.acceleration[k] = bad, check_lost(at);
        at = good, at.base.angular_acceleration[k] = bad, check_lost(at);
      }
    }
  }

  TEST_CASE("a number that is not finite stays in its leg, and the mass does not know of gravity") {
    using s = state<oncilla>;
    laws::source random{std::mt19937_64{94}};
    s at = s::random(random);
    at.base = {};
    const auto untouched = cca::forward_dynamics_derivatives(at.pose(), at.dq, at.input);
    constexpr const auto& coupled = cd::coupled_coordinates_of<oncilla>;
    at.q[0] = std::nan("");
    const auto d = cca::forward_dynamics_derivatives(at.pose(), at.dq, at.input);
    int same = 0, gone = 0;
    for (int r = 0; r < s::n; ++r)
      for (int c = 0; c < s::n; ++c) {
        const bool own = coupled(0, r) && coupled(0, c);
        same += !own && d.by_angles(r, c) == untouched.by_angles(r, c);
        gone += own && std::isnan(d.by_angles(r, c));
      }
    CHECK(gone == 4);  // a leg has a hip and a knee
    CHECK(same == s::n * s::n - 4);

    using of_arm = state<arm>;
    of_arm other = of_arm::random(random);
    other.base.gravity[0] = std::nan("");
    const auto by = cca::inverse_dynamics_derivatives(other.pose(), other.dq, other.input, other.base);
    CHECK(by.by_accelerations.allFinite());
    CHECK(!by.by_angles.allFinite());
  }
}
