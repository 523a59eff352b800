// A plan whose steps name the parts that they need: the others of those that it names are stopped. With the
// sequencer, with the one that learns, and with a component that holds a sequence itself.
#include <doctest/doctest.h>

#include <tuple>
#include <vector>

#include <cca/adaptive/choice/learned_sequencer.hpp>
#include <cca/adaptive/sequencer.hpp>
#include <cca/cca.hpp>

namespace {

struct reading : cca::space<cca::number, cca::axes<cca::x>> {};
struct counting {
  auto process() -> cca::out<"y", reading> { return ++fired; }
  void on_start() { ++starts; }
  void on_stop() { ++stops; }
  double fired = 0;
  int starts = 0, stops = 0;
};
struct skill : cca::graph<cca::node<"a", counting>, cca::node<"b", counting, cca::timed<2>>> {};
struct told {
  auto process() -> cca::out<"status", reading> { return 0; }
};

struct plan : cca::steps<cca::step<"walk", cca::needs<"walk", "balance">>,
                         cca::step<"stand", cca::after<10>, cca::needs<"balance">>,
                         cca::step<"reach", cca::after<10>, cca::needs<"reach", "balance">>,
                         cca::step<"rest", cca::after<10>>> {};
struct plain_plan : cca::steps<cca::step<"walk">, cca::step<"stand", cca::after<10>>> {};
// A plan that names no part asks for nothing: its sequencer returns what it did.
static_assert(
    std::is_same_v<
        cca::detail::function_facts<decltype(&cca::sequencer<"*.status.*", plain_plan>::process)>::result,
        std::tuple<cca::out<"step", cca::step_port>,
                   cca::out<"running", cca::step_time>,
                   cca::out<"timed_out", cca::step_flag>,
                   cca::out<"status", cca::component_status_port>,
                   cca::fault>>);

// [own sequence]
struct own_sequencer {
  auto process(cca::beat now) -> decltype(plan::asks(0)) {
    steps.update(now);
    return steps.asks();
  }
  void on_start() { steps = {}; }
  cca::sequence<plan> steps;
};
// [own sequence end]

// [needs]
template <class Sequencer>
struct skilled : cca::graph<cca::rate<1000>,
                            cca::node<"sequencer", Sequencer, cca::timed<1>>,
                            cca::node<"told", told>,
                            cca::node<"walk", skill, cca::stoppable<>>,
                            cca::node<"balance", counting, cca::stoppable<>>,
                            cca::node<"reach", skill, cca::stoppable<>>> {};
// [needs end]

template <class Graph>
cca::controller<Graph> running() {
  cca::controller<Graph> c;
  c.load();
  c.start();
  return c;
}

}  // namespace

TEST_SUITE("the parts that a step needs") {
  TEST_CASE_TEMPLATE("run, and the others rest", Sequencer, cca::sequencer<"*.status.*", plan>,
                     own_sequencer) {
    auto c = running<skilled<Sequencer>>();
    const auto& walk = c.template get<"walk">().template get<"a">();
    const auto& balance = c.template get<"balance">();
    const auto& reach = c.template get<"reach">().template get<"b">();
    c.run(cca::for_beats<1>{});
    CHECK(c.template is_stopped<"reach">());  // from the second beat on
    CHECK_EQ(reach.fired, 1);
    c.run(cca::for_beats<10>{});  // in beat 10 it stands
    CHECK_EQ(walk.fired, 11);
    CHECK(c.template is_stopped<"walk">());
    CHECK_FALSE(c.template is_stopped<"balance">());
    c.run(cca::for_beats<10>{});  // in beat 20 it reaches
    CHECK_FALSE(c.template is_stopped<"reach">());
    CHECK_EQ(walk.fired, 11);
    c.run(cca::for_beats<10>{});  // in beat 30 it rests
    CHECK_EQ(reach.fired, 1 + 5);
    CHECK_EQ(balance.fired, 31);
    CHECK(c.template is_stopped<"balance">());
    c.start("walk");  // against the plan, which is asked for in each firing
    c.run(cca::for_beats<5>{});
    CHECK_EQ(walk.fired, 12);
    CHECK_EQ(balance.stops, 1);
    c.stop();
    c.start();  // all begin, and the plan too
    c.run(cca::for_beats<5>{});
    CHECK(c.template is_stopped<"reach">());
    CHECK_FALSE(c.template is_stopped<"walk">());
  }

  TEST_CASE("a part in another one needs that, too") {
    struct nested : cca::steps<cca::step<"all", cca::needs<"body">>,
                               cca::step<"arm", cca::after<10>, cca::needs<"body.arm">>,
                               cca::step<"none", cca::after<10>>> {};
    struct holder {
      auto process(cca::beat now) -> decltype(nested::asks(0)) {
        steps.update(now);
        return steps.asks();
      }
      cca::sequence<nested> steps;
    };
    struct body : cca::graph<cca::node<"arm", counting, cca::stoppable<>>, cca::node<"leg", counting>> {};
    struct robot : cca::graph<cca::rate<1000>, cca::node<"sequencer", holder, cca::timed<1>>,
                              cca::node<"body", body, cca::stoppable<>>> {};
    auto c = running<robot>();
    c.run(cca::for_beats<5>{});
    CHECK_FALSE(c.is_stopped<"body">());
    CHECK(c.is_stopped<"body.arm">());
    c.run(cca::for_beats<10>{});
    CHECK_FALSE(c.is_stopped<"body.arm">());
    CHECK_EQ(c.get<"body.leg">().fired, 15);
    c.run(cca::for_beats<10>{});
    CHECK(c.is_stopped<"body">());
  }

  TEST_CASE("of a plan that chooses") {
    struct choices : cca::steps<cca::step<"walk", cca::needs<"walk">, cca::then_one_of<"reach">>,
                                cca::step<"reach", cca::after<10>, cca::needs<"reach">>> {};
    struct judge {
      auto process() -> cca::out<"state", cca::criterion_port> {
        return cca::status_of(cca::criterion_state::fulfilled);
      }
    };
    struct learned
        : cca::graph<cca::rate<1000>,
                     cca::node<"sequencer", cca::learned_sequencer<"told.status.*", choices>, cca::timed<1>>,
                     cca::node<"told", told>, cca::node<"judge", judge>,
                     cca::wire<"judge.state", "sequencer.criterion">,
                     cca::node<"walk", skill, cca::stoppable<>>,
                     cca::node<"reach", skill, cca::stoppable<>>> {};
    auto c = running<learned>();
    c.run(cca::for_beats<5>{});
    CHECK(c.is_stopped<"reach">());
    c.run(cca::for_beats<10>{});
    CHECK(c.is_stopped<"walk">());
    CHECK_FALSE(c.is_stopped<"reach">());
  }
}
