// A beat allocates nothing: not with queues, delays, strategies decided at run time, observers, a limiter, a
// watchdog or a fault.
#include <doctest/doctest.h>

#include <cstddef>

#include <cca/runtime/live/live_access.hpp>

#include "counting.hpp"

namespace laws {
std::size_t allocations();
}

using namespace core_test;

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::velocity{-3, 3}};
};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

struct now_and_then {
  auto process(cca::beat now) -> cca::maybe<"y", reading> {
    if (silent || now.index() % 3 == 0) return {};
    return static_cast<double>(now.index());
  }
  bool silent = false;
};
struct last {
  void process(cca::in<"x", reading> x) { value = x[cca::x{}]; }
  double value = 0;
};
struct listener {
  void process(cca::observe<"inner.**"> all) {
    for (const auto& one : all) sum += one.values[0];
  }
  double sum = 0;
};
struct swing {
  auto process(cca::in<"x", reading> x) -> cca::out<"angle", hip_angle> { return x[cca::x{}]; }
};
struct joint {
  auto sense() -> cca::out<"angle", hip_angle> { return angle; }
  void act(cca::in<"command", hip_angle> to) { angle = to[hip{}]; }
  void on_fault() { angle = 0; }
  double angle = 0;
};
struct inner : cca::graph<cca::node<"sum", adder>,
                          cca::node<"late", adder>,
                          cca::wire<"sum.y", "late.x", cca::delayed<3>>,
                          cca::expose<"sum.x", "x">,
                          cca::expose<"late.y", "y">> {};
struct all : cca::graph<cca::rate<1000>,
                        cca::node<"source", now_and_then>,
                        cca::node<"inner", inner>,
                        cca::node<"queued", last, cca::stoppable<cca::timed<2>>>,
                        cca::node<"patient", last, cca::any_of<cca::coordinated, cca::timeout<7>>>,
                        cca::node<"listener", listener>,
                        cca::node<"swing", swing>,
                        cca::node<"watchdog", cca::watchdog<hip_angle, 5>>,
                        cca::node<"limits", cca::limiter<hip_angle>>,
                        cca::node<"joint", joint>,
                        cca::wire<"source.y", "inner.x">,
                        cca::wire<"source.y", "queued.x", cca::queue<3, cca::drop_oldest>>,
                        cca::wire<"inner.y", "patient.x">,
                        cca::wire<"inner.y", "swing.x">,
                        cca::wire<"swing.angle", "watchdog.command">,
                        cca::wire<"watchdog.fresh", "limits.command">,
                        cca::wire<"joint.angle", "limits.measured">,
                        cca::wire<"limits.safe", "joint.command">,
                        cca::observe<"inner.**">> {};

}  // namespace

TEST_SUITE("allocations") {
  TEST_CASE("the counter counts") {
    const auto before = laws::allocations();
    delete new int(3);
    CHECK_GE(laws::allocations(), before);  // a compiler may drop an unused new
    std::string* text = new std::string(100, 'x');
    CHECK_GT(laws::allocations(), before);
    delete text;
  }

  TEST_CASE("neither a beat nor a copy nor a fault allocates") {
    auto c = started<all>();
    const auto before = laws::allocations();
    for (int i = 0; i < 1000; ++i) c.step();
    c.run(cca::for_beats<1000>{});
    auto copy = c;
    copy.get<"source">().silent = true;
    for (int i = 0; i < 20; ++i) copy.step();
    const auto after = laws::allocations();
    CHECK_EQ(after, before);
    CHECK_EQ(copy.state(), cca::state::faulted);  // no sample for five beats
    CHECK_EQ(copy.get<"joint">().angle, 0);
    CHECK_GT(c.get<"listener">().sum, 0);
    CHECK_EQ(c.state(), cca::state::started);
  }

  TEST_CASE("a beat that other threads look at does not allocate, nor does it when it takes a request") {
    auto c = started<all>();
    cca::live_access live(c);
    CHECK(live.stop("queued"));
    const auto before = laws::allocations();
    c.run(cca::for_beats<100>{}, cca::as_fast_as_possible{}, live);
    CHECK_EQ(laws::allocations(), before);
    CHECK(c.is_stopped<"queued">());
    CHECK(live.newest("inner.late.y"));
  }
}
