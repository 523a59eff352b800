// Motions that are no movement primitives, as adaptive modules: Gaussian mixture regression and a reservoir.
#include <vector>

#include <cca/motor/modules/gmr_module.hpp>
#include <cca/motor/modules/rcpg_module.hpp>

#include "../../laws/module_laws.hpp"
#include "../../laws/request_laws.hpp"
#include "../motor/rig.hpp"

using namespace motor_test;

namespace {

using laws::shown;
using v2 = Eigen::Vector2d;

struct ankle : cca::dimension<"ankle"> {};
struct other_leg : cca::space<cca::joint_angles, cca::axes<hip, ankle>> {};
struct lesson_time : cca::space<cca::number, cca::axes<cca::x>> {};
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
const v2 centre(0.1, -0.8);

template <class Port>
Port showing(shown what, const v2& y, int k) {
  if (what == shown::nothing) return {};
  return wired<Port>(what == shown::demonstration ? y : v2(y[0], k % 2 ? no_number : cca::infinity));
}

// Over a time of 2 s, relative to the reference.
struct gmr_case {
  using module = cca::gmr_module<lesson_time, leg, 12>;
  using other_size = cca::gmr_module<lesson_time, leg, 11>;
  using other_space = cca::gmr_module<lesson_time, other_leg, 12>;
  static constexpr int lesson = 2000;
  static constexpr double bound = 0.03;  // rad; the movement is 0.6 rad wide
  static v2 truth(double t) { return centre + v2(0.3 * std::sin(3 * t), 0.2 * std::cos(2 * t)); }
  template <class Module>
  static auto process(Module& m,
                      int k,
                      const v2& reference,
                      shown what,
                      cca::learning_call call = cca::learning_call::nothing) {
    using space = typename Module::demonstrated;
    return m.process(given<cca::in<"input", lesson_time>>(one<lesson_time>(1e-3 * k)),
                     given<cca::in<"reference", space>>(reference), {},
                     showing<cca::optional_in<"demonstration", space>>(what, truth(1e-3 * k), k),
                     laws::request(call), at(k));
  }
  template <class Module>
  static laws::module_firing fire(Module& m, int k, shown what, cca::learning_call call) {
    const auto [command, velocity, spread, ode, module] = process(m, k, centre, what, call);
    return laws::firing_of(command.vector()[0], ode[cca::ode_axis{}], module);
  }
  template <class Module>
  static double worst(Module& m) {
    m.on_start();
    double most = 0;
    for (int k = 0; k < lesson; ++k) {
      const v2 y = std::get<0>(process(m, k, centre, shown::nothing)).vector();
      if (k > 300) most = std::max(most, (y - truth(1e-3 * k)).cwiseAbs().maxCoeff());
    }
    return most;
  }
  static void change(auto& p) { p.stiffness = 30; }
  static void hasten(module& m) { m.p.settings.iterations = 5; }
};

// Two axes with harmonics, period 50 firings.
struct rcpg_case {
  using module = cca::rcpg_module<leg, 100>;
  using other_size = cca::rcpg_module<leg, 99>;
  using other_space = cca::rcpg_module<other_leg, 100>;
  static constexpr int lesson = 1100;
  static constexpr double bound = 0.05;  // rad; the pattern is 1.2 rad wide
  static v2 truth(double k) {
    const double f = 2 * cca::pi * k / 50;
    return centre +
           v2(0.5 * std::sin(f) + 0.2 * std::sin(2 * f + 1), 0.4 * std::cos(f) + 0.15 * std::cos(3 * f));
  }
  template <class Module>
  static auto process(Module& m,
                      int k,
                      const v2& reference,
                      shown what,
                      cca::learning_call call = cca::learning_call::nothing) {
    using space = typename Module::demonstrated;
    return m.process(given<cca::in<"reference", space>>(reference),
                     showing<cca::optional_in<"demonstration", space>>(what, truth(k), k),
                     laws::request(call), at(k));
  }
  template <class Module>
  static laws::module_firing fire(Module& m, int k, shown what, cca::learning_call call) {
    const auto [command, ode, module] = process(m, k, centre, what, call);
    return laws::firing_of(command.vector()[0], ode[cca::ode_axis{}], module);
  }
  // From rest it falls into the pattern: the error of one period, at the best phase.
  template <class Module>
  static double worst(Module& m) {
    m.on_start();
    std::vector<v2> seen;
    for (int k = 0; k < 3000; ++k)
      seen.push_back(std::get<0>(process(m, k, centre, shown::nothing)).vector());
    double best = 1e9;
    for (int shift = 0; shift < 500; ++shift) {
      double most = 0;
      for (int k = 0; k < 50; ++k)
        most = std::max(most, (seen[static_cast<std::size_t>(2900 + k)] - truth(k + shift / 10.0)).norm());
      best = std::min(best, most);
    }
    return best;
  }
  static void change(auto& p) { p.seed = 2; }
};

}  // namespace

TEST_CASE("Gaussian mixture regression as a module obeys the laws of an adaptive module") {
  laws::adaptive_module<gmr_case>();
  laws::requests<laws::module_student<gmr_case>>();
}
TEST_CASE("a reservoir as a module obeys the laws of an adaptive module") {
  laws::adaptive_module<rcpg_case>();
  laws::requests<laws::module_student<rcpg_case>>();
}

TEST_CASE("what is learned moves with its reference") {
  const auto regression = laws::taught<gmr_case>();
  const auto reservoir = laws::taught<rcpg_case>();
  const auto moved_by = [](auto& m, auto process) {
    auto other = m;
    m.on_start();
    other.on_start();
    double off = 0;
    for (int k = 0; k < 500; ++k) {
      const v2 a = std::get<0>(process(m, k, centre)).vector(),
               b = std::get<0>(process(other, k, centre + v2(0.3, 0.2))).vector();
      off = std::max(off, (b - a - v2(0.3, 0.2)).norm());
    }
    return off;
  };
  CHECK(moved_by(*regression, [](auto& m, int k, const v2& at_place) {
          return gmr_case::process(m, k, at_place, shown::nothing);
        }) < 1e-9);
  CHECK(moved_by(*reservoir, [](auto& m, int k, const v2& at_place) {
          return rcpg_case::process(m, k, at_place, shown::nothing);
        }) < 1e-9);
}

TEST_CASE("the point on springs follows its closed form, and its wanted attractor undoes it") {
  using ode = cca::attractor_ode<2>;
  const ode::parameters with{25};
  cca::ode_solver<ode> solver;
  const v2 goal(1, -2);
  for (int k = 1; k <= 400; ++k) {
    const ode::state before = solver.get();
    solver.advance(goal, with, 1e-3);
    const double lt = 12.5 * 1e-3 * k, left = (1 + lt) * std::exp(-lt);
    CHECK((solver.get().head<2>() - (1 - left) * goal).norm() < 1e-9);
    const ode::state rate = ode::derivative(before, goal, with);
    CHECK((ode::wanted_attractor(before.head<2>(), rate.head<2>(), rate.tail<2>(), with) - goal).norm() <
          1e-12);
  }
}

TEST_CASE("the spread of a learned motion says how much the demonstrations differed") {
  auto m = laws::started_module<gmr_case::module>();
  m->learning.collect();
  for (int pass = 0; pass < 2; ++pass) {  // the two differ only in the second half
    m->on_start();
    for (int k = 0; k < 1000; ++k) {
      const double t = 2e-3 * k, apart = t < 1 ? 0 : (pass ? 0.1 : -0.1) * (t - 1);
      (void)m->process(given<cca::in<"input", lesson_time>>(one<lesson_time>(t)),
                       given<cca::in<"reference", leg>>(centre), {},
                       wired<cca::optional_in<"demonstration", leg>>(gmr_case::truth(t) + v2(apart, apart)),
                       {}, cca::beat(k, 2'000'000, 1));
    }
  }
  m->learning.hand_over(m->learning.begin_batch(m->p.settings)());
  const auto spread = [&](int k) {
    return std::get<2>(gmr_case::process(*m, k, centre, shown::nothing)).vector()[0];
  };
  CHECK(spread(1900) > 0.06);
  CHECK(spread(1900) < 0.15);
  CHECK(spread(300) < 0.03);
}

TEST_CASE("a reservoir hears the demonstration only while its learner listens") {
  auto m = laws::started_module<rcpg_case::module>();
  const auto deaf = laws::started_module<rcpg_case::module>();
  using enum cca::learning_call;
  for (int k = 0; k < 50; ++k) {  // not asked to learn
    const v2 y = std::get<0>(rcpg_case::process(*m, k, centre, shown::demonstration)).vector();
    CHECK(y == std::get<0>(rcpg_case::process(*deaf, k, centre, shown::nothing)).vector());
  }
  for (int k = 0; k < 150; ++k) {
    const v2 y =
        std::get<0>(rcpg_case::process(*m, k, centre, shown::demonstration, k ? nothing : learn)).vector();
    CHECK(y == rcpg_case::truth(k));
    CHECK((m->learning.get().function.weights.norm() > 0) == (k >= 100));  // after the washout
  }
  // Online it also learns to go on by itself.
  for (int k = 150; k < 1500; ++k) (void)rcpg_case::process(*m, k, centre, shown::demonstration);
  m->learning.rest();
  double most = 0;
  for (int k = 1500; k < 2000; ++k)
    most = std::max(
        most, (std::get<0>(rcpg_case::process(*m, k, centre, shown::nothing)).vector() - rcpg_case::truth(k))
                  .norm());
  CHECK(most < 0.05);
}
