// Movement primitives: the spring without forcing term, shapes from regression, changes of goal and duration,
// limit cycles.
#include <cca/motor/dmp_discrete.hpp>
#include <cca/motor/dmp_rhythmic.hpp>
#include <vector>

#include <Eigen/Cholesky>

#include "rig.hpp"

using namespace motor_test;

namespace {

constexpr int N = 20;
using reach = cca::dmp_discrete<leg, N>;
using swing = cca::dmp_rhythmic<leg, stride, N>;
using goal = cca::in<"goal", leg>;
using start = cca::optional_in<"start", leg>;
using duration = cca::optional_in<"duration", cca::movement_duration>;
using restart = cca::optional_in<"restart", cca::restart_signal>;
using number = Eigen::Matrix<double, 1, 1>;

struct discrete_case {
  using ode = cca::dmp_discrete_ode<2, 8>;
  static constexpr double rate = 30;
  static ode::parameters parameters() {
    ode::parameters p{{}, 25, 5, 12, true};
    for (int i = 0; i < 8; ++i) p.weights.col(i) << 40 * std::sin(i), -30 * std::cos(2 * i);
    return p;
  }
  static ode::state state(laws::ode_source& random) {
    auto x = random.vector<ode::state>(-1, 1);
    x[6] = random(0.05, 1);
    return x;
  }
  static ode::input input(laws::ode_source& random) {
    auto u = random.vector<ode::input>(-1, 1);
    u[4] = random(0.8, 2);
    return u;
  }
  static auto equilibrium(laws::ode_source& random) {  // at the goal, long after the end
    const auto u = input(random);
    auto x = ode::at_rest(u.head<2>(), u.head<2>());
    x[6] = 0;
    return std::pair(x, u);
  }
};

struct rhythmic_case {
  using ode = cca::dmp_rhythmic_ode<2, 8>;
  static constexpr double rate = 60;
  static ode::parameters parameters() {
    static const Eigen::Matrix<double, 2, 8> weights = [] {
      Eigen::Matrix<double, 2, 8> w;
      for (int i = 0; i < 8; ++i) w.col(i) << 40 * std::sin(i), -30 * std::cos(2 * i);
      return w;
    }();
    return {weights, 25};
  }
  static ode::state state(laws::ode_source& random) { return random.vector<ode::state>(-1, 1); }
  static ode::input input(laws::ode_source& random) {
    return {random(-1, 1), random(-1, 1), random(0, 1), random(0.5, 1)};
  }
};

// Minimum jerk from y0 to g in tau seconds (Flash and Hogan 1985): position, velocity, acceleration at t.
struct point {
  double y, v, a;
};
point minimum_jerk(double y0, double g, double tau, double t) {
  const double s = t / tau, w = g - y0;
  return {y0 + w * (10 * s * s * s - 15 * s * s * s * s + 6 * s * s * s * s * s),
          w / tau * 30 * s * s * (1 - s) * (1 - s), w / tau / tau * (60 * s - 180 * s * s + 120 * s * s * s)};
}

// Weights that reproduce minimum jerk over a distance of 1 in 1 s, by least squares over a thousand times.
reach::weight_matrix fitted(const reach& dmp) {
  const reach::ode::parameters p{dmp.p.weights, dmp.p.stiffness, dmp.p.decay, dmp.p.goal_rate, true};
  Eigen::Matrix<double, N, N> A = 1e-10 * Eigen::Matrix<double, N, N>::Identity();
  Eigen::Matrix<double, N, 1> b = Eigen::Matrix<double, N, 1>::Zero();
  for (int k = 0; k <= 1000; ++k) {
    const double t = k * 1e-3, x = std::exp(-5 * t);
    const auto m = minimum_jerk(0, 1, 1, t);
    const Eigen::Matrix<double, N, 1> phi = x * cca::discrete_activations<N>(x, 5);
    const auto f = reach::ode::wanted_forcing(Eigen::Vector2d::Constant(m.y), Eigen::Vector2d::Constant(m.v),
                                              Eigen::Vector2d::Constant(m.a), Eigen::Vector2d::Ones(), 1, p);
    A += phi * phi.transpose(), b += phi * f[0];
  }
  const Eigen::Matrix<double, N, 1> w = A.ldlt().solve(b);
  reach::weight_matrix weights;
  weights << w.transpose(), w.transpose();
  return weights;
}

auto step(reach& dmp,
          int k,
          const Eigen::Vector2d& g,
          const Eigen::Vector2d& from = {0, 0},
          double tau = 0,
          bool again = false) {
  return dmp.process(given<goal>(g), wired<start>(from), tau > 0 ? wired<duration>(number(tau)) : duration{},
                     wired<restart>(number(0.0), again), at(k));
}

using phase = cca::in<"phase", cca::over<cca::phase, stride>>;
using amplitude = cca::in<"amplitude", cca::over<cca::amplitude, stride>>;
using frequency = cca::optional_in<"frequency", cca::over<cca::frequency, stride>>;

auto swung(swing& dmp,
           int k,
           double hertz,
           double r,
           const Eigen::Vector2d& g,
           std::optional<Eigen::Vector2d> from = {}) {
  return dmp.process(given<phase>(number(2 * cca::pi * hertz * (k + 1) * 1e-3)), given<amplitude>(number(r)),
                     wired<frequency>(number(hertz)), given<goal>(g), from ? wired<start>(*from) : start{},
                     at(k));
}

}  // namespace

TEST_CASE("discrete and rhythmic movement primitives obey the laws of an ode") {
  laws::ode<discrete_case>();
  laws::ode<rhythmic_case>();
}

TEST_CASE("activations sum to one, and each is largest at its centre") {
  for (int i = 0; i < N; ++i) {
    const double x = std::exp(-5.0 * i / (N - 1));
    const auto psi = cca::discrete_activations<N>(x, 5);
    CHECK(psi.sum() == doctest::Approx(1));
    Eigen::Index top = 0;
    psi.maxCoeff(&top);
    CHECK(top == i);
    const auto turning = cca::rhythmic_activations<N>(2 * cca::pi * i / N - 20 * cca::pi);
    CHECK(turning.sum() == doctest::Approx(1));
    turning.maxCoeff(&top);
    CHECK(top == i);
  }
  CHECK(cca::discrete_activations<200>(0, 5).allFinite());
  CHECK(cca::discrete_activations<N>(1e3, 5) ==
        cca::activations<N>(cca::activations<N>::Zero()));  // far from all centres
}

template <int Count>
void check_rhythmic_activations() {
  CAPTURE(Count);
  for (double phase = -30; phase < 30; phase += 0.0371) {
    Eigen::Matrix<double, Count, 1> expected;
    for (int i = 0; i < Count; ++i)
      expected[i] = std::exp(2.5 * Count * (std::cos(phase - 2 * cca::pi * i / Count) - 1));
    expected /= expected.sum();
    REQUIRE((cca::rhythmic_activations<Count>(phase) - expected).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("rhythmic activations equal equation 2.7, for many functions and few") {
  check_rhythmic_activations<1>();
  check_rhythmic_activations<7>();
  check_rhythmic_activations<40>();
  check_rhythmic_activations<200>();  // the smallest underflow in a double
}

TEST_CASE("without weights a primitive is a critically damped spring") {
  reach dmp;
  dmp.p.duration = 2;
  for (int k = 0; k < 3000; ++k) {
    const auto [y, v, x, s] = step(dmp, k, {0.8, -0.3}, {0.1, 0.2});
    const double l = 25 / (2 * 2.0), lt = l * 1e-3 * (k + 1);
    CHECK(std::abs(y[hip{}] - (0.8 - 0.7 * (1 + lt) * std::exp(-lt))) < 1e-9);
    CHECK(std::abs(y[knee{}] - (-0.3 + 0.5 * (1 + lt) * std::exp(-lt))) < 1e-9);
    CHECK(std::abs(v[hip{}] - 0.7 * l * lt * std::exp(-lt)) < 1e-8);
    CHECK(std::abs(x.vector()[0] - std::exp(-5 * 1e-3 * (k + 1) / 2)) < 1e-9);
  }
}

TEST_CASE(
    "with fitted weights it reproduces minimum jerk to 0.2 % of the way, also to another goal and in another "
    "time") {
  reach dmp;
  dmp.p.weights = fitted(dmp);
  for (const auto& [to, tau] : {std::pair(1.0, 1.0), std::pair(-0.4, 1.0), std::pair(0.5, 2.0)}) {
    reach one = dmp;
    double worst = 0, fastest = 0;
    for (int k = 0; k < 1000 * tau; ++k) {
      const auto [y, v, x, s] = step(one, k, {0.1 + to, 0}, {0.1, 0}, tau);
      const auto m = minimum_jerk(0.1, 0.1 + to, tau, 1e-3 * (k + 1));
      worst = std::max(worst, std::abs(y[hip{}] - m.y));
      fastest = std::max(fastest, std::abs(v[hip{}]));
    }
    CHECK(worst < 0.002 * std::abs(to));
    CHECK(fastest == doctest::Approx(1.875 * std::abs(to) / tau).epsilon(0.01));
  }
}

TEST_CASE("a goal that changes during the movement is reached without a jump of the velocity") {
  reach dmp;
  dmp.p.weights = fitted(dmp);
  double last = 0, jump = 0, y = 0, status = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto [position, v, x, s] = step(dmp, k, {k < 500 ? 1.0 : 0.6, 0});
    jump = std::max(jump, std::abs(v[hip{}] - last));
    last = v[hip{}], y = position[hip{}], status = s[cca::ode_axis{}];
    if (k < 100) CHECK(status == cca::status_of(cca::ode_status::transient));
  }
  CHECK(y == doctest::Approx(0.6).epsilon(1e-4));
  CHECK(jump < 0.02);
  CHECK(status == cca::status_of(cca::ode_status::converged));
}

TEST_CASE("a duration that changes during the movement changes the speed, not the path") {
  reach dmp, slow;
  dmp.p.weights = slow.p.weights = fitted(dmp);
  std::vector<double> plain, slowed;
  for (int k = 0; k < 1000; ++k) plain.push_back(std::get<0>(step(dmp, k, {1, 0}, {0, 0}, 1.0))[hip{}]);
  for (int k = 0; k < 1600; ++k)
    slowed.push_back(std::get<0>(step(slow, k, {1, 0}, {0, 0}, k < 400 ? 1.0 : 2.0))[hip{}]);
  for (std::size_t k = 0; k < 600; ++k) CHECK(std::abs(slowed[399 + 2 * k] - plain[399 + k]) < 1e-6);
}

TEST_CASE("a restart begins the shape at the current position; an unscaled shape may end where it began") {
  reach dmp;
  dmp.p.weights = fitted(dmp);
  for (int k = 0; k < 3000; ++k) (void)step(dmp, k, {1, 0});
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto y = std::get<0>(step(dmp, k, {0.5, 0}, {0, 0}, 0, k == 0))[hip{}];
    worst = std::max(worst, std::abs(y - minimum_jerk(1, 0.5, 1, 1e-3 * (k + 1)).y));
  }
  CHECK(worst < 0.002);
  reach loop;
  loop.p.weights.setConstant(200), loop.p.scaled = false;
  double most = 0, end = 1;
  for (int k = 0; k < 3000; ++k) most = std::max(most, end = std::get<0>(step(loop, k, {0, 0}))[hip{}]);
  CHECK(most > 0.1);
  CHECK(std::abs(end) < 1e-3);
}

TEST_CASE(
    "a rhythmic primitive with fitted weights follows the demonstration, scaled by its amplitude, around its "
    "goal") {
  const double hertz = 1.5, tau = 1 / (2 * cca::pi * hertz), w = 2 * cca::pi * hertz;
  swing dmp;
  dmp.p.weights.setZero();
  // sin(phi) + 0.4 cos(2 phi + 1), by least squares.
  const swing::ode::parameters p{dmp.p.weights, dmp.p.stiffness};
  Eigen::Matrix<double, N, N> A = 1e-10 * Eigen::Matrix<double, N, N>::Identity();
  Eigen::Matrix<double, N, 1> b = Eigen::Matrix<double, N, 1>::Zero();
  const auto shape = [](double f) { return std::sin(f) + 0.4 * std::cos(2 * f + 1); };
  for (int i = 0; i < 1000; ++i) {
    const double f = 2 * cca::pi * i / 1000, v = w * (std::cos(f) - 0.8 * std::sin(2 * f + 1)),
                 a = -w * w * (std::sin(f) + 1.6 * std::cos(2 * f + 1));
    const auto phi = cca::rhythmic_activations<N>(f);
    const auto forcing =
        swing::ode::wanted_forcing(Eigen::Vector2d::Constant(shape(f)), Eigen::Vector2d::Constant(v),
                                   Eigen::Vector2d::Constant(a), Eigen::Vector2d::Zero(), tau, p);
    A += phi * phi.transpose(), b += phi * forcing[0];
  }
  dmp.p.weights.row(0) = A.ldlt().solve(b).transpose();
  double worst = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto y = std::get<0>(swung(dmp, k, hertz, 0.3, {0.2, -0.1}));
    if (k > 2000) worst = std::max(worst, std::abs(y[hip{}] - (0.2 + 0.3 * shape(w * (k + 1) * 1e-3))));
    CHECK(std::abs(y[knee{}] + 0.1) < 1e-12);  // without weights it stays at its goal
  }
  CHECK(worst < 0.3 * 0.01);
}

TEST_CASE("the limit cycle attracts as in the closed form; at amplitude 0 or less the goal attracts") {
  swing one, other;
  for (int i = 0; i < N; ++i)
    one.p.weights.col(i) = other.p.weights.col(i) = 60 * Eigen::Vector2d(std::sin(i), std::cos(i));
  const double l = 25 / 2.0 * 2 * cca::pi * 1.0;
  for (int k = 0; k < 400; ++k) {
    const auto a = std::get<0>(swung(one, k, 1, 1, {0, 0}, Eigen::Vector2d(0.5, 0))),
               b = std::get<0>(swung(other, k, 1, 1, {0, 0}, Eigen::Vector2d(-0.5, 0)));
    const double lt = l * 1e-3 * (k + 1);
    CHECK(std::abs(a[hip{}] - b[hip{}] - (1 + lt) * std::exp(-lt)) < 1e-5);
  }
  double status = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto [y, v, s] = swung(one, k, 1, -1, {0.4, 0.3});
    if (k > 1000) CHECK(std::abs(y[hip{}] - 0.4) < 1e-6);
    status = s[cca::ode_axis{}];
  }
  CHECK(status == cca::status_of(cca::ode_status::converged));
}

TEST_CASE("a duration or a frequency below the minimum counts as the minimum") {
  reach one, least;
  CHECK(
      std::get<0>(one.process(given<goal>({1, 0}), {}, wired<duration>(number(0.0)), {}, at(0))).vector() ==
      std::get<0>(least.process(given<goal>({1, 0}), {}, wired<duration>(number(1e-3)), {}, at(0))).vector());
  swing turning, slow;
  for (int k = 0; k < 100; ++k)
    CHECK(std::get<0>(turning.process(given<phase>(number(0.1)), given<amplitude>(number(1.0)),
                                      wired<frequency>(number(-1.0)), given<goal>({k < 3 ? 1.0 : 0.0, 0}), {},
                                      at(k)))
              .vector() == std::get<0>(slow.process(given<phase>(number(0.1)), given<amplitude>(number(1.0)),
                                                    wired<frequency>(number(0.01)),
                                                    given<goal>({k < 3 ? 1.0 : 0.0, 0}), {}, at(k)))
                               .vector());
}

TEST_CASE("movement primitives do not allocate") {
  reach dmp;
  swing turning;
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 500; ++k) (void)step(dmp, k, {1, 0}), (void)swung(turning, k, 1, 1, {0, 0});
  CHECK(laws::allocations() == before);
}
