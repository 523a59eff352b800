// Coupled oscillators: closed forms for two, gaits for four.
#include <cca/motor/gait_network.hpp>

#include "rig.hpp"

using namespace motor_test;

namespace {

struct lf : cca::dimension<"left_front"> {};
struct rf : cca::dimension<"right_front"> {};
struct lh : cca::dimension<"left_hind"> {};
struct rh : cca::dimension<"right_hind"> {};
using network = cca::gait_network<lf, rf, lh, rh>;
using amplitude = cca::in<"amplitude", network::legs<cca::amplitude>>;
using frequency = cca::optional_in<"frequency", network::legs<cca::frequency>>;
using choice = cca::optional_in<"gait", cca::gait_choice>;

template <int N>
typename cca::oscillator_network_ode<N>::parameters coupled(double w) {
  typename cca::oscillator_network_ode<N>::parameters p;
  p.weights.setConstant(w);
  p.weights.diagonal().setZero();
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) p.phases(i, j) = 0.7 * (j - i);
  p.convergence = 20;
  return p;
}

struct network_case {
  using ode = cca::oscillator_network_ode<4>;
  static constexpr double rate = 40;
  static ode::parameters parameters() { return coupled<4>(3); }
  static ode::state state(laws::ode_source& random) { return random.vector<ode::state>(-1, 1); }
  static ode::input input(laws::ode_source& random) { return random.vector<ode::input>(0, 1.5); }
  static auto equilibrium(laws::ode_source& random) {  // locked, not turning
    ode::state x = ode::state::Zero();
    ode::input u = input(random);
    u.head<4>().setZero();
    for (int i = 0; i < 4; ++i) x[i] = 0.7 * i, x[4 + i] = u[4 + i];
    return std::pair(x, u);
  }
};

struct pair_case {
  using ode = cca::oscillator_network_ode<2>;
  static ode::parameters parameters() { return coupled<2>(1.5); }
};

// The largest error of a phase difference against the gait.
double off(const Eigen::Vector4d& phases, cca::gait which) {
  const auto wanted = cca::phase_matrix(which);
  double most = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      most = std::max(most, std::abs(cca::wrap_signed(phases[j] - phases[i] - wanted(i, j))));
  return most;
}

auto step(network& net, int k, std::optional<cca::gait> which = {}) {
  return net.process(given<amplitude>(Eigen::Vector4d::Ones()), {},
                     which ? wired<choice>(Eigen::Matrix<double, 1, 1>(cca::status_of(*which))) : choice{},
                     at(k));
}

}  // namespace

TEST_CASE("the network obeys the laws of an ode") { laws::ode<network_case>(); }

TEST_CASE(
    "phase matrices are antisymmetric, consistent round each triangle, and match the names of the gaits") {
  using cca::gait;
  for (const auto which : {gait::walk, gait::trot, gait::pace, gait::bound}) {
    const auto m = cca::phase_matrix(which);
    CHECK((m + m.transpose()).norm() < 1e-12);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        for (int k = 0; k < 4; ++k) CHECK(m(i, j) + m(j, k) == doctest::Approx(m(i, k)));
  }
  const auto together = [](gait which, int i, int j) {
    return std::abs(cca::wrap_signed(cca::phase_matrix(which)(i, j))) < 1e-12;
  };
  CHECK((together(gait::trot, 0, 3) && together(gait::trot, 1, 2) && !together(gait::trot, 0, 1)));
  CHECK((together(gait::pace, 0, 2) && together(gait::pace, 1, 3) && !together(gait::pace, 0, 1)));
  CHECK((together(gait::bound, 0, 1) && together(gait::bound, 2, 3) && !together(gait::bound, 0, 2)));
  // A walk: left hind, left front, right hind, right front, a quarter of a turn apart.
  for (const auto& [i, j] : {std::pair(0, 2), std::pair(3, 0), std::pair(1, 3), std::pair(2, 1)})
    CHECK(cca::wrap_signed(cca::phase_matrix(gait::walk)(i, j)) == doctest::Approx(cca::pi / 2));
}

TEST_CASE("two oscillators lock as tan(D/2) = tan(D0/2) exp(-2 w t); amplitudes converge critically damped") {
  using ode = pair_case::ode;
  for (const double start : {0.5, 2.0, -3.0})
    for (const double t : {0.2, 0.7, 1.5}) {
      ode::state x;
      x << 0.3, 0.3 + 0.7 + start, 1, 1, 0, 0;
      ode::input u;
      u << 1.1, 1.1, 1, 1;
      const auto end = laws::after<pair_case, cca::rk4>(x, u, t, 1000);
      CHECK(end[1] - end[0] - 0.7 ==
            doctest::Approx(2 * std::atan(std::tan(start / 2) * std::exp(-2 * 1.5 * t))).epsilon(1e-8));
      x[2] = 0.2, x[3] = 2;
      const auto grown = laws::after<pair_case, cca::rk4>(x, u, t, 1000);
      CHECK(grown[2] == doctest::Approx(1 - 0.8 * (1 + 10 * t) * std::exp(-10 * t)).epsilon(1e-8));
      CHECK(grown[3] == doctest::Approx(1 + 1.0 * (1 + 10 * t) * std::exp(-10 * t)).epsilon(1e-8));
    }
}

TEST_CASE("the coupling is proportional to the amplitude") {
  using ode = pair_case::ode;
  ode::state x;
  x << 0.3, 0.3 + 0.7 + 2, 0.5, 0.5, 0, 0;
  ode::input u;
  u << 1.1, 1.1, 0.5, 0.5;
  const auto end = laws::after<pair_case, cca::rk4>(x, u, 0.7, 1000);
  CHECK(end[1] - end[0] - 0.7 == doctest::Approx(2 * std::atan(std::tan(1.0) * std::exp(-1.5 * 0.7)))
                                     .epsilon(1e-8));  // half as fast as at 1
}

TEST_CASE(
    "each leg may have its own frequency; without coupling each runs by itself; `convergence` sets the speed "
    "of the amplitudes") {
  network net;
  net.p.coupling = 0, net.p.convergence = 10;
  const Eigen::Vector4d hertz(0.5, 1, 1.5, 2);
  for (int k = 0; k < 300; ++k) {
    const auto [phase, size, state] = net.process(given<amplitude>(Eigen::Vector4d(0.1, 0.2, 0.3, 0.4)),
                                                  wired<frequency>(hertz), {}, at(k));
    const double t = 1e-3 * (k + 1), come = 1 - (1 + 5 * t) * std::exp(-5 * t);
    for (int i = 0; i < 4; ++i) {
      CHECK(std::abs(cca::wrap_signed(phase.vector()[i] - 2 * cca::pi * hertz[i] * t -
                                      cca::gait_phases(cca::gait::trot)[static_cast<std::size_t>(i)])) <
            1e-9);
      CHECK(size.vector()[i] == doctest::Approx(0.1 * (i + 1) * come).epsilon(1e-8));
    }
  }
  const auto unknown = cca::gait_phases(static_cast<cca::gait>(9));
  CHECK(unknown == cca::gait_phases(cca::gait::walk));
}

TEST_CASE("a small disturbance of four decays as exp(-4 w t)") {
  using ode = network_case::ode;
  ode::state x = ode::state::Zero();
  for (int i = 0; i < 4; ++i) x[i] = 0.7 * i + 1e-5 * (i - 1.5), x[4 + i] = 1;
  ode::input u = ode::input::Ones();
  const auto end = laws::after<network_case, cca::rk4>(x, u, 0.25, 1000);
  for (int i = 0; i < 3; ++i)
    CHECK((end[i + 1] - end[i] - 0.7) / 1e-5 == doctest::Approx(std::exp(-4 * 3 * 0.25)).epsilon(1e-4));
}

TEST_CASE("from any phases the ode converges to the matrix of each gait") {
  using cca::gait;
  laws::ode_source random{std::mt19937_64{9}};
  for (const auto which : {gait::walk, gait::trot, gait::pace, gait::bound})
    for (int run = 0; run < 5; ++run) {
      network_case::ode::parameters p = coupled<4>(4);
      p.phases = cca::phase_matrix(which);
      network_case::ode::state x = network_case::ode::state::Zero();
      for (int i = 0; i < 4; ++i) x[i] = random(-cca::pi, cca::pi), x[4 + i] = 1;
      cca::ode_solver<network_case::ode> solver(x);
      for (int k = 0; k < 4000; ++k) solver.advance(network_case::ode::input::Ones(), p, 1e-3);
      CHECK(off(solver.get().head<4>(), which) < 1e-6);
    }
}

TEST_CASE("every change of gait arrives, even if all differences change by pi") {
  using cca::gait;
  for (const auto from : {gait::walk, gait::trot, gait::pace, gait::bound})
    for (const auto to : {gait::walk, gait::trot, gait::pace, gait::bound}) {
      network net;
      Eigen::Vector4d before = Eigen::Vector4d::Zero();
      double status = 0, jump = 0;
      for (int k = 0; k < 1500; ++k) before = std::get<0>(step(net, k, from)).vector();
      CHECK(off(before, from) < 1e-3);
      for (int k = 0; k < 4000; ++k) {
        const auto [phase, size, state] = step(net, k, to);
        for (int i = 0; i < 4; ++i)
          jump = std::max(jump, std::abs(cca::wrap_signed(phase.vector()[i] - before[i])));
        before = phase.vector();
        status = state[cca::ode_axis{}];
      }
      CHECK(off(before, to) < 1e-4);
      CHECK(jump < 0.03);  // turning, coupling and the nudge of one beat: no jump
      CHECK(status == cca::status_of(cca::ode_status::converged));
    }
}

TEST_CASE("an unwired gait comes from the parameter; the frequency is kept") {
  network net;
  net.p.gait = cca::gait::bound;
  net.p.frequency = 1.5;
  double turned = 0;
  Eigen::Vector4d before = Eigen::Vector4d::Zero();
  for (int k = 0; k < 3000; ++k) {
    const Eigen::Vector4d phases = std::get<0>(step(net, k)).vector();
    if (k >= 1000) turned += cca::wrap_signed(phases[2] - before[2]);
    before = phases;
    CHECK((phases.minCoeff() >= 0 && phases.maxCoeff() < 2 * cca::pi));
  }
  CHECK(off(before, cca::gait::bound) < 1e-9);
  CHECK(turned == doctest::Approx(2 * cca::pi * 1.5 * 2).epsilon(1e-6));
}

TEST_CASE("the network does not allocate") {
  network net;
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 1000; ++k) (void)step(net, k, k < 500 ? cca::gait::walk : cca::gait::bound);
  CHECK(laws::allocations() == before);
}
