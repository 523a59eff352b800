// A sequence by itself: conditions, hold times, timeouts. No controller: the observations are an array.
#include <array>

#include <cca/adaptive/sequencer.hpp>

#include "rig.hpp"

namespace {

// The observations of two ports with two axes.
struct told {
  std::array<double, 2> a{}, b{};
  std::array<cca::observation, 2> all() const { return {{{"s.a", a, 0, true}, {"s.b", b, 0, true}}}; }
};

template <class Plan, class Told = told>
struct running {
  cca::sequence<Plan> s;
  Told now;
  std::int64_t k = 0;

  std::string_view step(int beats = 1) {
    for (int i = 0; i < beats; ++i, ++k) s.update(motor_test::at(k), now.all());
    return s.name();
  }
};

struct conditions : cca::steps<cca::step<"low", cca::then<"first">>,
                               cca::step<"first", cca::below<"s.a", 1.0>>,
                               cca::step<"second", cca::above<"s.a", 2.0>>,
                               cca::step<"third", cca::is<"s.b", 3, 1>>,
                               cca::step<"fourth", cca::any<cca::is<"s.b", 4>, cca::is<"s.b", 5>>>,
                               cca::step<"fifth", cca::all<cca::is<"s.b", 6>, cca::is<"s.b", 7, 1>>>,
                               cca::step<"sixth", cca::no<cca::is<"s.b", 6>>>,
                               cca::step<"last">> {};

struct on_end : cca::steps<cca::step<"wait">,
                           cca::step<"held", cca::above<"s.a", 0.0>, cca::held_for<3>>,
                           cca::step<"held again", cca::above<"s.a", 0.0>, cca::held_for<3>>> {};

struct too_long
    : cca::steps<cca::step<"try">,
                 cca::step<"done", cca::above<"s.a", 0.0>, cca::or_after<5, "again">, cca::then<"done2">>,
                 cca::step<"again", cca::after<2>, cca::then<"done">>,
                 cca::step<"done2", cca::after<3>>> {};

}  // namespace

TEST_CASE("each condition does what its name says, on the named axis") {
  running<conditions> r;
  r.now = {{1, 9}, {0, 0}};
  CHECK_EQ(r.step(3), "low");  // 1 is not below 1
  r.now.a = {0.5, 9};
  CHECK_EQ(r.step(), "first");
  CHECK_EQ(r.step(2), "first");
  r.now.a = {2, 9};
  CHECK_EQ(r.step(2), "first");  // 2 is not above 2
  r.now.a = {2.5, 0};
  CHECK_EQ(r.step(), "second");
  r.now.b = {3, 0};
  CHECK_EQ(r.step(2), "second");  // the other axis
  r.now.b = {0, 3};
  CHECK_EQ(r.step(), "third");
  CHECK_EQ(r.step(), "third");
  r.now.b = {5, 0};
  CHECK_EQ(r.step(), "fourth");
  r.now.b = {6, 0};
  CHECK_EQ(r.step(2), "fourth");  // only one of the two holds
  r.now.b = {6, 7};
  CHECK_EQ(r.step(), "fifth");
  CHECK_EQ(r.step(2), "fifth");
  r.now.b = {0, 7};
  CHECK_EQ(r.step(), "sixth");
  CHECK(!r.s.finished());
  CHECK_EQ(r.step(), "last");  // a step without a condition starts at once
  CHECK(r.s.finished());
  CHECK_EQ(r.step(10), "last");
  CHECK(!r.s.unheard());
  CHECK(r.s.in<"last">());
  CHECK(!r.s.in<"low">());
}

TEST_CASE("a number that is NaN fulfils no comparison, ends the hold, and is not kept") {
  struct plan
      : cca::steps<cca::step<"rest">,
                   cca::step<"high", cca::above<"s.a", 2.0>, cca::held_for<3>, cca::or_after<9, "rest">>,
                   cca::step<"not_low", cca::no<cca::below<"s.a", 1.0>>>> {};
  running<plan> r;
  const double none = std::numeric_limits<double>::quiet_NaN();
  r.now.a = {3, 0};
  CHECK_EQ(r.step(3), "rest");
  r.now.a = {none, 0};
  CHECK_EQ(r.step(), "rest");  // the hold of three beats ends here
  r.now.a = {3, 0};
  CHECK_EQ(r.step(3), "rest");
  CHECK_EQ(r.step(), "high");
  r.now.a = {0, 0};
  CHECK_EQ(r.step(3), "high");
  r.now.a = {none, 0};
  CHECK_EQ(r.step(), "not_low");  // `no` holds, since `below` does not
  r = {};
  r.now.a = {none, 0};
  CHECK_EQ(r.step(9), "rest");
  CHECK(!r.s.timed_out());
  CHECK_EQ(r.step(), "rest");
  CHECK(r.s.timed_out());  // timeouts go on
  r.now.a = {cca::infinity, 0};
  CHECK_EQ(r.step(3), "rest");
  CHECK_EQ(r.step(), "high");
}

TEST_CASE("a condition must hold without a break, and again for the next step") {
  running<on_end> r;
  CHECK_EQ(r.s.beats(motor_test::at(7)), 0);  // no step has begun
  r.now.a = {1, 0};
  CHECK_EQ(r.step(3), "wait");
  r.now.a = {0, 0};
  CHECK_EQ(r.step(), "wait");
  r.now.a = {1, 0};
  CHECK_EQ(r.step(3), "wait");
  CHECK_EQ(r.step(), "held");
  CHECK_EQ(r.s.beats(motor_test::at(r.k + 4)), 5);
  CHECK_EQ(r.step(3), "held");  // the time for the step before does not count
  CHECK_EQ(r.step(), "held again");
}

TEST_CASE(
    "a timeout leads to its step, counted from the start of the running step, but a condition in time does "
    "not") {
  running<too_long> r;
  r.k = 100;  // it may begin in any beat
  CHECK_EQ(r.step(5), "try");
  CHECK_EQ(r.step(), "again");
  CHECK(r.s.timed_out());
  CHECK_EQ(r.step(), "again");
  CHECK_EQ(r.step(4), "again");  // the second time too: five beats from here
  CHECK_EQ(r.s.beats(motor_test::at(r.k)), 1);
  r.now.a = {1, 0};
  CHECK_EQ(r.step(), "done");
  CHECK(!r.s.timed_out());
  CHECK_EQ(r.step(2), "done");
  CHECK_EQ(r.step(), "done2");
  CHECK(r.s.finished());
}

TEST_CASE("more paths than it remembers are still found") {
  struct several
      : cca::steps<
            cca::step<"first">,
            cca::step<"second",
                      cca::any<cca::is<"p00", 1>, cca::is<"p01", 1>, cca::is<"p02", 1>, cca::is<"p03", 1>,
                               cca::is<"p04", 1>, cca::is<"p05", 1>, cca::is<"p06", 1>, cca::is<"p07", 1>,
                               cca::is<"p08", 1>, cca::is<"p09", 1>, cca::is<"p10", 1>, cca::is<"p11", 1>,
                               cca::is<"p12", 1>, cca::is<"p13", 1>, cca::is<"p14", 1>, cca::is<"p15", 1>,
                               cca::is<"p16", 1>, cca::is<"p17", 1>, cca::is<"p18", 1>, cca::is<"p19", 1>,
                               cca::is<"p20", 1>, cca::is<"p21", 1>, cca::is<"p22", 1>, cca::is<"p23", 1>,
                               cca::is<"p24", 1>, cca::is<"p25", 1>, cca::is<"p26", 1>, cca::is<"p27", 1>,
                               cca::is<"p28", 1>, cca::is<"p29", 1>, cca::is<"p30", 1>, cca::is<"p31", 1>,
                               cca::is<"p32", 1>, cca::is<"p33", 1>>>> {};
  std::array<std::string, 34> names;
  std::array<double, 34> values{};
  std::vector<cca::observation> all;
  for (std::size_t i = 0; i < 34; ++i) {
    names[i] = {'p', static_cast<char>('0' + i / 10), static_cast<char>('0' + i % 10)};
    all.push_back({names[i], std::span<const double>(&values[i], 1), 0, true});
  }
  cca::sequence<several> s;
  for (int k = 0; k < 5; ++k) s.update(motor_test::at(k), all);
  CHECK(s.in<"first">());
  CHECK(!s.unheard());
  values[33] = 1;
  s.update(motor_test::at(5), all);
  CHECK(s.in<"second">());
}

TEST_CASE("what has not been published yet is no zero: only `no` of a comparison holds") {
  struct waits
      : cca::steps<cca::step<"wait">, cca::step<"low", cca::any<cca::below<"s.a", 1>, cca::is<"s.a", 0>>>,
                   cca::step<"high", cca::above<"s.a", -1>>> {};
  struct told_nothing {
    std::array<double, 2> a{}, b{};
    std::int64_t origin = cca::never;
    std::array<cca::observation, 2> all() const {
      return {{{"s.a", a, origin, false}, {"s.b", b, origin, false}}};
    }
  };
  running<waits, told_nothing> r;
  CHECK_EQ(r.step(3), "wait");
  CHECK(!r.s.unheard());
  r.now.origin = 0;
  CHECK_EQ(r.step(), "low");
  CHECK_EQ(r.step(), "high");
  struct unless : cca::steps<cca::step<"wait">, cca::step<"go", cca::no<cca::is<"s.a", 0>>>> {};
  running<unless, told_nothing> other;
  CHECK_EQ(other.step(), "go");
}

TEST_CASE("a condition on a path that nobody publishes never holds, and is reported") {
  struct deaf : cca::steps<cca::step<"first">, cca::step<"second", cca::is<"s.c", 0>>> {};
  running<deaf> r;
  CHECK(!r.s.unheard());
  CHECK_EQ(r.step(3), "first");  // a missing value does not count as zero
  CHECK(r.s.unheard());
}

namespace {

struct two_steps
    : cca::steps<cca::step<"first">, cca::step<"second", cca::after<4>, cca::or_after<9, "first">>> {};
struct late : cca::steps<cca::step<"first">,
                         cca::step<"second", cca::is<"somebody.status", 1>, cca::or_after<3, "third">>,
                         cca::step<"third", cca::after<1000>>> {};
struct somebody {
  auto process(cca::beat) -> cca::out<"status", cca::ode_status_port> { return 0.0; }
};
struct ear {
  double step = -1, running = -1, timed_out = -1;
  cca::component_status status{};
  void process(cca::in<"step", cca::step_port> a,
               cca::in<"running", cca::step_time> b,
               cca::in<"timed_out", cca::step_flag> c,
               cca::in<"status", cca::component_status_port> d) {
    step = a.vector()[0], running = b.vector()[0], timed_out = c.vector()[0],
    status = d.as<cca::component_status>();
  }
};
template <class Plan>
struct heard : cca::graph<cca::rate<500>,
                          cca::node<"somebody", somebody>,
                          cca::node<"sequencer", cca::sequencer<"*.status.*", Plan>, cca::timed<1>>,
                          cca::node<"ear", ear>,
                          cca::wire<"sequencer.step", "ear.step">,
                          cca::wire<"sequencer.running", "ear.running">,
                          cca::wire<"sequencer.timed_out", "ear.timed_out">,
                          cca::wire<"sequencer.status", "ear.status">> {};

}  // namespace

TEST_CASE("a sequencer publishes its step, its running time, and whether it began by a timeout") {
  cca::controller<heard<two_steps>> c;
  c.load();
  c.start();
  auto& e = c.get<"ear">();
  c.run(cca::for_beats<4>{});
  CHECK_EQ(e.step, 0);
  CHECK_EQ(e.running, doctest::Approx(0.006));  // three beats of 2 ms
  CHECK(e.status == cca::component_status::converging);
  c.run(cca::for_beats<3>{});
  CHECK_EQ(e.step, 1);
  CHECK_EQ(e.running, doctest::Approx(0.004));
  CHECK_EQ(e.timed_out, 0);
  CHECK(e.status == cca::component_status::reached);
  c.stop();
  c.start();
  c.step();
  CHECK_EQ(e.step, 0);  // a start begins with the first step
  cca::controller<heard<late>> d;
  d.load();
  d.start();
  d.run(cca::for_beats<4>{});
  CHECK_EQ(d.get<"ear">().step, 2);
  CHECK_EQ(d.get<"ear">().timed_out, 1);
}
