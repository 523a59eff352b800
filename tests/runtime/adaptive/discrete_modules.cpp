// Discrete movement primitives as adaptive modules: they learn a movement and repeat it to other goals.
#include <vector>

#include <cca/motor/modules/dmp_discrete_module.hpp>
#include <cca/motor/modules/dmp_pose_module.hpp>

#include "../../laws/module_laws.hpp"
#include "../../laws/request_laws.hpp"
#include "../motor/rig.hpp"

using namespace motor_test;

namespace {

using laws::shown;

struct trunk : cca::frame<"trunk"> {};
struct base : cca::frame<"base"> {};
struct hand : cca::frame<"hand"> {};
struct hand_in_trunk : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct hand_in_base : cca::space<cca::pose<base>, cca::axes<cca::x, cca::y, cca::z>> {};
struct ankle : cca::dimension<"ankle"> {};
struct other_leg : cca::space<cca::joint_angles, cca::axes<hip, ankle>> {};
using v2 = Eigen::Vector2d;
using v3 = Eigen::Vector3d;
using v4 = Eigen::Vector4d;
using vector7 = Eigen::Matrix<double, 7, 1>;

// Minimum jerk from 0 to 1 in 1 s.
double rising(double t) {
  const double s = std::min(t, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}
// There and back.
double bump(double t) {
  const double s = std::min(t, 1.0);
  return 64 * std::pow(s * (1 - s), 3);
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// The same for both: a movement of 1 s at 1 kHz, with `truth(t)`.
template <class Case>
struct movement_case {
  static constexpr int lesson = 1000;
  static constexpr double bound = 0.01;

  template <class Module>
  static auto process(Module& m,
                      int k,
                      const typename Module::demonstrated::vector_type& goal,
                      shown what,
                      cca::learning_call call = cca::learning_call::nothing,
                      bool again = false) {
    using space = typename Case::space;
    cca::optional_in<"demonstration", space> showing;
    if (what != shown::nothing) {
      auto y = Case::truth(1e-3 * k);
      if (what == shown::broken) y[1] = k % 2 ? no_number : cca::infinity;
      showing = wired<cca::optional_in<"demonstration", space>>(y);
    }
    return m.process(
        given<cca::in<"reference", space>>(goal), wired<cca::optional_in<"start", space>>(Case::truth(0)), {},
        wired<cca::optional_in<"restart", cca::restart_signal>>(one<cca::restart_signal>(0), again), showing,
        laws::request(call), at(k));
  }
  template <class Module>
  static laws::module_firing fire(Module& m, int k, shown what, cca::learning_call call) {
    const auto [command, velocity, progress, ode, module] = process(m, k, Case::truth(1), what, call);
    return laws::firing_of(command.vector()[0], ode[cca::ode_axis{}], module);
  }
  template <class Module>
  static double worst(Module& m) {
    m.on_start();
    double most = 0;
    for (int k = 0; k < 1500; ++k) {
      const auto y = std::get<0>(process(m, k, Case::truth(1), shown::nothing)).vector();
      most = std::max(most, Case::apart(y, Case::truth(1e-3 * (k + 1))));
    }
    return most;
  }
  static void change(auto& p) { p.scaled = !p.scaled; }
};

// The second axis ends where it began.
struct leg_case : movement_case<leg_case> {
  using space = leg;
  using vector = v2;
  using module = cca::dmp_discrete_module<leg, 20>;
  using other_size = cca::dmp_discrete_module<leg, 21>;
  using other_space = cca::dmp_discrete_module<other_leg, 20>;
  static v2 truth(double t) { return {0.1 + 0.5 * rising(t), -0.3 + 0.2 * bump(t)}; }
  static double apart(const v2& a, const v2& b) { return (a - b).cwiseAbs().maxCoeff(); }
};

// In m and rad. The sign of the quaternion changes all the time.
struct hand_case : movement_case<hand_case> {
  using space = hand_in_trunk;
  using vector = vector7;
  using module = cca::dmp_pose_module<hand_in_trunk, hand, 20>;
  using other_size = cca::dmp_pose_module<hand_in_trunk, hand, 21>;
  using other_space = cca::dmp_pose_module<hand_in_base, hand, 20>;
  static vector7 truth(double t) {
    vector7 y;
    y << v3(0.4 + 0.2 * rising(t), 0.1 * bump(t), 0.2 - 0.15 * rising(t)),
        cca::rotation::product(cca::rotation::exp(v3(0, 0.4 * bump(t), 1.2 * rising(t))),
                               cca::rotation::about(v3(1, 0, 0), 0.5));
    if (static_cast<int>(1000 * t) % 2) y.tail<4>() *= -1;
    return y;
  }
  static double apart(const vector7& a, const vector7& b) {
    const v4 off = cca::rotation::product(v4(a.tail<4>()), cca::rotation::inverse(v4(b.tail<4>())));
    return std::max((a - b).head<3>().norm(), cca::rotation::angle(off));
  }
};

template <class Case>
std::vector<typename Case::vector> recorded(int samples, double seconds) {
  std::vector<typename Case::vector> all;
  for (int i = 0; i < samples; ++i) all.push_back(Case::truth(i * seconds));
  return all;
}

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

// A whole movement, recorded at 200 Hz, is learned between two beats and repeated to another goal.
template <class Case>
void repeats_a_recording(bool scaled, const typename Case::vector& other_goal, double bound) {
  auto m = laws::started_module<typename Case::module>();
  auto& module = *m;
  module.p.scaled = scaled;
  const auto movement = recorded<Case>(201, 5e-3);
  // [recorded]
  module.learning.collect();
  module.demonstrate(movement, 5e-3);  // a sample every 5 ms
  module.learning.hand_over(module.learning.begin_batch(module.p.settings)());
  // [recorded end]
  CHECK(Case::worst(*m) < bound);
  m->on_start();
  double ode = 0;
  typename Case::vector y = Case::truth(0);
  for (int k = 0; k < 3000; ++k) {
    const auto result = Case::process(*m, k, other_goal, shown::nothing);
    y = std::get<0>(result).vector();
    ode = std::get<3>(result).vector()[0];
  }
  CHECK(Case::apart(y, other_goal) < 1e-3);
  CHECK(ode == cca::status_of(cca::ode_status::converged));
}

}  // namespace

TEST_CASE("a discrete movement primitive as a module obeys the laws of an adaptive module") {
  laws::adaptive_module<leg_case>();
  laws::requests<laws::module_student<leg_case>>();
}
TEST_CASE("a movement primitive of a pose as a module obeys the laws of an adaptive module") {
  laws::adaptive_module<hand_case>();
  laws::requests<laws::module_student<hand_case>>();
}

TEST_CASE("a recorded movement is learned whole, and repeated to another goal") {
  repeats_a_recording<leg_case>(false, v2(0.9, 0.1), 0.01);
  vector7 other = hand_case::truth(1);
  other.head<3>() += v3(0.1, -0.05, 0.02);
  other.tail<4>() = cca::rotation::product(cca::rotation::exp(v3(0.3, 0, 0)), v4(other.tail<4>()));
  repeats_a_recording<hand_case>(false, other, 0.01);
  // Scaled, the axis that ends where it began has learned nothing; the other one has.
  auto m = laws::started_module<leg_case::module>();
  m->p.scaled = true;
  m->learning.collect();
  m->demonstrate(recorded<leg_case>(1001, 1e-3), 1e-3);
  m->learning.hand_over(m->learning.begin_batch(m->p.settings)());
  CHECK(m->learning.get().function.weights.row(0).norm() > 1);
  CHECK(m->learning.get().function.weights.row(1).norm() == 0);
  m->on_start();
  double worst = 0;
  for (int k = 0; k < 1500; ++k)  // twice the way: twice the shape
    worst = std::max(
        worst, std::abs(std::get<0>(leg_case::process(*m, k, v2(1.1, -0.3), shown::nothing)).vector()[0] -
                        0.1 - rising(1e-3 * (k + 1))));
  CHECK(worst < 0.02);
}

TEST_CASE("a demonstration of a discrete movement begins again with a restart, and ends with the duration") {
  auto m = laws::started_module<leg_case::module>();
  using enum cca::learning_call;
  for (int k = 0; k < 1000; ++k)
    (void)leg_case::process(*m, k, leg_case::truth(1), shown::demonstration, k == 0 ? collect : nothing);
  CHECK(m->learning.example_count() == 998);
  for (int k = 1000; k < 1500; ++k) (void)leg_case::process(*m, k, leg_case::truth(1), shown::demonstration);
  CHECK(m->learning.example_count() == 1000);  // the next two are the last within the duration
  for (int k = 0; k < 500; ++k)
    (void)leg_case::process(*m, k, leg_case::truth(1), shown::demonstration, nothing, k == 0);
  CHECK(m->learning.example_count() == 1498);
  CHECK(m->learning.examples().back().x[0] == doctest::Approx(std::exp(-5 * 0.498)));
}

TEST_CASE("a demonstration begins with its first finite sample") {
  auto m = laws::started_module<leg_case::module>();
  m->p.scaled = true;
  m->learning.collect();
  for (int k = 0; k < 1000; ++k)
    (void)leg_case::process(*m, k, leg_case::truth(1), k < 3 ? shown::broken : shown::demonstration);
  CHECK(m->learning.example_count() == 995);
  for (const auto& one : m->learning.examples()) CHECK(std::abs(one.y[0]) < 1e3);
}

TEST_CASE("a movement that cannot be learned is refused, with what to do") {
  auto m = laws::started_module<leg_case::module>();
  const auto good = recorded<leg_case>(101, 1e-2);
  const std::string begin = "cca::adaptive_module: demonstrate() is refused: ";
  CHECK(words_of([&] { m->demonstrate(good, 1e-2); }) ==
        begin + "the learner is `idle`; call learning.collect() or learning.learn() first");
  m->learning.collect();
  for (const double between : {0.0, -1.0, no_number})
    CHECK(words_of([&] { m->demonstrate(good, between); }).starts_with(begin + "there are "));
  CHECK(words_of([&] { m->demonstrate(std::span(good).first(2), 1e-2); }) ==
        begin + "the movement has 2 samples; it needs at least 3");
  CHECK(words_of([&] { m->demonstrate(recorded<leg_case>(2001, 1e-3), 1e-3); }) ==
        begin +
            "the movement has 2001 samples, and the module keeps 2000; give the module a larger capacity, "
            "or leave samples out");
  auto broken = good;
  broken[17][1] = no_number;
  CHECK(words_of([&] { m->demonstrate(broken, 1e-2); }) ==
        begin + "sample 17 of the movement is NaN or infinite");
  CHECK(m->learning.example_count() == 0);
  m->demonstrate(good, 1e-2);
  CHECK(m->learning.example_count() == 99);
}

TEST_CASE("a discrete movement is learned online while it is shown") {
  auto m = laws::started_module<leg_case::module>();
  using enum cca::learning_call;
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 1000; ++k)
    (void)leg_case::process(*m, k, leg_case::truth(1), shown::demonstration, k == 0 ? learn : nothing);
  CHECK(laws::allocations() == before);
  CHECK(m->learning.state() == cca::learning::online);
  m->learning.rest();
  CHECK(leg_case::worst(*m) < 0.01);
}
