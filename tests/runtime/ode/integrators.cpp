// Integrators against closed forms: their order, and the energy with semi-implicit Euler.
#include <doctest/doctest.h>

#include <cmath>

#include "models.hpp"

using namespace ode_test;

namespace {

// The order at t = 1, measured by halving the step.
template <class Integrator>
double order_on_decay(int steps) {
  const double exact = std::exp(-3.0);
  const auto error = [&](int n) {
    return std::abs(laws::after<decay_case, Integrator>(number(1.0), number(0.0), 1.0, n)[0] - exact);
  };
  return std::log2(error(steps) / error(2 * steps));
}

template <class Integrator>
double error_on_oscillator(double seconds, int steps) {
  const Eigen::Vector2d start(1, 0.5);
  return (laws::after<oscillator_case, Integrator>(start, number(0.0), seconds, steps) -
          oscillator::exact(start, 5, seconds))
      .norm();
}

template <class Integrator>
double order_on_oscillator(int steps) {
  return std::log2(error_on_oscillator<Integrator>(1, steps) / error_on_oscillator<Integrator>(1, 2 * steps));
}

}  // namespace

TEST_CASE("the laws of an ode hold for the decay") { laws::ode<decay_case>(); }
TEST_CASE("the laws of an ode hold for the oscillator") { laws::ode<oscillator_case>(); }

TEST_CASE("orders of convergence to the closed forms") {
  CHECK(order_on_decay<cca::explicit_euler>(1000) == doctest::Approx(1).epsilon(0.02));
  CHECK(order_on_decay<cca::rk4>(50) == doctest::Approx(4).epsilon(0.03));
  CHECK(order_on_oscillator<cca::explicit_euler>(4000) == doctest::Approx(1).epsilon(0.03));
  CHECK(order_on_oscillator<cca::semi_implicit_euler>(1000) == doctest::Approx(1).epsilon(0.03));
  CHECK(order_on_oscillator<cca::rk4>(100) == doctest::Approx(4).epsilon(0.03));
}

TEST_CASE("rk4 is exact for a cubic in time") {
  struct cubic {
    using state = Eigen::Vector2d;  // time and t^4
    using input = Eigen::Matrix<double, 0, 1>;
    struct parameters {};
    static state derivative(const state& x, const input&, const parameters&) {
      return {1, 4 * x[0] * x[0] * x[0]};
    }
  };
  Eigen::Vector2d x(0, 0);
  cca::rk4::step<cubic>(x, {}, {}, 2.0);
  CHECK(x[1] == doctest::Approx(16).epsilon(1e-14));
}

TEST_CASE("semi-implicit Euler keeps the energy of an undamped oscillator, explicit Euler makes it grow") {
  const auto energy = [](const Eigen::Vector2d& x) { return x[1] * x[1] + 25 * x[0] * x[0]; };
  const Eigen::Vector2d start(1, 0);
  // Symplectic: it keeps q'^2 + w^2 q^2 - w^2 dt q q' exactly, so the energy stays within w dt / 2 of it
  // (here 0.25 %).
  double least = 1e9, most = 0;
  Eigen::Vector2d x = start;
  for (int i = 0; i < 100'000; ++i) {
    cca::semi_implicit_euler::step<oscillator>(x, number(0.0), {5}, 1e-3);
    least = std::min(least, energy(x)), most = std::max(most, energy(x));
  }
  CHECK(least > 25 * (1 - 0.003));
  CHECK(most < 25 * (1 + 0.006));
  CHECK(energy(laws::after<oscillator_case, cca::explicit_euler>(start, number(0.0), 100.0, 100'000)) >
        10 * energy(start));
}
