// Legal numbers that once destroyed a state: steps that are too long for an explicit integrator, and inputs
// whose squares overflow.
#include <cca/motor.hpp>

#include "../motor/rig.hpp"

using namespace motor_test;

namespace {

using number = Eigen::Matrix<double, 1, 1>;
using cca::ode_status;

template <class Space>
double status_in(const cca::out<"status", Space>& port) {
  return port.vector()[0];
}

}  // namespace

TEST_CASE("hopf reaches any amplitude, and the new one after it") {
  cca::hopf<stride> cpg;
  using wanted = cca::in<"amplitude", cca::over<cca::amplitude, stride>>;
  for (const double amplitude : {12.0, 20.0, 1e3, 1e9, 0.5}) {
    double radius = 0, status = 0, turned = 0, before = 0;
    for (int k = 0; k < 3000; ++k) {
      const auto [phase, size, state] = cpg.process(given<wanted>(number(amplitude)), {}, at(k));
      if (k > 0) turned += cca::wrap_signed(phase.vector()[0] - before);
      before = phase.vector()[0], radius = size.vector()[0], status = status_in(state);
    }
    CHECK(radius == doctest::Approx(amplitude).epsilon(1e-6));
    CHECK(turned == doctest::Approx(2 * cca::pi * 2.999).epsilon(1e-6));  // 1 Hz
    CHECK(status == cca::status_of(ode_status::transient));
  }
}

TEST_CASE("the closed form of the Hopf oscillator is what small steps lead to") {
  laws::ode_source random{std::mt19937_64{2}};
  for (int run = 0; run < 50; ++run) {
    const cca::hopf_ode::input u(random(-2, 2), random(0, 3));
    const cca::hopf_ode::parameters p{random(0, 20)};
    const cca::hopf_ode::state x(random(-2, 2), random(-2, 2));
    cca::ode_solver<cca::hopf_ode> solver(x);
    for (int k = 0; k < 1000; ++k) solver.advance(u, p, 1e-4);
    CHECK((solver.get() - cca::hopf_ode::flow(x, u, p, 0.1)).norm() < 1e-8);
  }
  const cca::hopf_ode::state still = cca::hopf_ode::flow({0.3, 0}, {0, 0}, {10}, 0.1);
  CHECK(still[0] == doctest::Approx(0.3 / std::sqrt(1 + 2 * 10 * 0.3 * 0.3 * 0.1)));  // r' = -c r^3
}

TEST_CASE("a discrete movement arrives in any duration that is accepted") {
  using goal = cca::in<"goal", leg>;
  for (const double seconds : {0.001, 0.004, 0.02, 0.5}) {
    cca::dmp_discrete<leg, 5> reach;
    reach.p.duration = seconds;
    REQUIRE_NOTHROW(cca::check_parameters(reach.p));
    Eigen::Vector2d y(0, 0);
    double most = 0;
    for (int k = 0; k < 1500; ++k) {
      const auto [position, velocity, progress, status] =
          reach.process(given<goal>(Eigen::Vector2d(1, -1)), {}, {}, {}, at(k));
      y = position.vector();
      most = std::max(most, y.norm());
      CHECK(status_in(status) != cca::status_of(ode_status::clamped));  // at most 16 parts are enough
    }
    CHECK((y - Eigen::Vector2d(1, -1)).norm() < 1e-2);
    CHECK(most < 1.5);
  }
  // Too stiff for a slow node: as fast as it can be, and it says so.
  cca::dmp_discrete<leg, 5> stiff;
  stiff.p.duration = 0.001, stiff.p.stiffness = 1000.0;
  double last = 0;
  for (int k = 0; k < 200; ++k) {
    const auto [position, velocity, progress, status] =
        stiff.process(given<goal>(Eigen::Vector2d(1, -1)), {}, {}, {}, cca::beat(k, 100'000'000, 1));
    CHECK(status_in(status) == cca::status_of(ode_status::clamped));
    CHECK(position.vector().norm() < 1.5);
    last = position.vector()[0];
  }
  CHECK(last == doctest::Approx(1).epsilon(1e-2));
}

TEST_CASE("a gait locks with any accepted coupling and convergence") {
  struct lf : cca::dimension<"left_front"> {};
  struct rf : cca::dimension<"right_front"> {};
  struct lh : cca::dimension<"left_hind"> {};
  struct rh : cca::dimension<"right_hind"> {};
  using network = cca::gait_network<lf, rf, lh, rh>;
  using amplitude = cca::in<"amplitude", network::legs<cca::amplitude>>;
  for (const double stiff : {900.0, 950.0, 1000.0}) {
    network net;
    net.p.gait = cca::gait::walk, net.p.coupling = stiff, net.p.convergence = stiff;
    Eigen::Vector4d phases = Eigen::Vector4d::Zero();
    for (int k = 0; k < 3000; ++k) {
      const auto [phase, size, status] =
          net.process(given<amplitude>(Eigen::Vector4d::Ones()), {}, {}, at(k));
      phases = phase.vector();
    }
    CHECK(cca::wrap_signed(phases[2] - phases[0]) / (2 * cca::pi) == doctest::Approx(0.25).epsilon(1e-6));
  }
}

TEST_CASE("VITE holds for any accepted stiffness at any rate, and never moves away from its target") {
  using target = cca::in<"target", leg>;
  using go = cca::optional_in<"go", cca::over<cca::amplitude, cca::go_axis>>;
  for (const std::int64_t period : {1'000'000, 10'000'000, 1'000'000'000})
    for (const double factor : {-5.0, 0.0, 1.0, 1e4, 1e30}) {
      cca::vite<leg> reach;
      reach.p.convergence = 1000, reach.p.speed = 250, reach.p.rise = 0;
      double most = 0, last = 0;
      for (int k = 0; k < 4000; ++k) {
        const auto [position, velocity, status] = reach.process(given<target>(Eigen::Vector2d(1, 1)), {},
                                                                wired<go>(number(factor)), {k, period, 1});
        last = position.vector()[0], most = std::max(most, std::abs(last));
      }
      CHECK(most < 2.1);
      if (factor <= 0) CHECK(last == 0);
      if (factor == 1) CHECK(last == doctest::Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("motion models come back from 1e200") {
  cca::hmm_motion<plane, 3> parts;
  parts.p.mixture.means.row(0) << -1, 0, 1;
  parts.p.transitions << 0.8, 0.1, 0.1, 0.1, 0.8, 0.1, 0.1, 0.1, 0.8;
  using position = cca::in<"position", plane>;
  const auto likely = [&](double x) {
    return std::get<1>(parts.process(given<position>(Eigen::Vector2d(x, 0)))).vector()[0];
  };
  for (int k = 0; k < 50; ++k) CHECK(std::isfinite(likely(1e200)));
  CHECK(parts.states().allFinite());
  for (int k = 0; k < 50; ++k) (void)likely(-1);
  CHECK(likely(-1) == 0);

  cca::gmr<cca::over<cca::number, stride>, leg, 3> motion;
  using input = cca::in<"input", cca::over<cca::number, stride>>;
  const auto [y, spread, status] = motion.process(given<input>(number(1e200)));
  CHECK(y.vector().allFinite());
  CHECK(spread.vector().allFinite());
  CHECK(status_in(status) == cca::status_of(cca::input_status::clamped));
  auto bad = motion.p;
  bad.mixture.covariances[0](0, 0) = 1e-30;
  CHECK_THROWS_AS(cca::check_parameters(bad), cca::refused);
}

TEST_CASE("while a movement stands still because of NaN, the velocity that it publishes is 0") {
  cca::vite<leg> reach;
  using target = cca::in<"target", leg>;
  for (int k = 0; k < 300; ++k) (void)reach.process(given<target>(Eigen::Vector2d(1, 1)), {}, {}, at(k));
  const auto [position, velocity, status] =
      reach.process(given<target>(Eigen::Vector2d(1, std::nan(""))), {}, {}, at(300));
  CHECK(!position);
  REQUIRE(velocity);
  CHECK(velocity.vector().norm() == 0);
  CHECK(status_in(status) == cca::status_of(ode_status::unreadable));
}
