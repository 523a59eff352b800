// A hidden Markov model as an adaptive module: it learns from several demonstrations, knows by the position
// which part of the movement is running, and waits where it is held.
#include <chrono>
#include <thread>
#include <vector>

#include <cca/adaptive/learning/timed_requests.hpp>
#include <cca/motor/modules/gmr_module.hpp>
#include <cca/motor/modules/hmm_module.hpp>

#include "../../laws/module_laws.hpp"
#include "../../laws/request_laws.hpp"
#include "../motor/rig.hpp"

using namespace motor_test;

namespace {

using laws::shown;
using v2 = Eigen::Vector2d;

struct ankle : cca::dimension<"ankle"> {};
struct other_leg : cca::space<cca::joint_angles, cca::axes<hip, ankle>> {};
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
const v2 centre(0.1, -0.8);

// A movement of 2 s that comes to rest.
v2 path(double s) { return centre + v2(0.5 * s, 0.2 * std::sin(3 * s)); }
v2 movement(double t) {
  const double left = 1 - std::min(t / 2, 1.0);
  return path(1 - left * left * left);
}
// How far a point is from the path.
double beside(const v2& y) {
  double least = 1e9;
  for (int i = 0; i <= 1000; ++i) least = std::min(least, (path(1e-3 * i) - y).norm());
  return least;
}

struct hmm_case {
  using module = cca::hmm_module<leg, 12>;
  using other_size = cca::hmm_module<leg, 11>;
  using other_space = cca::hmm_module<other_leg, 12>;
  static constexpr int lesson = 2000;
  static constexpr double bound = 0.03;  // rad, beside the path and at its end; the movement is 0.5 rad wide
  template <class Module>
  static auto process(Module& m,
                      int k,
                      const v2& reference,
                      shown what,
                      cca::learning_call call = cca::learning_call::nothing,
                      const v2* measured = nullptr) {
    using space = typename Module::demonstrated;
    cca::optional_in<"demonstration", space> showing;
    const v2 y = movement(1e-3 * k);
    if (what != shown::nothing)
      showing = wired<cca::optional_in<"demonstration", space>>(
          what == shown::demonstration ? y : v2(y[0], k % 2 ? no_number : cca::infinity));
    cca::optional_in<"feedback", space> feedback;
    if (measured) feedback = wired<cca::optional_in<"feedback", space>>(*measured);
    return m.process(given<cca::in<"reference", space>>(reference),
                     wired<cca::optional_in<"start", space>>(v2(movement(0) + reference - centre)), feedback,
                     showing, laws::request(call), at(k));
  }
  template <class Module>
  static laws::module_firing fire(Module& m, int k, shown what, cca::learning_call call) {
    const auto [command, velocity, state, ode, module] = process(m, k, centre, what, call);
    return laws::firing_of(command.vector()[0], ode[cca::ode_axis{}], module);
  }
  template <class Module>
  static double worst(Module& m) {
    m.on_start();
    double most = 0;
    v2 y = centre;
    for (int k = 0; k < 2 * lesson; ++k) {
      y = std::get<0>(process(m, k, centre, shown::nothing)).vector();
      most = std::max(most, beside(y));
    }
    return std::max(most, (y - path(1)).norm());
  }
  static void change(auto& p) { p.stiffness = 30; }
  static void hasten(module& m) { m.p.settings.iterations = 5; }
};

// It is held for a second, and let go.
template <class Command>
v2 held(Command command_at) {
  v2 measured = movement(0);
  double jump = 0;
  for (int k = 0; k < 4000; ++k) {
    const v2 command = command_at(k, measured);
    if (k == 1500) jump = (command - measured).norm();
    if (k < 500 || k >= 1500) measured += 0.2 * (command - measured);
  }
  return {jump, (measured - path(1)).norm()};
}

// [beside]
struct lesson_time : cca::space<cca::number, cca::axes<cca::x>> {};

// Shows the movement three times, each a bit different, with a second of rest after each.
struct teacher {
  auto process(cca::beat now)
      -> std::tuple<cca::maybe<"shown", leg>, cca::out<"time", lesson_time>, cca::out<"centre", leg>> {
    const double t = 1e-9 * static_cast<double>(now.time()), since = std::fmod(t, 3);
    cca::maybe<"shown", leg> shown;
    if (t < 9 && since < 2)
      shown = v2(movement(since) + 0.01 * std::sin(3 * since) * v2(0, std::floor(t / 3) - 1));
    return {shown, std::min(since, 2.0), centre};
  }
};

// A hidden Markov model, which knows by itself where it is, beside a Gaussian mixture, which needs a time.
struct school : cca::graph<cca::rate<200>,
                           cca::node<"teacher", teacher>,
                           cca::node<"lesson",
                                     cca::timed_requests<cca::request_at<0, cca::learning_call::collect>,
                                                         cca::request_at<1800, cca::learning_call::batch>>>,
                           cca::node<"hidden", cca::hmm_module<leg, 12>, cca::timed<1>>,
                           cca::node<"timed", cca::gmr_module<lesson_time, leg, 12>, cca::timed<1>>,
                           cca::wire<"lesson.learn", "hidden.learn">,
                           cca::wire<"teacher.centre", "hidden.reference">,
                           cca::wire<"teacher.shown", "hidden.demonstration">,
                           cca::wire<"lesson.learn", "timed.learn">,
                           cca::wire<"teacher.time", "timed.input">,
                           cca::wire<"teacher.centre", "timed.reference">,
                           cca::wire<"teacher.shown", "timed.demonstration">,
                           cca::observe<"*.command">> {};
// [beside end]

}  // namespace

TEST_CASE("three demonstrations in a graph: it learns them beside the loop, and so does a Gaussian mixture") {
  cca::controller<school> c;
  c.load();
  c.start();
  c.run(cca::for_beats<1801>{});
  auto& hidden = c.get<"hidden">().learning;
  auto& timed = c.get<"timed">().learning;
  CHECK(hidden.state() == cca::learning::batch);
  CHECK(hidden.example_count() == 3 * 398);  // of each the first and the last have no neighbours
  while (hidden.state() == cca::learning::batch || timed.state() == cca::learning::batch) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    c.step();
  }
  CHECK(hidden.state() == cca::learning::trained);
  CHECK(timed.state() == cca::learning::trained);
  c.stop();
  c.start();  // both begin anew
  double besides = 0;
  v2 last = centre;
  for (int k = 0; k < 800; ++k) {
    c.step();
    c.observed([&](const cca::observation& one) {
      if (one.path == "hidden.command") last = {one.values[0], one.values[1]};
    });
    besides = std::max(besides, beside(last));
  }
  MESSAGE("beside the path at most " << besides << " rad, at its end " << (last - path(1)).norm() << " rad");
  CHECK(besides < 0.03);
  CHECK((last - path(1)).norm() < 0.03);
}

TEST_CASE(
    "a hidden Markov model as a module obeys the laws of an adaptive module, and answers every request") {
  laws::adaptive_module<hmm_case>();
  laws::requests<laws::module_student<hmm_case>>();
}

TEST_CASE("what it learned moves with its reference") {
  const auto m = laws::taught<hmm_case>();
  auto other = *m;
  m->on_start();
  other.on_start();
  double off = 0;
  for (int k = 0; k < 500; ++k) {
    const v2 a = std::get<0>(hmm_case::process(*m, k, centre, shown::nothing)).vector(),
             b = std::get<0>(hmm_case::process(other, k, centre + v2(0.3, 0.2), shown::nothing)).vector();
    off = std::max(off, (b - a - v2(0.3, 0.2)).norm());
  }
  CHECK(off < 1e-9);
}

TEST_CASE("a movement that is held waits, and goes on from there - one over a time has gone on without it") {
  const auto hidden = laws::taught<hmm_case>();
  hidden->on_start();
  const v2 waited = held([&](int k, const v2& measured) -> v2 {
    return std::get<0>(
               hmm_case::process(*hidden, k, centre, shown::nothing, cca::learning_call::nothing, &measured))
        .vector();
  });
  MESSAGE("after a second the command is " << waited[0] << " rad ahead, at the end " << waited[1]
                                           << " rad off");
  CHECK(waited[0] < 0.1);
  CHECK(waited[1] < 0.03);
  cca::gmr_module<lesson_time, leg, 12> timed;
  timed.on_start();
  timed.learning.collect();
  const auto fire = [&](int k, bool is_shown) -> v2 {
    cca::optional_in<"demonstration", leg> showing;
    if (is_shown) showing = wired<cca::optional_in<"demonstration", leg>>(movement(1e-3 * k));
    return std::get<0>(
               timed.process(given<cca::in<"input", lesson_time>>(one<lesson_time>(1e-3 * std::min(k, 2000))),
                             given<cca::in<"reference", leg>>(centre), {}, showing, {}, at(k)))
        .vector();
  };
  for (int k = 0; k < 2000; ++k) (void)fire(k, true);
  timed.learning.hand_over(timed.learning.begin_batch(timed.p.settings)());
  timed.on_start();
  const v2 ran_on = held([&](int k, const v2&) { return fire(k, false); });
  MESSAGE("that over a time is " << ran_on[0] << " rad ahead");
  CHECK(ran_on[0] > 3 * waited[0]);
}

TEST_CASE("each interruption and each start begins another demonstration") {
  hmm_case::module m;
  m.on_start();
  m.learning.collect();
  const auto show = [&](int from, int to, shown what) {
    for (int k = from; k < to; ++k) (void)hmm_case::process(m, k, centre, what);
  };
  show(0, 10, shown::demonstration);
  show(10, 13, shown::nothing);
  show(13, 20, shown::demonstration);
  m.on_start();
  show(20, 26, shown::demonstration);
  std::vector<std::size_t> begins;
  const auto all = m.learning.examples();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].begins) begins.push_back(i);
  CHECK(all.size() == 8 + 5 + 4);
  CHECK(begins == std::vector<std::size_t>{0, 8, 13});
}

TEST_CASE(
    "more examples than there is room for: of a demonstration that has lost its beginning nothing is "
    "learned") {
  using rule = cca::baum_welch<cca::hidden_markov_function<leg, leg, 4>>;
  using small = cca::hmm_module<leg, 4, rule, 100>;
  const auto show = [](auto& m, int demonstration, int length) {
    for (int k = 0; k < length + 2; ++k)
      (void)hmm_case::process(m, 10 * k + demonstration, centre, shown::demonstration);
    (void)hmm_case::process(m, 0, centre, shown::nothing);
  };
  small cut;
  cut.on_start();
  cut.learning.collect();
  show(cut, 0, 48);
  show(cut, 1, 48);
  CHECK(cut.learning.example_count() == 96);
  CHECK(cut.learning.lost_examples() == 0);
  CHECK(cut.summary().empty());
  show(cut, 2, 48);  // the first has 4 examples left
  CHECK(cut.learning.example_count() == 96);
  CHECK(cut.learning.lost_examples() == 48);
  CHECK(cut.learning.examples().front().begins);
  CHECK(cut.summary() == "48 examples were lost, the oldest: it keeps 100, its template argument `Capacity`");

  small whole;
  whole.on_start();
  whole.learning.collect();
  show(whole, 1, 48);
  show(whole, 2, 48);
  const auto learned = [](small& m) {
    m.learning.hand_over(m.learning.begin_batch(m.p.settings)());
    return m.learning.get().function;
  };
  const auto of_cut = learned(cut), of_whole = learned(whole);
  CHECK(of_cut.transitions == of_whole.transitions);
  CHECK(of_cut.mixture.means == of_whole.mixture.means);
  CHECK(of_cut.mixture.priors == of_whole.mixture.priors);

  small longer;  // than there is room: what is left is all that there is
  longer.on_start();
  longer.learning.collect();
  show(longer, 0, 130);
  CHECK(longer.learning.example_count() == 100);
  CHECK(longer.learning.lost_examples() == 30);
}

TEST_CASE("a batch that is requested leaves the same demonstrations out") {
  using small = cca::hmm_module<leg, 4, cca::baum_welch<cca::hidden_markov_function<leg, leg, 4>>, 100>;
  small asked;
  asked.learning.compute_batches();
  asked.on_start();
  asked.learning.collect();
  for (int demonstration = 0; demonstration < 3; ++demonstration) {
    for (int k = 0; k < 50; ++k)
      (void)hmm_case::process(asked, 10 * k + demonstration, centre, shown::demonstration);
    (void)hmm_case::process(asked, 0, centre, shown::nothing);
  }
  auto beside = asked.learning;
  REQUIRE(asked.learning.obey(cca::learning_call::batch, asked.p.settings) == cca::learning_answer::accepted);
  for (int k = 0; k < 20000 && asked.learning.state() == cca::learning::batch; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    asked.learning.hear(cca::in<"learn", cca::learning_request>{}, asked.p.settings);
  }
  REQUIRE(asked.learning.state() == cca::learning::trained);
  beside.hand_over(beside.begin_batch(asked.p.settings)());
  CHECK(asked.learning.get().function.mixture.means == beside.get().function.mixture.means);
}
