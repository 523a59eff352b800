// VITE against the closed form of its critically damped case, a reference integration, and the invariants of
// the paper.
#include <vector>

#include <cca/motor/vite.hpp>

#include "rig.hpp"

using namespace motor_test;

namespace {

using reach = cca::vite<leg>;
using target = cca::in<"target", leg>;
using start = cca::optional_in<"start", leg>;
using go = cca::optional_in<"go", cca::over<cca::amplitude, cca::go_axis>>;

struct vite_case {
  using ode = cca::vite_ode<2>;
  static constexpr double rate = 30;
  static ode::parameters parameters() { return {30, 0.3, 2}; }
  static ode::state state(laws::ode_source& random) {
    auto x = random.vector<ode::state>(-1, 1);
    x[4] = random(0.05, 1);
    return x;
  }
  static ode::input input(laws::ode_source& random) { return {random(-1, 1), random(-1, 1), random(0, 8)}; }
};

struct movement {
  std::vector<double> position, velocity, status;
};

movement run(
    reach& arm, const Eigen::Vector2d& to, int beats, double factor = 1, Eigen::Vector2d from = {0, 0}) {
  movement all;
  for (int k = 0; k < beats; ++k) {
    const auto [position, velocity, status] = arm.process(
        given<target>(to), wired<start>(from), wired<go>(Eigen::Matrix<double, 1, 1>(factor)), at(k));
    all.position.push_back(position[hip{}]);
    all.velocity.push_back(velocity[hip{}]);
    all.status.push_back(status[cca::ode_axis{}]);
  }
  return all;
}

int peak(const std::vector<double>& v) {
  return static_cast<int>(std::max_element(v.begin(), v.end()) - v.begin());
}

}  // namespace

TEST_CASE("VITE obeys the laws of an ode") { laws::ode<vite_case>(); }

TEST_CASE(
    "VITE with a constant GO signal, critically damped, follows the closed form, and its velocity has its "
    "peak at 2 / a") {
  reach arm;
  arm.p.rise = 0;
  arm.p.convergence = 20;
  arm.p.speed = 5;
  const auto m = run(arm, {0.8, 0}, 1000);
  for (int k : {10, 100, 300, 900}) {
    const double lt = 10 * (k + 1) * 1e-3;
    CHECK(m.position[static_cast<std::size_t>(k)] ==
          doctest::Approx(0.8 * (1 - (1 + lt) * std::exp(-lt))).epsilon(1e-8));
    CHECK(m.velocity[static_cast<std::size_t>(k)] ==
          doctest::Approx(0.8 * 10 * lt * std::exp(-lt)).epsilon(1e-8));
  }
  CHECK(peak(m.velocity) + 1 == 100);
}

TEST_CASE("VITE with the rising GO signal agrees with a reference integration") {
  reach arm;
  const auto m = run(arm, {0.8, 0}, 1500);
  // Written out, by the midpoint method in steps of 1/50 ms.
  double P = 0, V = 0, t = 0;
  const auto g = [](double s) { return 7.5 * s * s / (0.4 * 0.4 + s * s); };
  for (int k = 0; k < 1500; ++k) {
    for (int i = 0; i < 50; ++i) {
      const double h = 2e-5, P2 = P + h / 2 * g(t) * V, V2 = V + h / 2 * 30 * (0.8 - P - V), s = t + h / 2;
      P += h * g(s) * V2, V += h * 30 * (0.8 - P2 - V2), t += h;
    }
    CHECK(std::abs(m.position[static_cast<std::size_t>(k)] - P) < 1e-7);
  }
}

TEST_CASE(
    "the velocity is bell-shaped: it rises once, falls once, peaks well inside, and overshoots the target by "
    "less than 1 %") {
  reach arm;
  const auto m = run(arm, {0.8, 0}, 2000);
  const int top = peak(m.velocity);
  CHECK(m.velocity.front() < 1e-3);  // it begins smoothly
  for (std::size_t k = 1; k < m.velocity.size(); ++k) {
    if (static_cast<int>(k) <= top) CHECK(m.velocity[k] >= m.velocity[k - 1]);
    else if (m.velocity[k] > 0.01) CHECK(m.velocity[k] <= m.velocity[k - 1]);
  }
  const auto arrived =
      std::find_if(m.position.begin(), m.position.end(), [](double x) { return x > 0.99 * 0.8; }) -
      m.position.begin();
  CHECK(std::abs(static_cast<int>(arrived) - 956) < 10);  // ms: what the header and the page say
  const double relative = top / static_cast<double>(arrived);
  CHECK(relative > 0.3);
  CHECK(relative < 0.5);
  CHECK(*std::max_element(m.position.begin(), m.position.end()) < 0.8 * 1.01);
  CHECK(m.position.back() == doctest::Approx(0.8).epsilon(1e-3));
}

TEST_CASE("twice the distance takes the same time with the same profile, and a larger GO signal is faster") {
  reach near, far, quick;
  const auto a = run(near, {0.4, 0}, 800), b = run(far, {0.8, 0}, 800), c = run(quick, {0.4, 0}, 800, 1.5);
  for (std::size_t k = 0; k < 800; ++k)
    CHECK(b.velocity[k] == doctest::Approx(2 * a.velocity[k]).epsilon(1e-12));
  CHECK(peak(a.velocity) == peak(b.velocity));
  CHECK(peak(c.velocity) < peak(a.velocity));
}

TEST_CASE("both axes move in step, whatever their distances, and the movement begins at start") {
  reach arm;
  for (int k = 0; k < 700; ++k) {
    const auto x = std::get<0>(arm.process(given<target>({1.0, -0.2}), wired<start>({0.2, 0.4}), {}, at(k)));
    CHECK((x[hip{}] - 0.2) / 0.8 == doctest::Approx((x[knee{}] - 0.4) / -0.6).epsilon(1e-9));
  }
}

TEST_CASE("with go = 0 it holds still, the status reports arrival, and a second movement equals the first") {
  reach arm;
  for (const double v : run(arm, {0.8, 0}, 100, 0).velocity) CHECK(v == 0);
  reach twice;
  const auto there = run(twice, {0.8, 0}, 4000);
  CHECK(there.status[100] == cca::status_of(cca::ode_status::transient));
  CHECK(there.status.back() == cca::status_of(cca::ode_status::converged));
  const auto back = run(twice, {0, 0}, 1000);
  CHECK(back.status[0] == cca::status_of(cca::ode_status::transient));
  for (std::size_t k = 0; k < 1000; ++k) CHECK(std::abs(back.velocity[k] + there.velocity[k]) < 3e-3);
}

TEST_CASE("a target that jumps during the movement makes no jump of the velocity, and nothing allocates") {
  reach arm;
  const std::size_t before = laws::allocations();
  double last = 0, jump = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto [x, v, s] = arm.process(given<target>({k < 400 ? 0.8 : -0.5, 0.0}), {}, {}, at(k));
    jump = std::max(jump, std::abs(v[hip{}] - last));
    last = v[hip{}];
  }
  const std::size_t after = laws::allocations();
  CHECK(before == after);
  CHECK(jump < 0.2);
}
