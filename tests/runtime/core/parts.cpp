// Parts of an architecture that stop and start as a whole: inner graphs, one in another, from outside and by
// components; in one loop, in environments and in modes. The bits are those of components that are stopped
// one by one.
#include <doctest/doctest.h>

#include <string>
#include <tuple>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "../running.hpp"
#include "counting.hpp"

using namespace core_test;

namespace {

// What a component has seen and told, and in which beats.
struct trace {
  std::vector<std::int64_t> beats;
  std::vector<double> seen, dts;
  std::vector<bool> fresh;
  int starts = 0, stops = 0;
};
struct noting : trace {
  auto process(cca::in<"x", reading> x, cca::beat now) -> cca::out<"y", reading> {
    beats.push_back(now.index());
    seen.push_back(x[cca::x{}]);
    fresh.push_back(x.fresh());
    dts.push_back(now.dt());
    return x[cca::x{}] + 1;
  }
  void on_start() { ++starts; }
  void on_stop() { ++stops; }
};
struct source {
  auto process(cca::beat now) -> cca::out<"y", reading> { return static_cast<double>(now.index()); }
};
struct last {
  void process(cca::in<"x", reading> x, cca::beat now) {
    value = x[cca::x{}];
    age = x.origin() == cca::never ? -1 : now.time() - x.origin();
    ++fired;
  }
  double value = 0;
  std::int64_t age = -1;
  int fired = 0;
};

// [part]
struct reaching : cca::graph<cca::node<"aim", noting>,  // fires with its input
                             cca::node<"move", noting, cca::timed<3>>,
                             cca::wire<"aim.y", "move.x", cca::latest>,
                             cca::expose<"aim.x", "x">,
                             cca::expose<"move.y", "y">> {};
struct skilled : cca::graph<cca::rate<1000>,
                            cca::node<"source", source>,
                            cca::node<"reach", reaching, cca::stoppable<>>,  // it stops and starts as one
                            cca::node<"last", last>,
                            cca::wire<"source.y", "reach.x">,
                            cca::wire<"reach.y", "last.x">> {};
// [part end]

using test::refusal;
using test::running;
using beats = std::vector<std::int64_t>;

// ---- by components ----

template <std::int64_t Stops, std::int64_t Starts>
struct orders {
  auto process(cca::in<"x", reading> x, cca::beat now)
      -> std::tuple<cca::out<"y", reading>, cca::stops<"reach">, cca::starts<"reach">> {
    return {x[cca::x{}], now.index() % 10 == Stops, now.index() % 10 == Starts};
  }
};
struct ordered : cca::graph<cca::rate<1000>,
                            cca::node<"source", source>,
                            cca::node<"orders", orders<3, 6>>,
                            cca::node<"reach", reaching, cca::stoppable<>>,
                            cca::node<"last", last>,
                            cca::wire<"source.y", "orders.x">,
                            cca::wire<"source.y", "reach.x">,
                            cca::wire<"reach.y", "last.x", cca::delayed<1>>> {};

}  // namespace

TEST_SUITE("parts") {
  TEST_CASE("an inner graph stops and starts as one") {
    auto c = running<cca::controller<skilled>>();
    auto& aim = c.get<"reach">().get<"aim">();
    auto& move = c.get<"reach">().get<"move">();
    c.run(cca::for_beats<5>{});
    c.stop<"reach">();
    CHECK(c.is_stopped<"reach">());
    CHECK_EQ(aim.stops, 1);
    CHECK_EQ(move.stops, 1);
    c.run(cca::for_beats<5>{});
    CHECK_EQ(c.get<"last">().fired, 2);  // in beats 0 and 3
    CHECK_EQ(c.get<"last">().value, 5);
    c.start<"reach">();
    CHECK_EQ(aim.starts, 2);
    CHECK_EQ(move.starts, 2);
    c.run(cca::for_beats<4>{});
    CHECK_EQ(aim.beats, beats{0, 1, 2, 3, 4, 10, 11, 12, 13});
    CHECK_EQ(move.beats, beats{0, 3, 12});
    CHECK_EQ(move.dts, std::vector<double>{0.003, 0.003, 0.003});  // not the time of its rest
    CHECK_EQ(aim.dts, std::vector<double>(9, 0.001));
    CHECK_EQ(c.get<"last">().fired, 3);
    CHECK_EQ(c.get<"last">().value, 14);
  }

  TEST_CASE("what arrived while a part was stopped is not fresh") {
    struct slow : cca::graph<cca::rate<1000>, cca::node<"source", source, cca::timed<10>>,
                             cca::node<"reach", reaching, cca::stoppable<>>, cca::node<"last", last>,
                             cca::wire<"source.y", "reach.x">, cca::wire<"reach.y", "last.x">> {};
    auto c = running<cca::controller<slow>>();
    auto& aim = c.get<"reach">().get<"aim">();
    auto& move = c.get<"reach">().get<"move">();
    c.run(cca::for_beats<5>{});
    c.stop<"reach">();
    c.run(cca::for_beats<12>{});  // a sample in beat 10
    c.start<"reach">();
    c.run(cca::for_beats<5>{});
    CHECK_EQ(aim.beats, beats{0, 20});
    CHECK_EQ(move.beats, beats{0, 3, 18, 21});
    CHECK_EQ(move.fresh, std::vector<bool>{true, false, false, true});
    CHECK_EQ(move.seen, std::vector<double>{1, 1, 1, 21});
  }

  TEST_CASE("a timeout begins anew with its part: after the start as after beat 0") {
    struct patient
        : cca::graph<cca::rate<1000>, cca::node<"source", source, cca::timed<100>>,
                     cca::node<"late", noting, cca::stoppable<cca::any_of<cca::timeout<3>, cca::inactive>>>,
                     cca::wire<"source.y", "late.x", cca::latest>> {};
    auto c = running<cca::controller<patient>>();
    c.run(cca::for_beats<8>{});
    c.stop<"late">();
    c.run(cca::for_beats<2>{});
    c.start<"late">();
    c.run(cca::for_beats<10>{});
    CHECK_EQ(c.get<"late">().beats, beats{3, 6, 13, 16, 19});
  }

  TEST_CASE("a part in a part has a life-cycle of its own") {
    struct outer : cca::graph<cca::node<"first", noting>, cca::node<"reach", reaching, cca::stoppable<>>,
                              cca::wire<"first.y", "reach.x">, cca::expose<"first.x", "x">,
                              cca::expose<"reach.y", "y">> {};
    struct nested : cca::graph<cca::rate<1000>, cca::node<"source", source>,
                               cca::node<"mind", outer, cca::stoppable<>>, cca::node<"last", last>,
                               cca::wire<"source.y", "mind.x">, cca::wire<"mind.y", "last.x">> {};
    auto c = running<cca::controller<nested>>();
    auto& first = c.get<"mind.first">();
    auto& aim = c.get<"mind.reach.aim">();
    c.stop<"mind.reach">();
    CHECK_EQ(first.stops, 0);
    CHECK_EQ(aim.stops, 1);
    c.stop("mind");
    CHECK_EQ(first.stops, 1);
    CHECK_EQ(aim.stops, 1);  // it rested already
    CHECK(c.is_stopped<"mind">());
    c.start<"mind.reach">();  // not before the part around it
    CHECK_EQ(aim.starts, 1);
    CHECK(c.is_stopped<"mind.reach">());
    c.run(cca::for_beats<3>{});
    CHECK(first.beats.empty());
    c.start<"mind">();
    CHECK_EQ(first.starts, 2);
    CHECK_EQ(aim.starts, 2);
    CHECK_FALSE(c.is_stopped<"mind.reach">());
    c.run(cca::for_beats<2>{});
    CHECK_EQ(aim.beats, beats{3, 4});

    c.stop<"mind.reach">();
    c.stop<"mind">();
    c.start<"mind">();
    CHECK(c.is_stopped<"mind.reach">());  // on its own
    c.stop();
    c.start();
    CHECK_FALSE(c.is_stopped<"mind.reach">());
    CHECK_EQ(aim.stops, 2);  // it rested when all stopped
  }

  TEST_CASE("components stop and start a part from the next beat on") {
    auto c = running<cca::controller<ordered>>();
    auto& aim = c.get<"reach">().get<"aim">();
    c.run(cca::for_beats<18>{});
    CHECK_EQ(aim.beats, beats{0, 1, 2, 3, 7, 8, 9, 10, 11, 12, 13, 17});
    CHECK_EQ(aim.stops, 2);
    CHECK_EQ(aim.starts, 3);
    CHECK_FALSE(c.is_stopped<"reach">());
  }

  TEST_CASE("of several requests in one beat that of the later call counts") {
    struct both : cca::graph<cca::rate<1000>, cca::node<"source", source>, cca::node<"second", orders<3, 5>>,
                             cca::node<"first", orders<5, 3>>, cca::node<"reach", reaching, cca::stoppable<>>,
                             cca::node<"last", last>, cca::wire<"source.y", "first.x">,
                             cca::wire<"first.y", "second.x">, cca::wire<"source.y", "reach.x">,
                             cca::wire<"reach.y", "last.x">> {};
    auto twice = running<cca::controller<both>>();
    twice.run(cca::for_beats<10>{});
    CHECK_EQ(twice.get<"reach">().get<"aim">().beats, beats{0, 1, 2, 3, 6, 7, 8, 9});
  }

  TEST_CASE("what is asked for in one beat has effect at once: hooks run only where something changes") {
    struct asks {
      auto process(cca::beat now) -> std::tuple<cca::stops<"around">,
                                                cca::starts<"around">,
                                                cca::stops<"around.reach">,
                                                cca::starts<"around.reach">> {
        return {now.index() == 1, now.index() == 3, now.index() == 3, now.index() == 5};
      }
    };
    struct inner : cca::graph<cca::node<"reach", noting, cca::stoppable<cca::timed<1>>>,
                              cca::node<"other", noting, cca::timed<1>>, cca::expose<"reach.x", "x">,
                              cca::expose<"other.x", "z">> {};
    struct outer : cca::graph<cca::rate<1000>, cca::node<"source", source>, cca::node<"asks", asks>,
                              cca::node<"around", inner, cca::stoppable<>>, cca::wire<"source.y", "around.x">,
                              cca::wire<"source.y", "around.z">, cca::observe<"around.**">> {};
    auto c = running<cca::controller<outer>>();
    const auto& reach = c.get<"around.reach">();
    c.run(cca::for_beats<5>{});  // when beat 4 begins `around` starts, and `reach` in it stays at rest
    CHECK_EQ(reach.starts, 1);
    CHECK_EQ(reach.stops, 1);
    CHECK_EQ(c.get<"around.other">().starts, 2);
    c.run(cca::for_beats<5>{});
    CHECK_EQ(reach.starts, 2);
    CHECK_EQ(reach.beats, beats{0, 1, 6, 7, 8, 9});
    CHECK_EQ(c.get<"around.other">().beats, beats{0, 1, 4, 5, 6, 7, 8, 9});
  }

  TEST_CASE("a component of an inner graph reaches parts around it, and parts of the outermost graph by /") {
    struct upwards {
      auto process(cca::in<"x", reading> x, cca::beat now)
          -> std::tuple<cca::stops<"reach">, cca::stops<"/far">> {
        return {now.index() == 1, x[cca::x{}] == 2};
      }
    };
    struct mind : cca::graph<cca::node<"upwards", upwards>, cca::expose<"upwards.x", "x">> {};
    struct around : cca::graph<cca::rate<1000>, cca::node<"source", source>, cca::node<"mind", mind>,
                               cca::node<"reach", reaching, cca::stoppable<>>,
                               cca::node<"far", noting, cca::stoppable<>>, cca::node<"last", last>,
                               cca::wire<"source.y", "mind.x">, cca::wire<"source.y", "reach.x">,
                               cca::wire<"source.y", "far.x">, cca::wire<"reach.y", "last.x">> {};
    auto c = running<cca::controller<around>>();
    c.run(cca::for_beats<10>{});
    CHECK_EQ(c.get<"reach.aim">().beats, beats{0, 1});
    CHECK_EQ(c.get<"far">().beats, beats{0, 1, 2});
  }

  TEST_CASE("in a beat that ends by a fault no request counts") {
    struct failing {
      auto process(cca::in<"x", reading>, cca::beat now) -> std::tuple<cca::out<"y", reading>, cca::fault> {
        return {0.0, now.index() == 3 ? cca::fault("as planned") : cca::fault()};
      }
    };
    struct faulty : cca::graph<cca::rate<1000>, cca::node<"source", source>,
                               cca::node<"orders", orders<3, 6>>, cca::node<"failing", failing>,
                               cca::node<"reach", reaching, cca::stoppable<>>, cca::node<"last", last>,
                               cca::wire<"source.y", "orders.x">, cca::wire<"orders.y", "failing.x">,
                               cca::wire<"source.y", "reach.x">, cca::wire<"reach.y", "last.x">> {};
    auto c = running<cca::controller<faulty>>();
    c.run(cca::for_beats<10>{});
    CHECK_EQ(c.state(), cca::state::faulted);
    CHECK_FALSE(c.is_stopped<"reach">());
    c.resume();
    c.run(cca::for_beats<2>{});
    CHECK_FALSE(c.is_stopped<"reach">());
    CHECK_EQ(c.get<"reach.aim">().beats, beats{0, 1, 2, 4, 5});
  }

  TEST_CASE("a copy keeps which parts are stopped, and what it asked for") {
    auto c = running<cca::controller<ordered>>();
    c.run(cca::for_beats<5>{});
    auto copy = c;
    CHECK(copy.is_stopped<"reach">());
    c.start<"reach">();
    CHECK(copy.is_stopped<"reach">());
  }

  TEST_CASE("what is refused") {
    cca::controller<skilled> c;
    CHECK_EQ(
        refusal([&] { c.stop<"reach">(); }),
        "cca::controller: stop(`reach`) is refused in the state `created`: start() the controller first");
    c.load();
    c.start();
    CHECK_EQ(refusal([&] { c.stop("reech"); }),
             "cca::controller: `reech` is no component; did you mean `reach`?");
    CHECK_EQ(refusal([&] { c.stop("reach.aim"); }),
             "cca::controller: `reach.aim` can't be stopped on its own: write cca::stoppable<...> around the "
             "strategy of its node");
    struct plain : cca::graph<cca::rate<1000>, cca::node<"source", source>, cca::node<"reach", reaching>,
                              cca::node<"last", last>, cca::wire<"source.y", "reach.x">,
                              cca::wire<"reach.y", "last.x">> {};
    auto other = running<cca::controller<plain>>();
    CHECK_EQ(
        refusal([&] { other.stop("reach"); }),
        "cca::controller: `reach` can't be stopped as a whole: write cca::stoppable<> as the strategy of "
        "its node");
  }
}
