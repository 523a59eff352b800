// A start resets a component: after `on_start` it behaves like a new one, bit for bit, whatever it did
// before.
#include <vector>

#include <cca/motor/dmp_discrete.hpp>
#include <cca/motor/dmp_pose.hpp>
#include <cca/motor/dmp_rhythmic.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/gait_network.hpp>
#include <cca/motor/hmm_motion.hpp>
#include <cca/motor/hopf.hpp>
#include <cca/motor/pid.hpp>
#include <cca/motor/rcpg.hpp>
#include <cca/motor/vite.hpp>

#include "rig.hpp"

using namespace motor_test;

namespace {

using one_number = Eigen::Matrix<double, 1, 1>;
template <class Axis>
using amplitude_of = cca::over<cca::amplitude, Axis>;
template <class Axis>
using phase_of = cca::over<cca::phase, Axis>;

// All numbers of all outputs.
template <class Result>
std::vector<double> numbers(const Result& result) {
  std::vector<double> all;
  const auto add = [&](const auto& port) {
    all.insert(all.end(), port.vector().begin(), port.vector().end());
  };
  if constexpr (requires { result.vector(); }) add(result);
  else std::apply([&](const auto&... ports) { (add(ports), ...); }, result);
  return all;
}

// A component that has come to rest reports that until the next start, which also resets its status.
template <class Component>
Component lasting(Component c) {
  c.p.settling.above = 1e9;
  return c;
}

// `step(component, k)` steps it; the values of k before and after the start differ.
template <class Component, class Step>
void check_reset(const Component& made, Step step) {
  for (const int before : {1, 37, 400, 6000}) {
    Component fresh = made, used = made;
    for (int k = 0; k < before; ++k) (void)step(used, 10'000 + k);
    used.on_start();
    for (int k = 0; k < 300; ++k) REQUIRE_EQ(numbers(step(used, k)), numbers(step(fresh, k)));
  }
}

struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct hand_in_trunk : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct lf : cca::dimension<"lf"> {};
struct rf : cca::dimension<"rf"> {};
struct lh : cca::dimension<"lh"> {};
struct rh : cca::dimension<"rh"> {};

Eigen::Vector2d place(int k) { return k < 10'000 ? Eigen::Vector2d(0.4, -0.3) : Eigen::Vector2d(-0.7, 0.2); }

}  // namespace

TEST_CASE("a start resets VITE") {
  check_reset(lasting(cca::vite<leg>{}), [](auto& c, int k) {
    return c.process(given<cca::in<"target", leg>>(place(k)), {}, {}, at(k));
  });
}

TEST_CASE("a start resets the discrete movement primitive") {
  cca::dmp_discrete<leg, 5> c;
  c.p.weights << 10, -20, 30, 5, 8, 4, 3, 2, 1, 50;
  check_reset(lasting(c), [](auto& one, int k) {
    return one.process(given<cca::in<"goal", leg>>(place(k)),
                       wired<cca::optional_in<"start", leg>>(0.5 * place(k)), {}, {}, at(k));
  });
}

TEST_CASE("a start resets the movement primitive of a pose") {
  cca::dmp_pose<hand_in_trunk, hand, 3> c;
  c.p.weights.setConstant(30);
  check_reset(lasting(c), [](auto& one, int k) {
    Eigen::Matrix<double, 7, 1> to;
    to << place(k), 0.1, cca::rotation::exp(Eigen::Vector3d(0.3, k < 10'000 ? 0.5 : -0.5, 0));
    return one.process(given<cca::in<"goal", hand_in_trunk>>(to), {}, {}, {}, at(k));
  });
}

TEST_CASE("a start resets rhythmic movement primitives, which keep what they have learned") {
  const auto step = [](auto& one, int k) {
    return one.process(
        given<cca::in<"phase", phase_of<stride>>>(one_number(0.01 * k)),
        given<cca::in<"amplitude", amplitude_of<stride>>>(one_number(k % 7000 < 300 ? 1.0 : 0.0)), {},
        given<cca::in<"goal", leg>>(place(k)), {}, at(k));
  };
  cca::dmp_rhythmic<leg, stride, 5> plain;
  plain.p.weights << 10, -20, 30, 5, 8, 4, 3, 2, 1, 50;
  check_reset(lasting(plain), step);
  using module = cca::dmp_rhythmic_module<leg, stride, 5>;
  module learned;
  for (int i = 0; i < 100; ++i) {
    auto known = learned.learning.get();
    module::learner::step(known, {0.07 * i, 1.0}, {std::sin(i), 2}, {});
    learned.learning.hand_over(known);
  }
  check_reset(lasting(learned), [](auto& one, int k) {
    return one.process(given<cca::in<"phase", phase_of<stride>>>(one_number(0.01 * k)),
                       given<cca::in<"amplitude", amplitude_of<stride>>>(one_number(k < 10'000 ? 1.0 : 0.0)),
                       {}, given<cca::in<"reference", leg>>(place(k)), {}, {}, {}, at(k));
  });
}

TEST_CASE("a start resets the gait network: at rest, in the gait") {
  using network = cca::gait_network<lf, rf, lh, rh>;
  check_reset(lasting(network{}), [](auto& one, int k) {
    return one.process(
        given<cca::in<"amplitude", network::legs<cca::amplitude>>>(Eigen::Vector4d::Constant(0.8)), {},
        wired<cca::optional_in<"gait", cca::gait_choice>>(one_number(k < 10'000 ? 2.0 : 0.0)), at(k));
  });
}

TEST_CASE("a start resets the Hopf oscillator: to the radius `ember`") {
  check_reset(lasting(cca::hopf<stride>{}), [](auto& one, int k) {
    return one.process(given<cca::in<"amplitude", amplitude_of<stride>>>(one_number(k < 12'000 ? 1.0 : -1.0)),
                       {}, at(k));
  });
}

TEST_CASE("a start resets a reservoir pattern generator: the same network, at rest") {
  cca::rcpg<plane, 20> c;
  c.p.readout.setConstant(0.1);
  check_reset(c, [](auto& one, int k) {
    return one.process(wired<cca::optional_in<"teacher", plane>>(place(k), k >= 10'000));
  });
}

TEST_CASE("a start resets PID") {
  cca::pid<plane, plane> c;
  c.p.integral.setConstant(3), c.p.derivative.setConstant(0.2);
  check_reset(c, [](auto& one, int k) {
    const Eigen::Vector2d wanted =
        k == 0 ? Eigen::Vector2d::Constant(std::nan(""))
               : place(k);  // the first sample is ignored: the earlier state would show
    return one.process(given<cca::in<"reference", plane>>(wanted),
                       given<cca::in<"measured", plane>>(Eigen::Vector2d(0.01 * k, 1)), {}, {}, at(k));
  });
}

TEST_CASE("a start resets the hidden Markov model") {
  cca::hmm_motion<plane, 3> c;
  c.p.mixture.means.row(0) << -1, 0, 1;
  c.p.mixture.means.row(2) << 1, -2, 3;  // so the velocity shows which states are likely
  c.p.mixture.priors << 0.5, 0.3, 0.2;
  c.p.transitions << 0.9, 0.1, 0, 0, 0.9, 0.1, 0.1, 0, 0.9;
  check_reset(c, [](auto& one, int k) {
    const double x = k < 3 ? std::nan("") : k < 10'000 ? -1 + 0.007 * k : 1;  // NaN at first
    return one.process(given<cca::in<"position", plane>>(Eigen::Vector2d(x, 0)));
  });
}
