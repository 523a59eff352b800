// Hold, decimate and interpolate lead from one rate to another.
#include <doctest/doctest.h>

#include <cmath>
#include <string_view>

#include "../picture.hpp"
#include "by_hand.hpp"

namespace {

using namespace skeleton_test;

struct room : cca::frame<"room"> {};
template <class Domain, int Hz, class... Axes>
struct at : cca::space<Domain, cca::axes<Axes...>, cca::rate<Hz>> {};

// [rates]
struct goal_100 : cca::space<cca::number, cca::axes<cca::x>, cca::rate<100>> {};
struct goal_1000 : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};

struct planner {  // at 100 Hz
  double at = 0;
  auto process(cca::beat) -> cca::out<"goal", goal_100> { return at += 1; }
};

struct up_and_down : cca::graph<cca::node<"planner", planner, cca::timed<10>>,
                                cca::node<"steps", cca::hold<goal_100, goal_1000>, cca::timed<1>>,
                                cca::node<"ramps", cca::interpolate<goal_100, goal_1000>, cca::timed<1>>,
                                cca::node<"slow", cca::decimate<goal_1000, goal_100>>,
                                cca::node<"mean", cca::decimate<goal_1000, goal_100, cca::averaged>>,
                                cca::wire<"planner.goal", "steps.input", cca::latest>,
                                cca::wire<"planner.goal", "ramps.input", cca::latest>,
                                cca::wire<"ramps.output", "slow.input">,
                                cca::wire<"ramps.output", "mean.input">,
                                cca::node<"s", listener<goal_1000>>,
                                cca::wire<"steps.output", "s.x">,
                                cca::node<"r", listener<goal_1000>>,
                                cca::wire<"ramps.output", "r.x">,
                                cca::node<"p", listener<goal_100>>,
                                cca::wire<"slow.output", "p.x">,
                                cca::node<"m", listener<goal_100>>,
                                cca::wire<"mean.output", "m.x">> {};
// [rates end]

// A strategy with another rate than To's is refused.
struct slow_hold : cca::graph<cca::rate<1000>,
                              cca::node<"planner", planner, cca::timed<10>>,
                              cca::node<"steps", cca::hold<goal_100, goal_1000>>,
                              cca::wire<"planner.goal", "steps.input">> {};
static_assert(cca::well_formed<up_and_down>);
static_assert(cca::diagnosis<slow_hold>.rule == "rate.mismatch");
static_assert(cca::diagnosis<slow_hold>.where == "steps.output");

template <class From, class To>
struct interpolating : cca::graph<cca::rate<1000>,
                                  cca::node<"a", by_hand<From>>,
                                  cca::node<"up", cca::interpolate<From, To>, cca::timed<1>>,
                                  cca::node<"b", listener<To>>,
                                  cca::wire<"a.y", "up.input">,
                                  cca::wire<"up.output", "b.x">> {};

template <class Space>
struct freezing : cca::graph<cca::rate<1000>,
                             cca::node<"a", by_hand<Space>>,
                             cca::node<"stop", by_hand<cca::flag>>,
                             cca::node<"hold", cca::hold<Space>>,
                             cca::node<"b", listener<Space>>,
                             cca::wire<"a.y", "hold.input">,
                             cca::wire<"stop.y", "hold.freeze">,
                             cca::wire<"hold.output", "b.x">> {};

// Reads its own output: the sample keeps its origin.
template <class Skeleton>
struct in_a_loop : cca::graph<cca::rate<1000>,
                              cca::node<"a", Skeleton, cca::timed<1>>,
                              cca::node<"back", cca::hold<goal_1000>>,
                              cca::node<"b", listener<goal_1000>>,
                              cca::wire<"a.output", "back.input">,
                              cca::wire<"back.output", "a.input", cca::delayed<3>>,
                              cca::wire<"a.output", "b.x">> {};

struct slower_in_a_loop : cca::graph<cca::rate<1000>,
                                     cca::node<"a", cca::decimate<goal_1000, goal_100>>,
                                     cca::node<"up", cca::hold<goal_100, goal_1000>, cca::timed<1>>,
                                     cca::node<"b", listener<goal_100>>,
                                     cca::wire<"a.output", "up.input">,
                                     cca::wire<"up.output", "a.input", cca::delayed<1>>,
                                     cca::wire<"a.output", "b.x">> {};

constexpr std::string_view picture_of_rates = R"(// [rates picture]
flowchart LR
  n0["planner<br/><i>100 Hz</i>"]
  n1["steps<br/><i>1000 Hz</i>"]
  n2["ramps<br/><i>1000 Hz</i>"]
  n3["slow<br/><i>1000 Hz</i>"]
  n4["mean<br/><i>1000 Hz</i>"]
  n5["s<br/><i>1000 Hz</i>"]
  n6["r<br/><i>1000 Hz</i>"]
  n7["p<br/><i>restless</i>"]
  n8["m<br/><i>restless</i>"]
  n0 -- "goal → input<br/>goal_100, 100 Hz" --> n1
  n0 -- "goal → input<br/>goal_100, 100 Hz" --> n2
  n2 -- "output → input<br/>goal_1000, 1000 Hz" --> n3
  n2 -- "output → input<br/>goal_1000, 1000 Hz" --> n4
  n1 -- "output → x<br/>goal_1000, 1000 Hz" --> n5
  n2 -- "output → x<br/>goal_1000, 1000 Hz" --> n6
  n3 -- "output → x<br/>goal_100" --> n7
  n4 -- "output → x<br/>goal_100" --> n8
)";  // [rates picture end]

}  // namespace

TEST_SUITE("rates") {
  TEST_CASE("the picture") { test::check_picture<up_and_down>(picture_of_rates); }

  TEST_CASE("to a faster rate and back") {
    auto c = started<up_and_down>();
    CHECK_EQ(c.period(), 1'000'000);
    c.run(cca::for_beats<100>{});
    const auto &steps = c.get<"s">().all, &ramps = c.get<"r">().all;
    const auto &slow = c.get<"p">().all, &mean = c.get<"m">().all;
    REQUIRE_EQ(steps.size(), 100);
    REQUIRE_EQ(ramps.size(), 100);
    for (int k = 0; k < 100; ++k) {
      const auto at = static_cast<std::size_t>(k);
      CHECK_EQ(steps[at].sample.vector()[0], 1 + k / 10);
      CHECK_EQ(steps[at].sample.origin(), k / 10 * 10 * c.period());
      const double ramp = k < 10 ? 1 : k / 10 + 0.1 * (k % 10 + 1);  // 2 in beat 19
      CHECK(ramps[at].sample.vector()[0] == doctest::Approx(ramp).epsilon(1e-14));
      CHECK_EQ(ramps[at].sample.origin(), (k < 10 ? 0 : k % 10 == 9 ? k / 10 : k / 10 - 1) * 10 * c.period());
    }
    REQUIRE_EQ(slow.size(), 10);
    REQUIRE_EQ(mean.size(), 10);
    for (std::size_t i = 0; i < 10; ++i) {
      CHECK_EQ(slow[i].beat, 10 * i);
      CHECK_EQ(slow[i].sample.vector()[0], ramps[10 * i].sample.vector()[0]);
      CHECK_EQ(slow[i].sample.origin(), ramps[10 * i].sample.origin());
      double sum = 0;
      for (std::size_t j = 0; j < 10; ++j) sum += ramps[10 * i + j].sample.vector()[0];
      CHECK_EQ(mean[i].beat, 10 * i + 9);
      CHECK(mean[i].sample.vector()[0] == doctest::Approx(sum / 10).epsilon(1e-13));
      CHECK_EQ(mean[i].sample.origin(), ramps[10 * i].sample.origin());  // the oldest
    }
  }

  TEST_CASE("late and early samples") {
    auto c = started<interpolating<goal_100, goal_1000>>();
    auto& a = c.get<"a">();
    const auto output_after_step = [&](double x) {
      a.publishes = x >= 0;
      if (a.publishes) a.now = number<goal_100>(x);
      c.step();
      return c.get<"b">().last.vector()[0];
    };
    CHECK_EQ(output_after_step(-1), 0);
    CHECK_EQ(output_after_step(5), 5);
    for (int i = 0; i < 15; ++i) CHECK_EQ(output_after_step(-1), 5);
    CHECK(output_after_step(6) == doctest::Approx(5.1));
    for (int i = 2; i <= 5; ++i) CHECK(output_after_step(-1) == doctest::Approx(5 + 0.1 * i));
    CHECK(output_after_step(3.5) == doctest::Approx(5.3));  // early: from the current value
    for (int i = 2; i <= 10; ++i) CHECK(output_after_step(-1) == doctest::Approx(5.5 - 0.2 * i));
    for (int i = 0; i < 15; ++i) CHECK_EQ(output_after_step(-1), 3.5);
  }

  TEST_CASE("on a circle and between orientations") {
    auto c = started<interpolating<at<cca::phase, 100, cca::x>, at<cca::phase, 1000, cca::x>>>();
    auto& a = c.get<"a">();
    a.now = number<at<cca::phase, 100, cca::x>>(6.2);
    c.step();
    a.now = number<at<cca::phase, 100, cca::x>>(0.2);
    c.step();
    a.publishes = false;
    for (int i = 2; i <= 5; ++i) c.step();
    CHECK(cca::wrap_signed(c.get<"b">().last.vector()[0] - 6.2 - 0.5 * (0.2 + 2 * cca::pi - 6.2)) ==
          doctest::Approx(0));
    using slow = at<cca::orientation<room>, 100, cca::x, cca::y, cca::z>;
    auto o = started<interpolating<slow, at<cca::orientation<room>, 1000, cca::x, cca::y, cca::z>>>();
    o.step();
    o.get<"a">().now = cca::sample<slow>::about({0, 1, 0}, 1);
    o.step();
    o.get<"a">().publishes = false;
    o.step();
    CHECK(o.get<"b">().last.pitch() == doctest::Approx(0.2));
  }

  TEST_CASE("in a loop a sample keeps its origin") {
    auto c = started<in_a_loop<cca::hold<goal_1000>>>();
    for (int k = 0; k < 12; ++k) {
      c.step();
      CHECK_EQ(c.get<"b">().last.origin(), k % 3 * c.period());
    }
    auto d = started<slower_in_a_loop>();
    for (int k = 0; k < 60; ++k) d.step();
    for (const auto& arrived : d.get<"b">().all)
      CHECK_EQ(arrived.sample.origin(), 0);  // the origin of the first beat, in every round
    CHECK(d.get<"b">().all.size() > 3);
  }

  TEST_CASE("a restart begins again") {
    auto c = started<up_and_down>();
    c.run(cca::for_beats<23>{});
    c.stop();
    c.start();
    c.get<"r">().all.clear(), c.get<"p">().all.clear(), c.get<"m">().all.clear();
    for (int k = 23; k < 60; ++k) c.step();
    const auto& ramps = c.get<"r">().all;
    CHECK_EQ(ramps[0].sample.vector()[0],
             c.get<"planner">().at - 3);  // the ramp from before the restart is over
    CHECK_EQ(ramps[7].sample.vector()[0],
             c.get<"planner">().at - 2);  // the first new sample is taken at once
    CHECK_EQ(c.get<"p">().all[0].beat, 23);
    CHECK_EQ(c.get<"p">().all[1].beat, 33);
    CHECK_EQ(c.get<"m">().all[0].beat, 32);
    auto f = started<freezing<goal_1000>>();
    f.get<"a">().now = number<goal_1000>(1);
    f.step();
    f.stop();
    f.start();
    f.get<"a">().now = number<goal_1000>(2);
    f.get<"stop">().now = number<cca::flag>(1);
    f.step();
    CHECK_EQ(f.get<"b">().last.vector()[0], 2);  // it forgot the held sample
  }

  TEST_CASE("hold can be frozen") {
    auto c = started<freezing<goal_1000>>();
    auto& a = c.get<"a">();
    auto& stop = c.get<"stop">();
    const auto output_after_step = [&](double x, double freeze) {
      a.now = number<goal_1000>(x);
      stop.now = number<cca::flag>(freeze);
      c.step();
      return c.get<"b">().last.vector()[0];
    };
    CHECK_EQ(output_after_step(1, 1), 1);  // there is no sample to hold yet
    CHECK_EQ(output_after_step(2, 1), 1);
    CHECK_EQ(c.get<"b">().last.origin(), 0);
    CHECK_EQ(output_after_step(3, 0), 3);
    CHECK_EQ(output_after_step(4, 0), 4);
    CHECK_EQ(output_after_step(5, -1), 4);
    CHECK_EQ(c.get<"b">().last.origin(), 3 * c.period());
    CHECK_EQ(output_after_step(6, 0), 6);
  }
}
