// All kinds of adaptive components and criteria obey their laws.
#include <array>
#include <future>
#include <string>
#include <string_view>

#include <cca/adaptive/grasping.hpp>
#include <cca/adaptive/reaching_criterion.hpp>
#include <cca/adaptive/recursive_least_squares.hpp>
#include <cca/mapping/mapping.hpp>
#include <cca/motor/generator.hpp>
#include <cca/motor/vite.hpp>

#include "../picture.hpp"
#include "../../laws/adaptive_component_laws.hpp"
#include "../../laws/criterion_laws.hpp"
#include "rig.hpp"

using namespace adaptive_test;

namespace {

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::z>> {};
struct attitude : cca::space<cca::orientation<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct phases : cca::space<cca::phase, cca::axes<hip, knee>> {};

template <class Criterion>
struct of_angles {
  using criterion = Criterion;
  using space = leg;
  static auto at(double error) {
    return std::pair(Eigen::Vector2d(0.3, -0.2), Eigen::Vector2d(0.3 + error / 2, -0.2 - error));
  }
};
struct of_positions {
  using criterion = cca::reaching_goal<paw>;
  using space = paw;
  static auto at(double error) {
    return std::pair(Eigen::Vector2d(0.1, 0.1), Eigen::Vector2d(0.1 + 0.6 * error, 0.1 - 0.8 * error));
  }
};
struct of_orientations {
  using criterion = cca::tracking<attitude>;
  using space = attitude;
  static auto at(double error) {
    return std::pair(Eigen::Vector4d(0, 0, 0, -1),
                     Eigen::Vector4d(0, std::sin(error / 2), 0, std::cos(error / 2)));
  }
};
struct of_phases {
  using criterion = cca::tracking<phases>;
  using space = phases;
  static auto at(double error) {
    return std::pair(Eigen::Vector2d(0.1, 3), Eigen::Vector2d(0.1 - 2 * cca::pi, 3 + error + 2 * cca::pi));
  }
};

struct jaw : cca::dimension<"jaw"> {};
struct aperture : cca::space<cca::joint_angles, cca::axes<jaw>> {};
struct grip : cca::space<cca::joint_torques, cca::axes<jaw>> {};
using one = Eigen::Matrix<double, 1, 1>;
struct of_a_grip {
  using criterion = cca::grasping<aperture, grip>;
  static criterion made() {
    criterion c;
    c.p.hold = 0.01;
    return c;
  }
  static cca::criterion_state feel(criterion& c, laws::circumstance what, std::int64_t k) {
    using in_target = cca::in<"target", aperture>;
    using in_width = cca::in<"feedback", aperture>;
    using in_effort = cca::in<"effort", grip>;
    const double effort = what == laws::circumstance::as_wanted ? 2.0
                          : what == laws::circumstance::not_yet ? 0.1
                                                                : std::nan("");
    const auto [e, s] = what == laws::circumstance::nothing
                            ? c.process(in_target(), in_width(), in_effort(), cca::beat(k, 1'000'000, 1))
                            : c.process(in_target(one(0.0), k, true), in_width(one(0.05), k, true),
                                        in_effort(one(effort), k, true), cca::beat(k, 1'000'000, 1));
    return static_cast<cca::criterion_state>(s.vector()[0]);
  }
};

// Asks for one goal, then for another; publishes the phase and amplitude of a running oscillator.
struct script {
  auto process(cca::beat now) -> std::tuple<cca::out<"reference", leg>,
                                            cca::out<"phase", cca::over<cca::phase, stride>>,
                                            cca::out<"amplitude", cca::over<cca::amplitude, stride>>> {
    return {now.index() < 2600 ? Eigen::Vector2d(0.1, -0.8) : Eigen::Vector2d(0.6, -1.2),
            2e-9 * cca::pi * static_cast<double>(now.time()), 1.0};
  }
};
struct late_robot {  // follows, but sticks for a while
  auto process(cca::in<"command", leg> wanted, cca::beat now) -> cca::out<"angles", leg> {
    if (now.index() < 2500 || now.index() > 4000) angles += 0.2 * (wanted.vector() - angles);
    return angles;
  }
  Eigen::Vector2d angles{0, 0};
};

template <class Skill>
struct plain_bench : cca::graph<cca::rate<1000>,
                                cca::node<"script", script>,
                                cca::node<"skill", Skill>,
                                cca::node<"robot", late_robot>,
                                cca::wire<"script.reference", "skill.reference">,
                                cca::wire<"skill.command", "robot.command">,
                                cca::wire<"robot.angles", "skill.feedback", cca::delayed<1>>,
                                cca::observe<"skill.**.*">> {};
template <class Skill>
struct phase_bench : cca::graph<cca::rate<1000>,
                                cca::node<"script", script>,
                                cca::node<"skill", Skill>,
                                cca::node<"robot", late_robot>,
                                cca::wire<"script.reference", "skill.reference">,
                                cca::wire<"script.phase", "skill.phase">,
                                cca::wire<"script.amplitude", "skill.amplitude">,
                                cca::wire<"skill.command", "robot.command">,
                                cca::wire<"robot.angles", "skill.feedback", cca::delayed<1>>,
                                cca::observe<"skill.**.*">> {};

using vite_names = cca::named<"target", "position", "status">;
struct arm : cca::adaptive_component<cca::vite<leg>, cca::reaching_goal<leg>, vite_names> {};
struct follower : cca::tracker<cca::vite<leg>, cca::tracking<leg>, vite_names> {};
struct untaught : cca::tracker<cca::dmp_rhythmic_module<leg, stride, 8>, cca::tracking<leg>> {};

using enum cca::component_status;
struct arm_case {
  using graph = plain_bench<arm>;
  static constexpr int beats = 6000;
  static constexpr bool at_rest = true;
  static void prepare(cca::controller<graph>& c) {
    c.get<"skill.criterion">().p.limits = {0.02, 0.04, cca::infinity, 0.05};
  }
  static std::set<cca::component_status> expected() { return {converging, reached}; }
};
struct follower_case {
  using graph = plain_bench<follower>;
  static constexpr int beats = 6000;
  static constexpr bool at_rest = false;
  static void prepare(cca::controller<graph>& c) {
    c.get<"skill.criterion">().p.limits = {0.02, 0.04, 0.3, 0.05};
  }
  static std::set<cca::component_status> expected() { return {converging, reached, diverged}; }
};
struct untaught_case {
  using graph = phase_bench<untaught>;
  static constexpr int beats = 6000;
  static constexpr bool at_rest = false;
  static void prepare(cca::controller<graph>& c) {
    c.get<"skill.criterion">().p.limits = {0.02, 0.04, 0.3, 0.05};
  }
  static std::set<cca::component_status> expected() { return {outside_trained_region, reached, diverged}; }
};

}  // namespace

TEST_CASE(
    "tracking and reaching obey the laws of a criterion over angles, positions, orientations and "
    "phases") {
  laws::criterion<of_angles<cca::tracking<leg>>>();
  laws::criterion<of_angles<cca::reaching_goal<leg>>>();
  laws::criterion<of_positions>();
  laws::criterion<of_orientations>();
  laws::criterion<of_phases>();
}

TEST_CASE("grasping obeys the laws of a criterion") { laws::any_criterion<of_a_grip>(); }

TEST_CASE("all kinds of adaptive components obey their laws") {
  laws::adaptive_component<arm_case>();
  laws::adaptive_component<follower_case>();
  laws::adaptive_component<untaught_case>();
}

TEST_CASE("a grasp is firm, still, and around something") {
  cca::grasping<aperture, grip> c;
  c.p = {0.5, 0.2, 0.02, 0.1, 0.01};
  std::int64_t k = 0;
  const auto feel = [&](double width, double effort, int beats) {
    double state = 0;
    for (int i = 0; i < beats; ++i, ++k) {
      const auto [e, s] = c.process({one(0.0), k, true}, {one(width), k, true}, {one(effort), k, true},
                                    cca::beat(k, 1'000'000, 1));
      state = s.vector()[0];
    }
    return static_cast<cca::criterion_state>(state);
  };
  using enum cca::criterion_state;
  CHECK(feel(0.5, 0.1, 20) == open);  // not firm
  CHECK(feel(0.5, -0.6, 9) == open);  // firm, but only for 9 ms
  CHECK(feel(0.5, -0.6, 1) == fulfilled);
  CHECK(feel(0.5, -0.3, 20) == fulfilled);  // weaker, but above `slack`
  CHECK(feel(0.5, -0.1, 1) == open);
  double width = 0.5;
  for (int i = 0; i < 30; ++i) CHECK(feel(width -= 0.001, 0.6, 1) == open);  // it moves at 1 rad/s
  CHECK(feel(width, 0.6, 20) == fulfilled);
  CHECK(feel(0.01, 0.6, 1) == open);   // it slips
  CHECK(feel(0.01, 0.6, 20) == lost);  // closed on nothing
  CHECK(feel(0.3, 0.0, 1) == open);
  CHECK(feel(std::numeric_limits<double>::quiet_NaN(), 0.6, 20) == lost);
  CHECK(feel(0.3, 0.6, 5) == open);
  CHECK(feel(0.01, 0.6, 9) == open);  // 9 ms are too short to be lost
  CHECK(feel(0.3, 0.6, 1) == open);   // it moved
  CHECK(feel(0.3, 0.6, 9) == open);
  CHECK(feel(0.3, 0.1, 1) == open);  // held for 9 ms, then slack
  CHECK(feel(0.3, 0.6, 9) == open);
  CHECK(feel(0.3, 0.6, 1) == fulfilled);
  for (int again = 0; again < 2; ++again) {  // each start resets it, in every state
    c.on_start();
    CHECK(feel(0.3, 0.6, 10) == open);  // the first sample has no speed yet
    CHECK(feel(0.3, 0.6, 1) == fulfilled);
    c.on_start();
    CHECK(feel(0.3, 0.6, 9) == open);
  }
  c.p.still = 10;
  CHECK(feel(0.0205, 0.6, 10) == open);
  CHECK(feel(0.0195, 0.6, 1) ==
        open);  // the first sample had no speed, so it held for 9 ms; slow closing is not holding
  CHECK(feel(0.0195, 0.6, 9) == lost);
  c.p.hold = 0.1;
  CHECK(feel(0.0195, 0.6, 1) == lost);  // a longer hold time does not open a closed gripper
  c.p.hold = 0.01;
  CHECK(feel(0.3, 0.0, 1) == open);
  CHECK(feel(0.01, 0.0, 9) == open);
  c.on_start();
  CHECK(feel(0.01, 0.0, 9) == open);
  c.on_start();
  const cca::beat now(k, 1'000'000, 1);
  using target = cca::in<"target", aperture>;
  using feedback = cca::in<"feedback", aperture>;
  using effort = cca::in<"effort", grip>;
  const target t(one(0.1), k, true);
  const feedback f(one(0.4), k, true);
  const effort e(one(0.6), k, true);
  CHECK_EQ(std::get<0>(c.process(t, f, e, now)).vector()[0], doctest::Approx(0.3));
  CHECK_EQ(std::get<0>(c.process(target(), f, e, now)).vector()[0], 0);  // an input has no sample yet
  CHECK_EQ(std::get<0>(c.process(t, feedback(), e, now)).vector()[0], 0);
  CHECK_EQ(std::get<0>(c.process(t, f, effort(), now)).vector()[0], 0);
  c.p.slack = 0.6;
  CHECK_THROWS_AS(cca::check_parameters(c.p), cca::refused);
}

namespace {

// The same follower; its robot counts in hundredths of a degree and its reference is in degrees.
struct degrees : cca::space<cca::number, cca::axes<hip, knee>> {};
struct counts : cca::space<cca::number, cca::axes<hip, knee>> {};
template <int PerTurn>
struct to_angle {
  Eigen::Vector2d operator()(const Eigen::Vector2d& v) const { return v * (2 * cca::pi / PerTurn); }
};
template <int PerTurn>
struct from_angle {
  Eigen::Vector2d operator()(const Eigen::Vector2d& v) const { return v * (PerTurn / (2 * cca::pi)); }
};
struct slower {
  auto process(cca::in<"input", cca::over<cca::amplitude, cca::go_axis>> x)
      -> cca::out<"output", cca::over<cca::amplitude, cca::go_axis>> {
    return 0.5 * x.vector();
  }
};
struct mapped : cca::tracker<cca::vite<leg>,
                             cca::tracking<leg>,
                             vite_names,
                             cca::timed<1>,
                             cca::reference_through<cca::mapping<degrees, leg, to_angle<360>>>,
                             cca::feedback_through<cca::mapping<counts, leg, to_angle<36000>>>,
                             cca::command_through<cca::mapping<leg, counts, from_angle<36000>>>,
                             cca::control_through<"go", slower>> {};

struct wishes {
  auto process(cca::beat) -> std::tuple<cca::out<"angles", leg>,
                                        cca::out<"degrees", degrees>,
                                        cca::out<"go", cca::over<cca::amplitude, cca::go_axis>>,
                                        cca::out<"half", cca::over<cca::amplitude, cca::go_axis>>> {
    return {Eigen::Vector2d(0.5, -0.25) * cca::pi, Eigen::Vector2d(90, -45), 1.0, 0.5};
  }
};
struct counting_robot {
  auto process(cca::in<"command", counts> wanted) -> cca::out<"counts", counts> {
    return now += 0.2 * (wanted.vector() - now);
  }
  Eigen::Vector2d now{0, 0};
};
struct side_by_side : cca::graph<cca::rate<1000>,
                                 cca::node<"wish", wishes>,
                                 cca::node<"plain", follower>,
                                 cca::node<"robot", late_robot>,
                                 cca::node<"mapped", mapped>,
                                 cca::node<"counting", counting_robot>,
                                 cca::wire<"wish.angles", "plain.reference">,
                                 cca::wire<"wish.half", "plain.go">,
                                 cca::wire<"plain.command", "robot.command">,
                                 cca::wire<"robot.angles", "plain.feedback", cca::delayed<1>>,
                                 cca::wire<"wish.degrees", "mapped.reference">,
                                 cca::wire<"wish.go", "mapped.go">,
                                 cca::wire<"mapped.command", "counting.command">,
                                 cca::wire<"counting.counts", "mapped.feedback", cca::delayed<1>>,
                                 cca::observe<"*.criterion.*">> {};

}  // namespace

TEST_CASE("with mappings on its ports a component works in its own space") {
  cca::controller<side_by_side> c;
  c.load();
  c.start();
  for (int k = 0; k < 2000; ++k) {
    c.step();
    CHECK((c.get<"counting">().now * (2 * cca::pi / 36000) - c.get<"robot">().angles).norm() < 1e-12);
    const auto all = laws::told(c);
    CHECK(std::abs(all.at("plain.criterion.error")[0] - all.at("mapped.criterion.error")[0]) < 1e-12);
  }
  CHECK((c.get<"counting">().now - Eigen::Vector2d(9000, -4500)).norm() < 50);
}

namespace {

// A hand with motor-driven fingers, which measure the current of the motor.
struct current : cca::space<cca::number, cca::axes<jaw>> {};
struct to_torque {
  Eigen::Matrix<double, 1, 1> operator()(const Eigen::Matrix<double, 1, 1>& amperes) const {
    return 0.25 * amperes;
  }
};
struct gripper
    : cca::adaptive_component<cca::vite<aperture>,
                              cca::grasping<aperture, grip>,
                              vite_names,
                              cca::control_through<"effort", cca::mapping<current, grip, to_torque>>> {};
struct closing {
  auto process(cca::beat) -> cca::out<"aperture", aperture> { return 0.0; }
};
struct fingers {  // close up to the thing between them; the effort grows with the remaining distance
  auto process(cca::in<"command", aperture> wanted)
      -> std::tuple<cca::out<"aperture", aperture>, cca::out<"current", current>> {
    const double command = wanted.vector()[0];
    return {std::max(command, width), 400 * std::max(width - command, 0.0)};
  }
  double width = 0.05;  // of the thing
};
struct grasp : cca::graph<cca::rate<1000>,
                          cca::node<"wish", closing>,
                          cca::node<"grip", gripper>,
                          cca::node<"fingers", fingers>,
                          cca::wire<"wish.aperture", "grip.reference">,
                          cca::wire<"grip.command", "fingers.command">,
                          cca::wire<"fingers.aperture", "grip.feedback", cca::delayed<1>>,
                          cca::wire<"fingers.current", "grip.effort", cca::delayed<1>>,
                          cca::observe<"grip.status.*">> {};

}  // namespace

TEST_CASE("grasping works as the criterion of a component, with its effort through a mapping") {
  cca::controller<grasp> c;
  c.get<"grip.criterion">().p = {4.0, 2.0, 0.02, 0.1, 0.1};
  c.load();
  c.start();
  const auto component = [&] { return laws::told(c).at("grip.status.component")[0]; };
  std::vector<double> told;
  for (int k = 0; k < 3000; ++k) {
    if (k == 1500) c.get<"fingers">().width = 0.005;  // it slips out
    c.step();
    if (told.empty() || told.back() != component()) told.push_back(component());
  }
  using cca::status_of;
  CHECK(told == std::vector<double>{status_of(converging), status_of(reached), status_of(converging),
                                    status_of(diverged)});
}

namespace {

// [generator]
struct swing : cca::generator<stride, cca::dmp_rhythmic_module<leg, stride, 25>, cca::tracking<leg>> {};

struct hand {  // sets all four control inputs
  auto process(cca::beat) -> std::tuple<cca::out<"centre", leg>,
                                        cca::out<"amplitude", cca::over<cca::amplitude, stride>>,
                                        cca::out<"phase", cca::over<cca::phase, stride>>,
                                        cca::out<"frequency", cca::over<cca::frequency, stride>>> {
    return {centre, amplitude, phase, frequency};
  }
  Eigen::Vector2d centre{0.1, -0.8};
  double amplitude = 1, phase = 0, frequency = 1.5;
};
struct swinging : cca::graph<cca::rate<1000>,
                             cca::node<"hand", hand>,
                             cca::node<"swing", swing>,
                             cca::node<"robot", late_robot>,
                             cca::wire<"hand.centre", "swing.centre">,
                             cca::wire<"hand.amplitude", "swing.amplitude">,
                             cca::wire<"hand.phase", "swing.phase">,
                             cca::wire<"hand.frequency", "swing.frequency">,
                             cca::wire<"swing.command", "robot.command">,
                             cca::wire<"robot.angles", "swing.feedback", cca::delayed<1>>,
                             cca::observe<"swing.status.*">> {};
// [generator end]

struct other_centre {  // while the robot sticks
  auto process(cca::beat now) -> std::tuple<cca::out<"centre", leg>,
                                            cca::out<"amplitude", cca::over<cca::amplitude, stride>>,
                                            cca::out<"phase", cca::over<cca::phase, stride>>,
                                            cca::out<"frequency", cca::over<cca::frequency, stride>>> {
    return {now.index() < 2600 ? Eigen::Vector2d(0.1, -0.8) : Eigen::Vector2d(0.6, -1.2), 1.0, 0.0, 1.5};
  }
};
struct generator_case {
  struct graph : cca::graph<cca::rate<1000>,
                            cca::node<"script", other_centre>,
                            cca::node<"skill", swing>,
                            cca::node<"robot", late_robot>,
                            cca::wire<"script.centre", "skill.centre">,
                            cca::wire<"script.amplitude", "skill.amplitude">,
                            cca::wire<"script.phase", "skill.phase">,
                            cca::wire<"script.frequency", "skill.frequency">,
                            cca::wire<"skill.command", "robot.command">,
                            cca::wire<"robot.angles", "skill.feedback", cca::delayed<1>>,
                            cca::observe<"skill.**.*">> {};
  static constexpr int beats = 6000;
  static constexpr bool at_rest = false;
  static void prepare(cca::controller<graph>& c) {
    c.get<"skill.criterion">().p.limits = {0.02, 0.04, 0.3, 0.05};
  }
  static std::set<cca::component_status> expected() { return {outside_trained_region, reached, diverged}; }
};

template <class Learner, class Shape>
typename Learner::learned taught(Shape shape) {
  std::vector<cca::example<typename Learner::model>> all;
  for (int i = 0; i < 1000; ++i) {
    const double f = 2e-3 * cca::pi * i;
    all.push_back({{f, 1.0}, shape(f)});
  }
  return Learner::batch(all, {});
}

struct range {
  double low = 9, high = -9;
};
template <class Graph>
range over(cca::controller<Graph>& c, int beats) {
  range r;
  for (int k = 0; k < beats; ++k) {
    c.step();
    const double hip_angle = laws::told(c).empty() ? 0 : c.template get<"robot">().angles[0];
    r.low = std::min(r.low, hip_angle), r.high = std::max(r.high, hip_angle);
  }
  return r;
}

}  // namespace

TEST_CASE("a generator oscillates around its centre, and rests there at a negative amplitude") {
  cca::controller<swinging> c;
  using learner = cca::dmp_rhythmic_module<leg, stride, 25>::learner;
  c.get<"swing">().get<"module">().get<"pattern">().learning.hand_over(taught<learner>(
      [](double f) -> Eigen::Vector2d { return 60 * Eigen::Vector2d(std::sin(f), std::cos(f)); }));
  c.load();
  c.start();
  c.run(cca::for_beats<1000>{});
  const auto first = over(c, 800);
  CHECK((first.high + first.low) / 2 == doctest::Approx(0.1).epsilon(0.05));
  const double width = first.high - first.low;
  CHECK(width > 0.2);
  CHECK(laws::told(c).at("swing.status.module") ==
        std::vector<double>{cca::status_of(cca::learning::trained),
                            cca::status_of(cca::trained_region::inside),
                            cca::status_of(cca::learning_answer::none)});
  auto ahead = c;  // half a turn ahead: where one is high, the other is low
  ahead.get<"hand">().phase = cca::pi;
  c.run(cca::for_beats<600>{});
  ahead.run(cca::for_beats<600>{});
  CHECK(std::abs(c.get<"robot">().angles[0] - 0.1 + ahead.get<"robot">().angles[0] - 0.1) < 0.02 * width);
  CHECK(std::abs(c.get<"robot">().angles[1] - ahead.get<"robot">().angles[1]) > 0.1 * width);
  c.get<"hand">().amplitude = -1;
  c.get<"hand">().centre = {0.3, -0.5};
  for (int k = 0; k < 8000; ++k) c.step();
  CHECK((c.get<"robot">().angles - Eigen::Vector2d(0.3, -0.5)).norm() < 2e-3);
  CHECK(laws::told(c).at("swing.status.component")[0] == cca::status_of(reached));
}

namespace {

// All inputs of a generator, each of which can be broken.
struct hands {
  auto process(cca::beat) -> std::tuple<cca::out<"centre", leg>,
                                        cca::out<"amplitude", cca::over<cca::amplitude, stride>>,
                                        cca::out<"phase", cca::over<cca::phase, stride>>,
                                        cca::out<"frequency", cca::over<cca::frequency, stride>>,
                                        cca::out<"feedback", leg>> {
    return {centre, amplitude, phase, frequency, feedback};
  }
  Eigen::Vector2d centre{0.1, -0.8}, feedback{0.1, -0.8};
  double amplitude = 1, phase = 0, frequency = 1.5;
};
struct held_swing : cca::graph<cca::rate<1000>,
                               cca::node<"hands", hands>,
                               cca::node<"swing", swing>,
                               cca::wire<"hands.centre", "swing.centre">,
                               cca::wire<"hands.amplitude", "swing.amplitude">,
                               cca::wire<"hands.phase", "swing.phase">,
                               cca::wire<"hands.frequency", "swing.frequency">,
                               cca::wire<"hands.feedback", "swing.feedback">,
                               cca::observe<"swing.**.*">> {};

}  // namespace

TEST_CASE("an input of a generator that is NaN or infinite does what its header says") {
  cca::controller<held_swing> healthy;
  using learner = cca::dmp_rhythmic_module<leg, stride, 25>::learner;
  healthy.get<"swing">().get<"module">().get<"pattern">().learning.hand_over(taught<learner>(
      [](double f) -> Eigen::Vector2d { return 60 * Eigen::Vector2d(std::sin(f), std::cos(f)); }));
  healthy.load();
  healthy.start();
  healthy.run(cca::for_beats<700>{});
  const auto before = laws::told(healthy);
  struct expected {
    void (*set)(hands&, double);
    bool oscillator_stands, pattern_stands, pattern_says_so, lost;
  };
  const std::array cases{
      expected{[](hands& h, double x) { h.centre[1] = x; }, false, true, true, false},
      expected{[](hands& h, double x) { h.phase = x; }, false, true, true, false},
      expected{[](hands& h, double x) { h.frequency = x; }, true, true, true, false},
      expected{[](hands& h, double x) { h.amplitude = x; }, true, false, false, false},
      expected{[](hands& h, double x) { h.feedback[0] = x; }, false, false, false, true},
  };
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (const double broken : {std::nan(""), cca::infinity, -cca::infinity}) {
      CAPTURE(i);
      CAPTURE(broken);
      auto c = healthy;
      cases[i].set(c.get<"hands">(), broken);
      for (int k = 0; k < 50; ++k) {
        c.step();
        const auto now = laws::told(c);
        const auto stands = [&](const char* path) { return now.at(path) == before.at(path); };
        for (const auto& [path, values] : now)
          if (path != "swing.module.shift.shifted")
            for (const double x : values) CHECK_MESSAGE(std::isfinite(x), path);
        CHECK(stands("swing.module.oscillator.phase") == cases[i].oscillator_stands);
        CHECK((now.at("swing.module.oscillator.status")[0] == cca::status_of(cca::ode_status::unreadable)) ==
              cases[i].oscillator_stands);
        CHECK(stands("swing.module.pattern.command") == cases[i].pattern_stands);
        CHECK((now.at("swing.status.ode")[0] == cca::status_of(cca::ode_status::unreadable)) ==
              cases[i].pattern_says_so);
        CHECK((now.at("swing.criterion.error")[0] == 1e12) == cases[i].lost);
        CHECK((now.at("swing.status.component")[0] == cca::status_of(diverged)) == cases[i].lost);
      }
      CHECK(c.state() == cca::state::started);  // no fault
    }
}

namespace {

struct caller {  // asks for one second of learning
  auto process(cca::beat now) -> cca::maybe<"learn", cca::learning_request> {
    if (now.index() == 500) return cca::status_of(cca::learning_call::collect);
    if (now.index() == 1500) return cca::status_of(cca::learning_call::rest);
    return {};
  }
};
struct demonstrator {
  auto process(cca::beat now) -> std::tuple<cca::out<"angles", leg>,
                                            cca::out<"centre", leg>,
                                            cca::out<"phase", cca::over<cca::phase, stride>>,
                                            cca::out<"amplitude", cca::over<cca::amplitude, stride>>> {
    const double f = 2e-9 * cca::pi * static_cast<double>(now.time());
    return {shape(f), Eigen::Vector2d(0.1, -0.8), f, 1.0};
  }
  static Eigen::Vector2d shape(double f) {
    return {0.1 + 0.3 * std::sin(f), -0.8 + 0.2 * std::cos(2 * f + 1)};
  }
};
template <class Learner>
struct taught_skill : cca::tracker<cca::dmp_rhythmic_module<leg, stride, 50, Learner>, cca::tracking<leg>> {};
template <class Learner>
struct school : cca::graph<cca::rate<1000>,
                           cca::node<"caller", caller>,
                           cca::node<"demonstrator", demonstrator>,
                           cca::node<"skill", taught_skill<Learner>>,
                           cca::node<"robot", late_robot>,
                           cca::wire<"caller.learn", "skill.learn">,
                           cca::wire<"demonstrator.angles", "skill.demonstration">,
                           cca::wire<"demonstrator.centre", "skill.reference">,
                           cca::wire<"demonstrator.phase", "skill.phase">,
                           cca::wire<"demonstrator.amplitude", "skill.amplitude">,
                           cca::wire<"skill.command", "robot.command">,
                           cca::wire<"robot.angles", "skill.feedback", cca::delayed<1>>,
                           cca::observe<"skill.module.**.*">> {};

// The largest error of the command against the demonstration over a turn, relative to the amplitude.
template <class Learner>
double shape_error(bool online) {
  cca::controller<school<Learner>> c;
  auto& module = c.template get<"skill">().template get<"module">();
  c.load();
  c.start();
  if (online) {
    c.run(cca::for_beats<10>{});
    module.learning.learn();
    c.run(cca::for_beats<2000>{});
    CHECK(module.learning.state() == cca::learning::trained);  // after the request to rest
  } else {
    c.run(cca::for_beats<2000>{});
    CHECK(module.learning.state() == cca::learning::idle);  // as requested
    CHECK(module.learning.example_count() == 1000);
    // [learning]
    // The batch runs on another thread; meanwhile the loop uses the old value.
    auto result = std::async(std::launch::async, module.learning.begin_batch(module.p.settings));
    c.run(cca::for_beats<200>{});
    CHECK(module.learning.state() == cca::learning::batch);
    module.learning.hand_over(result.get());  // the whole result, between two beats
    // [learning end]
  }
  c.run(cca::for_beats<4000>{});
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    c.step();
    const auto command = laws::told(c).at("skill.module.command");
    const auto wanted = demonstrator::shape(2e-3 * cca::pi * static_cast<double>(c.beat_index() - 1));
    worst = std::max(worst, std::abs(command[0] - wanted[0]) / 0.3);
  }
  return worst;
}

using fifty = cca::rhythmic_shape<leg, 50>;

}  // namespace

TEST_CASE("a shape is learned from a demonstration, in a batch on another thread or online, and reproduced") {
  const double lwr = shape_error<cca::locally_weighted_regression<fifty>>(false),
               lwr_online = shape_error<cca::locally_weighted_regression<fifty>>(true),
               rls = shape_error<cca::recursive_least_squares<fifty>>(false),
               rls_online = shape_error<cca::recursive_least_squares<fifty>>(true);
  MESSAGE("of the swing: locally weighted " << lwr << ", online " << lwr_online << "; least squares " << rls
                                            << ", online " << rls_online);
  CHECK(lwr < 0.05);
  CHECK(lwr_online < 0.05);
  CHECK(rls < 0.005);
  CHECK(rls_online < 0.005);
}

namespace {

constexpr std::string_view picture_of_generator = R"(// [generator picture]
flowchart LR
  n0["hand<br/><i>1000 Hz</i>"]
  n6["robot<br/><i>restless</i>"]
  subgraph g1["swing"]
    n4["criterion<br/><i>1000 Hz</i>"]
    n5["status<br/><i>1000 Hz</i>"]
    subgraph g2["module"]
      n1["oscillator<br/><i>1000 Hz</i>"]
      n2["shift<br/><i>1000 Hz</i>"]
      n3["pattern<br/><i>1000 Hz</i>"]
    end
  end
  n0 -- "amplitude<br/>over&lt;amplitude, stride&gt;, 1000 Hz" --> n1
  n0 -- "frequency<br/>over&lt;frequency, stride&gt;, 1000 Hz" --> n1
  n1 -- "phase<br/>over&lt;phase, stride&gt;, 1000 Hz" --> n2
  n0 -- "phase → by<br/>over&lt;phase, stride&gt;, 1000 Hz" --> n2
  n2 -- "shifted → phase<br/>over&lt;phase, stride&gt;, 1000 Hz" --> n3
  n1 -- "amplitude<br/>over&lt;amplitude, stride&gt;, 1000 Hz" --> n3
  n0 -- "frequency<br/>over&lt;frequency, stride&gt;, 1000 Hz" --> n3
  n0 -- "centre → reference<br/>leg, 1000 Hz" --> n3
  n3 -- "command → target<br/>leg" --> n4
  n6 -. "angles → feedback<br/>leg<br/>delayed 1" .-> n4
  n3 -- "ode<br/>ode_status_port, 1000 Hz" --> n5
  n3 -- "module<br/>module_status_port, 1000 Hz" --> n5
  n4 -- "state → criterion<br/>criterion_port, 1000 Hz" --> n5
  n3 -- "command<br/>leg" --> n6
)";  // [generator picture end]

}  // namespace

TEST_CASE("a generator obeys the laws of an adaptive component") {
  laws::adaptive_component<generator_case>();
}

TEST_CASE("the picture of a generator is the one on its page") {
  test::check_picture<swinging>(picture_of_generator);
}
