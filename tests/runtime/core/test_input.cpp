// A test of an input: a signal that is added to what the input gets, while the graph runs.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>

namespace test_input_test {

struct arm_axis : cca::dimension<"arm"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 1.5}, cca::torque{-3.0, 3.0}};
};
struct leg_axis : cca::dimension<"leg"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.4, 0.4}, cca::torque{-3.0, 3.0}};
};
struct angles : cca::space<cca::joint_angles, cca::axes<arm_axis, leg_axis>, cca::rate<1000>> {};

struct plan {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, level));
  };
  parameters p{0.25};
  auto process(cca::beat) -> cca::out<"wanted", angles> {
    cca::out<"wanted", angles> y;
    y[arm_axis{}] = p.level, y[leg_axis{}] = -p.level;
    return y;
  }
};
struct servo {
  auto process(cca::in<"reference", angles> r, cca::beat now) -> cca::out<"seen", angles> {
    ++fired;
    origin_age = now.time() - r.origin();
    return {r.vector()};
  }
  int fired = 0;
  std::int64_t origin_age = -1;
};

struct plain : cca::graph<cca::rate<1000>,
                          cca::node<"plan", plan>,
                          cca::node<"servo", servo>,
                          cca::wire<"plan.wanted", "servo.reference">,
                          cca::observe<"servo.seen">> {};
struct tested : cca::graph<cca::rate<1000>,
                           cca::node<"plan", plan>,
                           cca::node<"servo", servo>,
                           cca::wire<"plan.wanted", "servo.reference">,
                           cca::test_input<"servo.reference">,
                           cca::observe<"servo.seen">,
                           cca::observe<"test_servo_reference.excitation">> {};

template <class Controller>
std::vector<double> seen(const Controller& c, std::string_view path = "servo.seen") {
  std::vector<double> values;
  c.observed([&](const cca::observation& one) {
    if (one.path == path && one.fresh) values.assign(one.values.begin(), one.values.end());
  });
  return values;
}

cca::controller<tested> started() {
  cca::controller<tested> c;
  c.load(), c.start();
  return c;
}
template <class Controller>
void begin(Controller& c,
           cca::test_signal signal,
           double amplitude,
           double f,
           double g,
           double seconds,
           int axis = 0) {
  auto p = c.template get<"test_servo_reference">().p;
  p.signal = signal, p.amplitude = amplitude, p.frequency = f, p.to = g, p.duration = seconds, p.axis = axis;
  p.run = p.run + 1;
  c.template set<"test_servo_reference">(p);
}

TEST_CASE("a declared test that is off changes nothing, also not the origin and the firings") {
  auto c = started();
  cca::controller<plain> other;
  other.load(), other.start();
  for (int k = 0; k < 20; ++k) {
    c.step(), other.step();
    CHECK(seen(c) == seen(other));
    CHECK(c.get<"servo">().origin_age == other.get<"servo">().origin_age);
    CHECK(c.get<"servo">().fired == other.get<"servo">().fired);
  }
  CHECK(seen(c, "test_servo_reference.excitation").empty());
}

TEST_CASE("each signal is added to one axis, has the exact phase, and ends by itself") {
  using cca::test_signal;
  for (const auto signal :
       {test_signal::step, test_signal::sine, test_signal::chirp, test_signal::linear_chirp}) {
    auto c = started();
    for (int k = 0; k < 7; ++k) c.step();
    const double f = 3, g = 40, T = 0.5;
    begin(c, signal, 0.2, f, g, T, 1);
    for (int k = 0; k < 600; ++k) {
      c.step();
      const double t = 1e-3 * k;
      const double rate = std::log(g / f) / T;
      const double turns = signal == test_signal::sine    ? f * t
                           : signal == test_signal::chirp ? f * (std::exp(rate * t) - 1) / rate
                                                          : f * t + 0.5 * (g - f) / T * t * t;
      const double expected = t >= T                        ? 0
                              : signal == test_signal::step ? 0.2
                                                            : 0.2 * std::sin(2 * cca::pi * turns);
      REQUIRE(seen(c)[0] == 0.25);
      REQUIRE(seen(c)[1] == doctest::Approx(-0.25 + expected).epsilon(1e-9));
      REQUIRE(seen(c, "test_servo_reference.excitation").size() == (t < T ? 2u : 0u));
    }
    CHECK_FALSE(c.get<"test_servo_reference">().is_running());
  }
}

TEST_CASE("a chirp between two frequencies that are equal is a sine, and one may fall") {
  CHECK(cca::test_value(cca::test_signal::chirp, 0.3, 2, 2, 1) ==
        doctest::Approx(std::sin(2 * cca::pi * 0.6)));
  const double h = 1e-6;  // the frequency is the slope of the phase
  for (const auto signal : {cca::test_signal::chirp, cca::test_signal::linear_chirp}) {
    const auto turns = [&](double t) { return cca::detail::turns_of_test(signal, t, 50, 2, 4); };
    CHECK((turns(h) - turns(0)) / h == doctest::Approx(50).epsilon(1e-4));
    CHECK((turns(4) - turns(4 - h)) / h == doctest::Approx(2).epsilon(1e-4));
  }
}

TEST_CASE("a second test is refused while one runs, its end and other parameters are not") {
  auto c = started();
  begin(c, cca::test_signal::sine, 0.1, 5, 5, 1);
  c.step();
  CHECK_THROWS_WITH_AS(begin(c, cca::test_signal::step, 0.1, 5, 5, 1),
                       doctest::Contains("a test of this input runs"), cca::refused);
  c.set("plan.level", 0.1);
  c.set("test_servo_reference.signal", "off");
  c.step();
  CHECK(seen(c)[0] == 0.1);
  begin(c, cca::test_signal::step, 0.1, 5, 5, 1);
  c.step();
  CHECK(seen(c)[0] == doctest::Approx(0.2));
}

TEST_CASE("what is no test is refused, and says why") {
  auto c = started();
  using cca::test_signal;
  const double nan = std::nan("");
  // Half the narrowest range: the leg's, 0.4.
  CHECK_THROWS_WITH_AS(begin(c, test_signal::sine, 0.41, 1, 1, 1), doctest::Contains("-0.4 to 0.4 rad"),
                       cca::refused);
  CHECK_THROWS_WITH_AS(begin(c, test_signal::sine, nan, 1, 1, 1), doctest::Contains("nan"), cca::refused);
  CHECK_THROWS_WITH_AS(begin(c, test_signal::sine, 0.1, nan, 1, 1), doctest::Contains("nan"), cca::refused);
  CHECK_THROWS_WITH_AS(begin(c, test_signal::sine, 0.1, 500, 1, 1),
                       doctest::Contains("below half its rate, 500 Hz"), cca::refused);
  CHECK_THROWS_WITH_AS(begin(c, test_signal::chirp, 0.1, 1, 501, 1), doctest::Contains("to: the input"),
                       cca::refused);
  CHECK_THROWS_AS(begin(c, test_signal::linear_chirp, 0.1, 1, nan, 1), cca::refused);
  CHECK_THROWS_AS(begin(c, test_signal::sine, 0.1, 0, 1, 1), cca::refused);
  CHECK_THROWS_AS(begin(c, test_signal::sine, 0.1, 1, 1, 0), cca::refused);
  CHECK_THROWS_AS(begin(c, test_signal::sine, 0.1, 1, 1, 1e9), cca::refused);
  CHECK_THROWS_AS(begin(c, test_signal::sine, 0.1, 1, 1, 1, 2), cca::refused);
  CHECK_THROWS_AS(begin(c, static_cast<test_signal>(9), 0.1, 1, 1, 1), cca::refused);
  c.step();
  CHECK(seen(c)[0] == 0.25);
  begin(c, test_signal::step, 0.1, 1e5, 1e5, 1);  // it has no frequency
}

TEST_CASE("no test goes on after a stop, and none begins with the start") {
  auto c = started();
  begin(c, cca::test_signal::step, 0.1, 5, 5, 100);
  c.step();
  CHECK(seen(c)[0] == doctest::Approx(0.35));
  c.stop(), c.start(), c.step();
  CHECK(seen(c)[0] == 0.25);

  cca::controller<tested> other;
  auto p = other.get<"test_servo_reference">().p;
  p.signal = cca::test_signal::step, p.amplitude = 0.1, p.run = 7;
  other.load();
  other.set<"test_servo_reference">(p);
  other.start(), other.step();
  CHECK(seen(other)[0] == 0.25);
}

// ---- faults ----

struct may_fault {
  auto process(cca::beat) -> cca::fault {
    if (fails) return "hot";
    return {};
  }
  bool fails = false;
};
struct faulting : cca::graph<cca::rate<1000>,
                             cca::node<"plan", plan>,
                             cca::node<"servo", servo>,
                             cca::node<"motor", may_fault>,
                             cca::wire<"plan.wanted", "servo.reference">,
                             cca::test_input<"servo.reference">,
                             cca::observe<"servo.seen">> {};

TEST_CASE("no test goes on after a fault") {
  cca::controller<faulting> c;
  c.load(), c.start();
  begin(c, cca::test_signal::step, 0.1, 5, 5, 100);
  c.step();
  CHECK(seen(c)[0] == doctest::Approx(0.35));
  c.get<"motor">().fails = true;
  c.step();
  c.get<"motor">().fails = false;
  c.resume(), c.step();
  CHECK(seen(c)[0] == 0.25);
}

// ---- wires of all kinds ----

struct late : cca::graph<cca::rate<1000>,
                         cca::node<"plan", plan, cca::timed<1>>,
                         cca::node<"servo", servo>,
                         cca::wire<"plan.wanted", "servo.reference", cca::delayed<3>, cca::initial<0.125>>,
                         cca::observe<"servo.seen">> {};
struct late_tested
    : cca::graph<cca::rate<1000>,
                 cca::node<"plan", plan, cca::timed<1>>,
                 cca::node<"servo", servo>,
                 cca::wire<"plan.wanted", "servo.reference", cca::delayed<3>, cca::initial<0.125>>,
                 cca::test_input<"servo.reference", cca::up_to<0.25>>,
                 cca::observe<"servo.seen">> {};
struct inner : cca::graph<cca::node<"servo", servo>,
                          cca::expose<"servo.reference", "reference">,
                          cca::expose<"servo.seen", "seen">,
                          cca::test_input<"servo.reference", cca::up_to<0.25>>> {};
struct outer : cca::graph<cca::rate<1000>,
                          cca::node<"plan", plan>,
                          cca::node<"leg", inner>,
                          cca::wire<"plan.wanted", "leg.reference">,
                          cca::observe<"leg.servo.seen">> {};

TEST_CASE("a delay and an initial value stay as they are") {
  cca::controller<late> a;
  cca::controller<late_tested> b;
  a.load(), a.start(), b.load(), b.start();
  for (int k = 0; k < 10; ++k) {
    a.step(), b.step();
    CHECK(seen(a) == seen(b));
    CHECK(a.get<"servo">().fired == b.get<"servo">().fired);
    CHECK(a.get<"servo">().origin_age == b.get<"servo">().origin_age);
  }
  CHECK_THROWS_WITH_AS(begin(b, cca::test_signal::step, 0.26, 1, 1, 1),
                       doctest::Contains("-0.25 to 0.25 rad"), cca::refused);
}

TEST_CASE("an input of an inner graph that is exposed") {
  cca::controller<outer> c;
  c.load(), c.start();
  c.step();
  CHECK(seen(c, "leg.servo.seen")[0] == 0.25);
  auto p = c.get<"leg.test_servo_reference">().p;
  p.signal = cca::test_signal::step, p.amplitude = 0.25, p.run = 1;
  c.set<"leg.test_servo_reference">(p);
  c.step();
  CHECK(seen(c, "leg.servo.seen")[0] == 0.5);
}

}  // namespace test_input_test
