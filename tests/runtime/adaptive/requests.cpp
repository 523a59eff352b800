// A request at the port: collects, starts a batch beside the loop, stops it, forgets.
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <cca/adaptive/learning/timed_requests.hpp>
#include <cca/deployment.hpp>
#include <cca/modes.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/modules/gmr_module.hpp>

#include "../../laws/request_laws.hpp"
#include "rig.hpp"

using namespace adaptive_test;

namespace {

using laws::shown;
using v2 = Eigen::Vector2d;

struct lesson_time : cca::space<cca::number, cca::axes<cca::x>> {};

struct teacher {
  auto process(cca::beat now)
      -> std::tuple<cca::out<"time", lesson_time>, cca::out<"centre", leg>, cca::out<"angles", leg>> {
    const double t = std::fmod(1e-9 * static_cast<double>(now.time()), 2);
    return {t, v2(0.1, -0.8), v2(0.1 + 0.3 * std::sin(3 * t), -0.8 + 0.2 * std::cos(2 * t))};
  }
};

// [requests]
// Listens to the teacher for two seconds, and then learns the movement beside the loop.
using lesson = cca::timed_requests<cca::request_at<0, cca::learning_call::collect>,
                                   cca::request_at<2000, cca::learning_call::batch>>;

struct school : cca::graph<cca::rate<1000>,
                           cca::node<"teacher", teacher>,
                           cca::node<"lesson", lesson>,
                           cca::node<"movement", cca::gmr_module<lesson_time, leg, 8>>,
                           cca::wire<"teacher.time", "movement.input">,
                           cca::wire<"teacher.centre", "movement.reference">,
                           cca::wire<"teacher.angles", "movement.demonstration">,
                           cca::wire<"lesson.learn", "movement.learn">,
                           cca::observe<"movement.module">> {};
// [requests end]

laws::told_of_request told(cca::controller<school>& c) {
  laws::told_of_request found{};
  c.observed([&](const cca::observation& one) { found = laws::told_of(one.values); });
  return found;
}
bool learns(cca::controller<school>& c) {
  for (int k = 0; k < 20000 && told(c).learning == cca::learning::batch; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    c.step();
  }
  return told(c).learning == cca::learning::trained;
}

std::string learned_text(const cca::controller<school>& c) {
  const auto& known = c.get<"movement">().learning.get();
  return cca::detail::learned_text({}, cca::detail::schema_of<std::remove_cvref_t<decltype(known)>>, &known);
}

// A level, not an event: it asks again in each beat.
struct insistent {
  auto process(cca::beat) -> cca::out<"learn", cca::learning_request> { return double(number); }
  double number = 0;
};
struct asked : cca::graph<cca::rate<1000>,
                          cca::node<"teacher", teacher>,
                          cca::node<"caller", insistent>,
                          cca::node<"movement", cca::gmr_module<lesson_time, leg, 8>>,
                          cca::wire<"teacher.time", "movement.input">,
                          cca::wire<"teacher.centre", "movement.reference">,
                          cca::wire<"teacher.angles", "movement.demonstration">,
                          cca::wire<"caller.learn", "movement.learn">,
                          cca::observe<"movement.module">> {};

// The same movement: in one mode nobody asks for it, in the other the lesson does; and in an environment of
// its own.
template <class... More>
struct classroom : cca::graph<cca::rate<1000>,
                              cca::node<"teacher", teacher>,
                              cca::node<"movement", cca::gmr_module<lesson_time, leg, 8>, cca::timed<1>>,
                              cca::wire<"teacher.time", "movement.input", cca::delayed<1>>,
                              cca::wire<"teacher.centre", "movement.reference", cca::delayed<1>>,
                              cca::wire<"teacher.angles", "movement.demonstration", cca::delayed<1>>,
                              More...> {};
struct quiet : classroom<> {};
struct with_lesson
    : classroom<cca::node<"lesson", lesson>, cca::wire<"lesson.learn", "movement.learn", cca::delayed<1>>> {};
struct in_modes : cca::modes<cca::mode<"quiet", quiet>, cca::mode<"lesson", with_lesson>> {};
struct apart : cca::deployment<with_lesson,
                               cca::environment<"body", cca::other_nodes>,
                               cca::environment<"mind", cca::nodes<"movement">>> {};

template <class Played>
void check_that_it_learns(Played& c) {
  auto& movement = c.template get<"movement">();
  movement.p.settings.iterations = 20;
  c.load();
  c.start();
  if constexpr (requires { c.template switch_to<"lesson">(); }) c.template switch_to<"lesson">();
  c.run(cca::for_beats<2003>{});
  CHECK(movement.learning.last_answer() == cca::learning_answer::accepted);
  for (int k = 0; k < 20000 && movement.learning.state() == cca::learning::batch; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    c.step();
  }
  CHECK(movement.learning.state() == cca::learning::trained);
}

struct rhythmic_case {
  using module = cca::dmp_rhythmic_module<leg, stride, 10>;
  static constexpr int lesson = 300;
  static laws::module_firing fire(module& m, int k, shown what, cca::learning_call call) {
    const double f = 2e-3 * cca::pi * k;
    cca::optional_in<"demonstration", leg> showing;
    if (what == shown::demonstration)
      showing =
          motor_test::wired<cca::optional_in<"demonstration", leg>>(v2(0.3 * std::sin(f), 0.2 * std::cos(f)));
    const auto [command, velocity, ode, status] = m.process(
        motor_test::given<cca::in<"phase", cca::over<cca::phase, stride>>>(Eigen::Matrix<double, 1, 1>(f)),
        motor_test::given<cca::in<"amplitude", cca::over<cca::amplitude, stride>>>(
            Eigen::Matrix<double, 1, 1>(1)),
        {}, motor_test::given<cca::in<"reference", leg>>(v2(0, 0)), {}, showing, laws::request(call),
        motor_test::at(k));
    return laws::firing_of(command.vector()[0], ode[cca::ode_axis{}], status);
  }
};

}  // namespace

TEST_CASE("a rhythmic module answers every request") {
  laws::requests<laws::module_student<rhythmic_case>>();
}

TEST_CASE(
    "requests at a port collect a demonstration and learn it, with the result of a batch in the program") {
  cca::controller<school> c;
  c.get<"movement">().p.settings.iterations = 20;
  c.load();
  c.start();
  c.run(cca::for_beats<1500>{});
  CHECK(told(c).learning == cca::learning::collecting);
  CHECK(told(c).answer == cca::learning_answer::accepted);
  c.run(cca::for_beats<500>{});
  auto by_hand = c;
  c.step();
  CHECK(told(c).learning == cca::learning::batch);
  CHECK(told(c).answer == cca::learning_answer::accepted);
  auto copy = c;  // while it is computed
  CHECK(learns(c));
  CHECK(told(c).region == cca::trained_region::inside);
  auto& module = by_hand.get<"movement">();
  by_hand.step();
  module.learning.rest();
  module.learning.hand_over(module.learning.begin_batch(module.p.settings)());
  CHECK(learned_text(c) == learned_text(by_hand));
  CHECK(learns(copy));
  CHECK(learned_text(c) == learned_text(copy));
}

TEST_CASE(
    "a learner that learns in batches only refuses to learn online, whoever asks, and goes on as before") {
  cca::controller<asked> c;
  c.load();
  c.start();
  const auto status = [&] {
    laws::told_of_request found{};
    c.observed([&](const cca::observation& one) { found = laws::told_of(one.values); });
    return found;
  };
  const auto ask = [&](double number, int beats) {
    c.get<"caller">().number = number;
    for (int k = 0; k < beats; ++k) c.step();
    return status().answer;
  };
  using enum cca::learning_call;
  CHECK(ask(cca::status_of(learn), 50) == cca::learning_answer::impossible);
  CHECK(status().learning == cca::learning::idle);
  CHECK(ask(cca::status_of(batch), 50) == cca::learning_answer::no_examples);
  CHECK(ask(cca::status_of(collect), 200) == cca::learning_answer::accepted);
  CHECK(c.get<"movement">().learning.example_count() == 200);
  CHECK(ask(7, 3) == cca::learning_answer::unknown);
  CHECK(ask(std::nan(""), 3) == cca::learning_answer::unknown);
  CHECK(status().learning == cca::learning::collecting);
  CHECK(ask(cca::status_of(forget), 1) == cca::learning_answer::not_now);
  CHECK(ask(cca::status_of(cca::learning_call::rest), 1) == cca::learning_answer::accepted);
  CHECK(ask(cca::status_of(forget), 1) == cca::learning_answer::accepted);
  CHECK(c.get<"movement">().learning.example_count() == 0);
}

TEST_CASE("where the request comes from another mode or another environment, the batch is computed too") {
  cca::controller<in_modes> modes;
  check_that_it_learns(modes);
  cca::deployed<apart> environments;
  check_that_it_learns(environments);
}
