// The Hopf oscillator against its closed form; rest at negative amplitude and waking up.
#include <cca/motor/hopf.hpp>

#include "rig.hpp"

using namespace motor_test;

namespace {

using oscillator = cca::hopf<stride>;
using amplitude = cca::in<"amplitude", cca::over<cca::amplitude, stride>>;
using frequency = cca::optional_in<"frequency", cca::over<cca::frequency, stride>>;

struct hopf_case {
  using ode = cca::hopf_ode;
  static constexpr double rate = 60;
  static ode::parameters parameters() { return {8}; }
  static ode::state state(laws::ode_source& random) { return random.vector<ode::state>(-1.2, 1.2); }
  static ode::input input(laws::ode_source& random) { return {random(-1, 1.2), random(0, 3)}; }
  static auto equilibrium(laws::ode_source& random) { return std::pair(ode::state(0, 0), input(random)); }
};

// The radius at time t, from r0.
double radius(double r0, double a, double c, double t) {
  const double m = a * std::abs(a);
  return std::sqrt(m / (1 + (m / (r0 * r0) - 1) * std::exp(-2 * c * m * t)));
}

struct wish {
  auto process(cca::beat now) -> cca::out<"amplitude", cca::over<cca::amplitude, stride>> {
    return now.index() < 3000 ? 1.0 : -1.0;
  }
};
struct ear {
  void process(cca::in<"amplitude", cca::over<cca::amplitude, stride>> a) { heard = a[stride{}]; }
  double heard = 0;
};
struct stop_and_go : cca::graph<cca::rate<1000>,
                                cca::node<"wish", wish>,
                                cca::node<"cpg", oscillator, cca::timed<1>>,
                                cca::node<"ear", ear>,
                                cca::wire<"wish.amplitude", "cpg.amplitude">,
                                cca::wire<"cpg.amplitude", "ear.amplitude">> {};

}  // namespace

TEST_CASE("the Hopf oscillator obeys the laws of an ode") { laws::ode<hopf_case>(); }

TEST_CASE(
    "the radius of the Hopf oscillator follows the closed form, inwards, outwards and at negative "
    "amplitude") {
  for (const auto& [r0, a] : {std::pair(0.1, 1.0), std::pair(1.7, 1.0), std::pair(0.3, 0.6),
                              std::pair(1.0, -1.0), std::pair(0.8, -0.4)})
    for (const double t : {0.05, 0.2, 0.6}) {
      const auto x = laws::after<hopf_case, cca::rk4>({r0, 0}, {a, 1.3}, t, 1000);
      CHECK(x.norm() == doctest::Approx(radius(r0, a, 8, t)).epsilon(1e-9));
      CHECK(cca::wrap_signed(std::atan2(x[1], x[0]) - 2 * cca::pi * 1.3 * t) ==
            doctest::Approx(0).epsilon(1e-9));
    }
}

TEST_CASE("the oscillator runs at its frequency, on a circle of the wanted amplitude") {
  oscillator cpg;
  const double wanted = 0.7;
  double turned = 0, before = 0, radius_now = 0;
  for (int k = 0; k < 5000; ++k) {
    const auto [phase, size, status] = cpg.process(given<amplitude>(one<leg>(wanted).head<1>()),
                                                   wired<frequency>(one<leg>(2.5).head<1>()), at(k));
    if (k >= 3000) turned += cca::wrap_signed(phase[stride{}] - before);
    before = phase[stride{}];
    radius_now = size[stride{}];
    CHECK(std::abs(before) <= cca::pi);
    if (k > 3000) CHECK(status[cca::ode_axis{}] == cca::status_of(cca::ode_status::transient));
  }
  CHECK(turned == doctest::Approx(2 * cca::pi * 2.5 * 2.0).epsilon(1e-6));
  CHECK(radius_now == doctest::Approx(wanted).epsilon(1e-6));
}

TEST_CASE(
    "an unwired frequency comes from the parameter; with Euler's method the circle is wider by the predicted "
    "amount") {
  oscillator cpg;
  cpg.p.frequency = 2.0;
  cca::hopf<stride, cca::explicit_euler> rough;
  rough.p.frequency = 2.0;
  double turned = 0, before = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto phase = std::get<0>(cpg.process(given<amplitude>(one<leg>(1).head<1>()), {}, at(k)))[stride{}];
    (void)rough.process(given<amplitude>(one<leg>(1).head<1>()), {}, at(k));
    if (k >= 3000) turned += cca::wrap_signed(phase - before);
    before = phase;
  }
  CHECK(turned == doctest::Approx(2 * cca::pi * 2).epsilon(1e-6));
  // Euler's circle is wider: the growth balances the outward step, c (A^2 - r^2) = -w^2 dt / 2.
  const double r =
      std::get<1>(rough.process(given<amplitude>(one<leg>(1).head<1>()), {}, at(4000)))[stride{}];
  CHECK(r * r == doctest::Approx(1 + 16 * cca::pi * cca::pi * 1e-3 / 2 / 10).epsilon(1e-3));
}

TEST_CASE("a negative amplitude brings the oscillator to rest, a positive one wakes it up") {
  oscillator cpg;
  const auto run = [&](double wanted, int beats) {
    auto result = cpg.process(given<amplitude>(one<leg>(wanted).head<1>()), {}, at(0));
    for (int k = 1; k < beats; ++k)
      result = cpg.process(given<amplitude>(one<leg>(wanted).head<1>()), {}, at(k));
    return std::pair(std::get<1>(result)[stride{}], std::get<2>(result)[cca::ode_axis{}]);
  };
  CHECK(run(1, 3000).first == doctest::Approx(1).epsilon(1e-6));
  const auto [radius_at_rest, status] = run(-1, 1500);
  CHECK(radius_at_rest == cpg.p.ember);
  CHECK(status == cca::status_of(cca::ode_status::converged));
  const auto phase_now = [&](oscillator copy) {
    return std::get<0>(copy.process(given<amplitude>(one<leg>(-1).head<1>()), {}, at(0)))[stride{}];
  };
  const double before = phase_now(cpg);
  (void)run(-1, 1);
  CHECK(cca::wrap_signed(phase_now(cpg) - before) ==
        doctest::Approx(2 * cca::pi * 1e-3).epsilon(1e-6));  // at rest it still has a phase
  // Closed form: from the radius e it reaches half the amplitude after ln((1/e^2 - 1) / 3) / (2 c) = 0.64 s.
  const double half = std::log((1 / (1e-3 * 1e-3) - 1) / 3) / 20;
  CHECK(run(1, static_cast<int>(half * 1000)).first == doctest::Approx(0.5).epsilon(0.01));
  CHECK(run(1, 2000).first == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("the Hopf oscillator in a controller stops on demand, without allocation") {
  cca::controller<stop_and_go> c;
  c.load();
  c.start();
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 3000; ++k) c.step();
  const double running = c.get<"ear">().heard;
  for (int k = 0; k < 3000; ++k) c.step();
  CHECK(laws::allocations() == before);
  CHECK(running == doctest::Approx(1).epsilon(1e-6));
  CHECK(c.get<"ear">().heard == 1e-3);
}
