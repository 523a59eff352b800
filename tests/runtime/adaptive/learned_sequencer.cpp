// A sequencer learns which of the allowed skills comes next, from a criterion.
#include <array>
#include <set>
#include <string>
#include <utility>

#include <cca/adaptive/choice/learned_sequencer.hpp>
#include <cca/adaptive/tracking.hpp>

#include "../../laws/learner_laws.hpp"
#include "../../laws/request_laws.hpp"
#include "rig.hpp"

using namespace adaptive_test;

namespace {

// [plan]
// Two ways to follow a target; the criterion says which one follows better.
struct plan : cca::steps<cca::step<"decide", cca::then_one_of<"slow", "quick">>,
                         cca::step<"slow", cca::after<5>, cca::then<"rest">>,
                         cca::step<"quick", cca::after<5>, cca::then<"rest">>,
                         cca::step<"rest", cca::after<40>, cca::then<"decide">>> {};

struct target {  // begins to move when a skill begins
  auto process(cca::in<"step", cca::step_port> step, cca::beat now) -> cca::out<"angles", leg> {
    const int running = static_cast<int>(step[cca::step_axis{}]);
    moving = running == plan::at<"slow"> || running == plan::at<"quick">;
    return moving ? Eigen::Vector2d(std::sin(6e-9 * static_cast<double>(now.time())), 0)
                  : Eigen::Vector2d(0, 0);
  }
  bool moving = false;
};
struct follower {  // each skill is a gain of the same servo
  auto process(cca::in<"step", cca::step_port> step, cca::in<"target", leg> to) -> cca::out<"angles", leg> {
    const int running = static_cast<int>(step[cca::step_axis{}]);
    return angles += (running == plan::at<"quick"> ? quick : slow) * (to.vector() - angles);
  }
  double slow = 0.02, quick = 0.5;
  Eigen::Vector2d angles{0, 0};
};

struct choosing
    : cca::graph<cca::rate<1000>,
                 cca::node<"sequencer", cca::learned_sequencer<"judge.state.*", plan>, cca::timed<1>>,
                 cca::node<"target", target>,
                 cca::node<"servo", follower>,
                 cca::node<"judge", cca::tracking<leg>>,
                 cca::wire<"sequencer.step", "target.step">,
                 cca::wire<"sequencer.step", "servo.step">,
                 cca::wire<"target.angles", "servo.target">,
                 cca::wire<"target.angles", "judge.target">,
                 cca::wire<"servo.angles", "judge.feedback">,
                 cca::wire<"judge.state", "sequencer.criterion", cca::delayed<1>>,
                 cca::wire<"judge.error", "sequencer.error", cca::delayed<1>>> {};
// [plan end]

// Every pair of steps that a run goes through, and how often.
struct record {
  std::set<std::pair<int, int>> went;
  int slow = 0, quick = 0;
};
record run(cca::controller<choosing>& c, int beats) {
  record r;
  int last = c.get<"sequencer">().steps.step();
  for (int k = 0; k < beats; ++k) {
    c.step();
    const int now = c.get<"sequencer">().steps.step();
    if (now == last) continue;
    r.went.insert({last, now});
    r.slow += now == plan::at<"slow">;
    r.quick += now == plan::at<"quick">;
    last = now;
  }
  return r;
}
const std::set<std::pair<int, int>> allowed{{0, 1}, {0, 2}, {1, 3}, {2, 3}, {3, 0}};

template <class Plan>
struct by_hand {
  cca::learned_sequencer<"s.*", Plan> it;
  std::int64_t k = 0;
  double state = 0, error = 0;
  std::array<double, 1> a{};
  bool measured = false;

  by_hand() { it.on_start(); }
  int step(int beats = 1) {
    for (int i = 0; i < beats; ++i, ++k) {
      const cca::observation one{"s.a", a, 0, true};
      cca::observe<"s.*|s", cca::delayed<1>> told(&one, 1);
      cca::optional_in<"error", cca::criterion_error> off(Eigen::Matrix<double, 1, 1>(error), k, true);
      if (measured) off.set_wired();
      (void)it.process(told,
                       cca::in<"criterion", cca::criterion_port>(Eigen::Matrix<double, 1, 1>(state), k, true),
                       off, {}, motor_test::at(k));
    }
    return it.steps.step();
  }
};

struct table_case {
  using learner = cca::preference_learning<cca::preference_table<plan>>;
  static constexpr double left = 1e-9;
  static Eigen::Vector2d input(laws::ode_source& random) {
    return {0, static_cast<double>(static_cast<int>(random(0, 3)))};
  }
  static Eigen::Matrix<double, 1, 1> truth(const Eigen::Vector2d& x) {
    return Eigen::Matrix<double, 1, 1>(0.3 * x[1] - 0.5);
  }
  static Eigen::Vector2d far() { return {2, 2}; }
};

struct taught_sequencer {
  using student = cca::learned_sequencer<"s.*", plan>;
  static constexpr auto numbers = laws::any_numbers;
  static auto fresh() { return std::make_unique<student>(); }
  static laws::told_of_request fire(student& s, double call, bool) {
    const auto [step, running, timed_out, status, module, broken] = s.process(
        {nullptr, 0}, cca::in<"criterion", cca::criterion_port>(Eigen::Matrix<double, 1, 1>(0), 0, true), {},
        laws::numbered_request(call), motor_test::at(0));
    return laws::told_of(module.vector());
  }
  static void teach(student& s) {
    for (const auto& one : laws::examples<table_case>(100, 7)) s.learning.teach(one.x, one.y, s.p.settings);
  }
};

}  // namespace

TEST_CASE("the table of preferences obeys the laws of a learner") { laws::learner<table_case>(); }
TEST_CASE("the table of preferences and its sequencer answer every request") {
  laws::requests<laws::lone_learner<table_case>>();
  laws::requests<taught_sequencer>();
}

TEST_CASE("it learns to prefer the skill that the criterion rates better, and stays within the plan") {
  for (const bool quick_is_better : {true, false}) {
    cca::controller<choosing> c;
    auto& sequencer = c.get<"sequencer">();
    if (!quick_is_better) std::swap(c.get<"servo">().slow, c.get<"servo">().quick);
    sequencer.p.half = 0.1;
    c.load();
    c.start();
    const auto first = run(c, 1000);
    CHECK(first.quick == 0);  // untaught: always the first of the plan
    CHECK(first.slow > 15);
    sequencer.learning.learn();
    const std::size_t before = laws::allocations();
    c.run(cca::for_beats<500>{});
    CHECK(laws::allocations() == before);
    const auto lesson = run(c, 5000);
    CHECK(lesson.quick > 5);  // it tried both
    CHECK(lesson.slow > 5);
    sequencer.learning.rest();
    const auto after = run(c, 1000);
    CHECK((quick_is_better ? after.slow : after.quick) == 0);
    CHECK((quick_is_better ? after.quick : after.slow) > 15);
    for (const auto& r : {first, lesson, after})
      for (const auto& pair : r.went) CHECK(allowed.contains(pair));
    CHECK(std::abs(sequencer.value(0, 1) - sequencer.value(0, 2)) > 0.1);
    // A start keeps what was learned.
    c.stop();
    c.start();
    const auto again = run(c, 1000);
    CHECK((quick_is_better ? again.slow : again.quick) == 0);
  }
}

TEST_CASE("whatever is learned, only steps that the plan allows now are taken") {
  struct guarded : cca::steps<cca::step<"decide", cca::then_one_of<"left", "right">>,
                              cca::step<"left", cca::below<"s.a", 1.0>, cca::then<"decide">>,
                              cca::step<"right", cca::above<"s.a", 0.0>, cca::then<"decide">>,
                              cca::step<"forbidden", cca::then<"decide">>> {};
  by_hand<guarded> r;
  auto known = r.it.learning.get();
  known.function.values << 9, -1, 1, 99, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9;
  r.it.learning.hand_over(known);
  const auto left = guarded::at<"left">, right = guarded::at<"right">;
  r.a = {0.5};  // both hold
  CHECK(r.step() == right);
  r.a = {-1};  // right is preferred, but its condition does not hold
  r.step();
  CHECK(r.step() == left);
  r.it.learning.learn();
  r.it.p.exploration = 1;
  r.a = {0.5};
  std::set<int> seen;
  for (int k = 0; k < 200; ++k) seen.insert(r.step());
  CHECK(seen == std::set<int>{0, left, right});
}

TEST_CASE("a step that the plan does not allow is not entered, whoever chooses it") {
  cca::sequence<plan> s;
  const cca::observe<"s.*", cca::delayed<1>> nothing(nullptr, 0);
  for (int k = 0; k < 6; ++k)
    s.update_by(motor_test::at(k), [](int, std::span<const int>) { return plan::at<"rest">; }, nothing);
  CHECK(s.in<"slow">());  // the first of those that may follow
}

TEST_CASE("a judgement is 1, 0 or -1 by the state, or follows the error - NaN of an error is lost") {
  struct one_way : cca::steps<cca::step<"a", cca::then<"b">>, cca::step<"b", cca::after<2>, cca::then<"a">>> {
  };
  const auto judged = [](double state, bool measured, double error) {
    by_hand<one_way> r;
    r.it.learning.learn();
    r.it.p.half = 0.5;
    r.state = state, r.measured = measured, r.error = error;
    r.step(30);
    return r.it.value(0, 1);
  };
  using enum cca::criterion_state;
  CHECK(judged(cca::status_of(fulfilled), false, 0) == 1);
  CHECK(judged(cca::status_of(open), false, 0) == 0);
  CHECK(judged(cca::status_of(lost), false, 0) == -1);
  CHECK(judged(std::nan(""), false, 0) == 0);
  CHECK(judged(cca::status_of(open), true, 0) == 1);
  CHECK(judged(cca::status_of(fulfilled), true, 0.25) == 0.5);
  CHECK(judged(cca::status_of(open), true, 0.75) == -0.5);
  CHECK(judged(cca::status_of(lost), true, 0) == -1);
  for (const double far : {1.0, 5.0, 1e12, std::nan(""), cca::infinity})
    CHECK(judged(cca::status_of(open), true, far) == -1);
}

TEST_CASE("with a discount a skill is worth what it leads to, and values stay bounded") {
  // `good` is judged like `bad`, but leads to a step that is fulfilled.
  struct leads
      : cca::steps<cca::step<"decide", cca::then_one_of<"bad", "good">>,
                   cca::step<"bad", cca::then<"nothing">>, cca::step<"good", cca::then<"reward">>,
                   cca::step<"nothing", cca::then<"decide">>, cca::step<"reward", cca::then<"decide">>> {};
  by_hand<leads> r;
  r.it.p.discount = 0.9;
  r.it.p.exploration = 0.5;
  r.it.learning.learn();
  for (int k = 0; k < 5000; ++k) {
    r.state = r.it.steps.in<"reward">() ? cca::status_of(cca::criterion_state::fulfilled) : 0;
    r.step();
  }
  CHECK(r.it.value(0, 2) > r.it.value(0, 1) + 0.1);
  CHECK(r.it.learning.get().function.values.cwiseAbs().maxCoeff() <= 10);
  CHECK(r.it.learning.get().function.values.cwiseAbs().maxCoeff() > 1);
}

TEST_CASE("preferences come back from their file, and a plan with other steps refuses it") {
  const temporary file("preferences");
  by_hand<plan> r;
  auto known = r.it.learning.get();
  known.function.values(0, 2) = 0.75;
  known.tried(0, 2) = 3;
  r.it.learning.hand_over(known);
  REQUIRE(r.it.p.files.save.assign(file.path));
  r.it.on_save();
  by_hand<plan> again;
  REQUIRE(again.it.p.files.load.assign(file.path));
  again.it.on_load();
  CHECK(again.it.value(0, 2) == 0.75);
  CHECK(again.step(6) == plan::at<"quick">);
  struct other : cca::steps<cca::step<"decide", cca::then_one_of<"slow", "fast">>,
                            cca::step<"slow", cca::then<"rest">>, cca::step<"fast", cca::then<"rest">>,
                            cca::step<"rest", cca::then<"decide">>> {};
  by_hand<other> stranger;
  REQUIRE(stranger.it.p.files.load.assign(file.path));
  CHECK(words_of([&] { stranger.it.on_load(); }) ==
        file.path +
            ":2: the file belongs to another model; name the file of this one, or learn again: found "
            "`model preference_table of decide, slow, quick, rest`, expected `model preference_table of "
            "decide, slow, fast, rest`");
}
