// No movement uses a start that has not arrived or a sample that is not finite. It waits, publishes nothing
// meanwhile, and continues where it was.
#include <limits>
#include <utility>

#include <cca/motor/dmp_discrete.hpp>
#include <cca/motor/dmp_pose.hpp>
#include <cca/motor/dmp_rhythmic.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/gait_network.hpp>
#include <cca/motor/hopf.hpp>
#include <cca/motor/vite.hpp>

#include "rig.hpp"

using namespace motor_test;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
using number = Eigen::Matrix<double, 1, 1>;
using two = Eigen::Vector2d;
const two somewhere(0.4, -0.3), bad(0.1, no_number);

// A wired port without a sample.
template <class Port>
Port waiting() {
  Port port;
  port.set_wired();
  return port;
}

// Each is a movement of two axes to a goal; `to(goal, start, k)` returns its position, if it publishes one.
struct reach {
  cca::vite<leg> it;
  auto to(const two& goal, const cca::optional_in<"start", leg>& start, int k) {
    return std::get<0>(it.process(given<cca::in<"target", leg>>(goal), start, {}, at(k)));
  }
};
struct primitive {
  cca::dmp_discrete<leg, 5> it;
  auto to(const two& goal, const cca::optional_in<"start", leg>& start, int k) {
    return std::get<0>(it.process(given<cca::in<"goal", leg>>(goal), start, {}, {}, at(k)));
  }
};
struct rhythm {
  cca::dmp_rhythmic<leg, stride, 5> it;
  auto to(const two& goal, const cca::optional_in<"start", leg>& start, int k) {
    return std::get<0>(it.process(given<cca::in<"phase", cca::over<cca::phase, stride>>>(number(1e-3 * k)),
                                  given<cca::in<"amplitude", cca::over<cca::amplitude, stride>>>(number(0.0)),
                                  {}, given<cca::in<"goal", leg>>(goal), start, at(k)));
  }
};
struct learned_rhythm {
  cca::dmp_rhythmic_module<leg, stride, 5> it;
  auto to(const two& goal, const cca::optional_in<"start", leg>& start, int k) {
    return std::get<0>(it.process(given<cca::in<"phase", cca::over<cca::phase, stride>>>(number(1e-3 * k)),
                                  given<cca::in<"amplitude", cca::over<cca::amplitude, stride>>>(number(0.0)),
                                  {}, given<cca::in<"reference", leg>>(goal), start, {}, {}, at(k)));
  }
};

struct somewhere_frame {};
struct hand {};
struct hand_pose : cca::space<cca::pose<somewhere_frame>, cca::axes<cca::x, cca::y, cca::z>> {};
hand_pose::vector_type upright(double x) {
  hand_pose::vector_type v;
  v << x, 0, 0, 0, 0, 0, 1;
  return v;
}

}  // namespace

TEST_CASE_TEMPLATE("a movement begins at its start, once that has arrived",
                   Movement,
                   reach,
                   primitive,
                   rhythm,
                   learned_rhythm) {
  using start = cca::optional_in<"start", leg>;
  Movement m;
  for (int k = 0; k < 20; ++k) CHECK(!m.to({1, 1}, waiting<start>(), k));
  for (int k = 20; k < 25; ++k) CHECK(!m.to({1, 1}, wired<start>(bad), k));
  const auto first = m.to({1, 1}, wired<start>(somewhere), 25);
  REQUIRE(first);
  CHECK((first.vector() - somewhere).norm() < 0.02);
  // Later samples of the start have no effect.
  const auto next = m.to({1, 1}, wired<start>(bad), 26);
  REQUIRE(next);
  CHECK((next.vector() - somewhere).norm() < 0.05);
}

TEST_CASE_TEMPLATE("a goal that is not finite is not followed and leaves no trace",
                   Movement,
                   reach,
                   primitive,
                   rhythm,
                   learned_rhythm) {
  Movement m;
  const auto from = wired<cca::optional_in<"start", leg>>(somewhere);
  for (int k = 0; k < 100; ++k) REQUIRE(m.to({1, 1}, from, k));
  const two before = m.to({1, 1}, from, 100).vector();
  for (int k = 101; k < 120; ++k) CHECK(!m.to(k % 2 ? bad : two(inf, 0), from, k));
  CHECK((m.to({1, 1}, from, 120).vector() - before).norm() < 0.02);
  for (int k = 121; k < 4000; ++k) REQUIRE(m.to({1, 1}, from, k));
  CHECK((m.to({1, 1}, from, 4000).vector() - two(1, 1)).norm() < 1e-2);
}

TEST_CASE("without a start a rhythmic movement begins at its goal, once that has arrived") {
  rhythm m;
  const auto nowhere = cca::in<"goal", leg>{};
  const auto go = [&](const cca::in<"goal", leg>& goal, double phase, int k) {
    return std::get<0>(m.it.process(
        given<cca::in<"phase", cca::over<cca::phase, stride>>>(number(phase)),
        given<cca::in<"amplitude", cca::over<cca::amplitude, stride>>>(number(0.0)), {}, goal, {}, at(k)));
  };
  CHECK(!go(nowhere, 0, 0));
  CHECK((go(given<cca::in<"goal", leg>>(somewhere), 0, 1).vector() - somewhere).norm() < 1e-12);
  CHECK(!go(given<cca::in<"goal", leg>>(somewhere), no_number, 2));  // a phase that is not finite
  CHECK((go(given<cca::in<"goal", leg>>(somewhere), 0, 3).vector() - somewhere).norm() < 1e-12);
}

TEST_CASE("a duration that is not finite changes nothing") {
  primitive plain, disturbed;
  using duration = cca::optional_in<"duration", cca::movement_duration>;
  for (int k = 0; k < 500; ++k) {
    const auto step = [&](primitive& m, double seconds) {
      return std::get<0>(m.it.process(given<cca::in<"goal", leg>>(two(1, 1)), {},
                                      wired<duration>(number(seconds)), {}, at(k)));
    };
    if (k == 250) CHECK(!step(disturbed, no_number));
    else CHECK(step(plain, 1).vector() == step(disturbed, 1).vector());
  }
}

TEST_CASE("a pose waits too, and keeps a quaternion of unit length") {
  cca::dmp_pose<hand_pose, hand, 5> m;
  using start = cca::optional_in<"start", hand_pose>;
  const auto go = [&](const hand_pose::vector_type& goal, const start& from, int k) {
    return std::get<0>(m.process(given<cca::in<"goal", hand_pose>>(goal), from, {}, {}, at(k)));
  };
  CHECK(!go(upright(1), waiting<start>(), 0));
  CHECK((go(upright(1), wired<start>(upright(0.5)), 1).vector() - upright(0.5)).norm() < 1e-3);
  CHECK(!go(upright(no_number), wired<start>(upright(0.5)), 2));
  for (int k = 3; k < 3000; ++k) REQUIRE(go(upright(1), wired<start>(upright(0.5)), k));
  CHECK((go(upright(1), wired<start>(upright(0.5)), 3000).vector() - upright(1)).norm() < 1e-2);
}

TEST_CASE("oscillators keep their state while an input is not finite") {
  cca::hopf<stride> one_leg;
  const auto hopf = [&](double amplitude, int k) {
    const auto all = one_leg.process(
        given<cca::in<"amplitude", cca::over<cca::amplitude, stride>>>(number(amplitude)), {}, at(k));
    return two(std::get<0>(all)[stride{}], std::get<1>(all)[stride{}]);
  };
  for (int k = 0; k < 1000; ++k) hopf(1, k);
  const two before = hopf(1, 1000);
  CHECK(hopf(no_number, 1001) == before);
  CHECK(hopf(inf, 1002) == before);
  for (int k = 1003; k < 1100; ++k) CHECK(hopf(1, k)[1] == doctest::Approx(1).epsilon(1e-3));

  struct lf : cca::dimension<"lf"> {};
  struct rf : cca::dimension<"rf"> {};
  struct lh : cca::dimension<"lh"> {};
  struct rh : cca::dimension<"rh"> {};
  using network = cca::gait_network<lf, rf, lh, rh>;
  network four;
  const auto legs = [&](const Eigen::Vector4d& amplitudes, int k) {
    return std::get<0>(four.process(given<cca::in<"amplitude", network::legs<cca::amplitude>>>(amplitudes),
                                    {}, {}, at(k)))
        .vector()
        .eval();
  };
  for (int k = 0; k < 100; ++k) legs(Eigen::Vector4d::Ones(), k);
  const Eigen::Vector4d phases = legs(Eigen::Vector4d::Ones(), 100);
  CHECK(legs(Eigen::Vector4d(1, no_number, 1, 1), 101) == phases);
  CHECK((legs(Eigen::Vector4d::Ones(), 102) - phases).norm() < 0.05);
}
