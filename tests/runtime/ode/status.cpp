// ODE Status: hysteresis, and a decay that converges.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <cca/adaptive/ode_status.hpp>
#include <cca/component/parameters.hpp>

#include "models.hpp"

using cca::ode_status;
using namespace ode_test;

TEST_CASE("the status has hysteresis") {
  const cca::ode_settling settling{1, 2};
  cca::ode_monitor status;
  CHECK(status.get() == ode_status::transient);
  CHECK(status.update(1.5, settling) == ode_status::transient);  // not yet below 1
  CHECK(status.update(1.0, settling) == ode_status::converged);
  CHECK(status.update(1.5, settling) == ode_status::converged);  // not yet above 2
  CHECK(status.update(2.0, settling) == ode_status::converged);
  CHECK(status.update(2.1, settling) == ode_status::transient);
  CHECK(status.update(1.5, settling) == ode_status::transient);
  CHECK(status.update(0, settling) == ode_status::converged);
  CHECK(status.update(std::numeric_limits<double>::quiet_NaN(), settling) == ode_status::transient);
}

TEST_CASE("thresholds in the wrong order are refused") {
  CHECK_NOTHROW(cca::check_parameters(cca::ode_settling{}));
  CHECK_THROWS_AS(cca::check_parameters(cca::ode_settling{2, 1}), cca::refused);
}

TEST_CASE("a decay converges when its closed form says so, and leaves when the input does") {
  cca::ode_solver<decay> solver(number(1.0));
  cca::ode_monitor status;
  const decay::parameters p{3};
  const cca::ode_settling settling{1e-3, 2e-3};
  // |x'| = 3 e^(-3 t) = 1e-3 at t = ln(3000) / 3.
  int beats = 0;
  while (status.update(solver.rate(number(0.0), p).norm(), settling) == ode_status::transient)
    solver.advance(number(0.0), p, 1e-3), ++beats;
  CHECK(beats == static_cast<int>(std::ceil(std::log(3000.0) / 3 * 1000)));
  CHECK(status.update(solver.rate(number(0.5), p).norm(), settling) == ode_status::transient);
}
