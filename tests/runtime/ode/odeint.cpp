// Boost.Numeric.Odeint's steppers as integrators.
#include <doctest/doctest.h>

#include <cmath>

#include <boost/numeric/odeint/algebra/vector_space_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <cca/adaptive/ode_odeint.hpp>

#include "models.hpp"

using namespace ode_test;
namespace odeint = boost::numeric::odeint;

namespace {

using algebra = odeint::vector_space_algebra;
template <class State>
using classical = odeint::runge_kutta4<State, double, State, double, algebra>;
template <class State>
using cash_karp = odeint::runge_kutta_cash_karp54<State, double, State, double, algebra>;
template <class State>
using dopri5 = odeint::runge_kutta_dopri5<State, double, State, double, algebra>;
template <class State>
using fehlberg = odeint::runge_kutta_fehlberg78<State, double, State, double, algebra>;

template <class Integrator>
double order(int steps) {
  const Eigen::Vector2d start(1, 0.5);
  const auto error = [&](int n) {
    return (laws::after<oscillator_case, Integrator>(start, number(0.0), 1.0, n) -
            oscillator::exact(start, 5, 1))
        .norm();
  };
  return std::log2(error(steps) / error(2 * steps));
}

}  // namespace

TEST_CASE("odeint's steppers obey the laws, each with its order") {
  laws::ode_with<oscillator_case, cca::odeint<classical>>(4);
  laws::ode_with<oscillator_case, cca::odeint<cash_karp>>(5);
  laws::ode_with<oscillator_case, cca::odeint<dopri5>>(5);
  CHECK(order<cca::odeint<classical>>(100) == doctest::Approx(4).epsilon(0.03));
  CHECK(order<cca::odeint<cash_karp>>(20) == doctest::Approx(5).epsilon(0.05));
  CHECK(order<cca::odeint<dopri5>>(20) == doctest::Approx(5).epsilon(0.05));
  CHECK(order<cca::odeint<fehlberg>>(5) > 7);
}

TEST_CASE("odeint's classical Runge-Kutta method equals rk4, to rounding") {
  const Eigen::Vector2d start(1, 0.5);
  const auto ours = laws::after<oscillator_case, cca::rk4>(start, number(0.3), 1.0, 100);
  const auto theirs = laws::after<oscillator_case, cca::odeint<classical>>(start, number(0.3), 1.0, 100);
  CHECK((ours - theirs).norm() < 1e-13);
}
