// Semantics, "What an input sees" and "Fresh", sentence by sentence.
#include "by_hand.hpp"

using namespace by_hand;

namespace {

using ms1 = cca::rate<1000>;

template <class Policy, class Reader = cca::timed<1>, class Writer = cca::timed<1>, class... Initial>
struct one_wire : cca::graph<ms1,
                             cca::node<"s", count, Writer>,
                             cca::node<"r", look, Reader>,
                             cca::wire<"s.y", "r.x", Policy, Initial...>> {};

template <class Graph>
seen_inputs seen(int beats) {
  return after<Graph>(beats).template get<"r">().log;
}

}  // namespace

TEST_SUITE("semantics by hand: what an input sees") {
  TEST_CASE("latest: the newest sample published so far, this beat included") {
    CHECK(seen<one_wire<cca::latest>>(3) ==
          seen_inputs{{0, 0, 0, true}, {1, 1, ms, true}, {2, 2, 2 * ms, true}});
    CHECK(seen<one_wire<cca::latest, cca::timed<1>, cca::timed<3, 1>>>(6) ==
          seen_inputs{{0, 0, never, false},
                      {1, 1, ms, true},
                      {2, 1, ms, false},
                      {3, 1, ms, false},
                      {4, 4, 4 * ms, true},
                      {5, 4, 4 * ms, false}});
    CHECK(seen<one_wire<cca::latest, cca::timed<3, 1>>>(8) ==
          seen_inputs{{1, 1, ms, true}, {4, 4, 4 * ms, true}, {7, 7, 7 * ms, true}});
  }

  TEST_CASE(
      "delayed<N>: what is published in beat j arrives when beat j + N begins, and is then the newest") {
    CHECK(seen<one_wire<cca::delayed<1>>>(3) ==
          seen_inputs{{0, 0, never, false}, {1, 0, 0, true}, {2, 1, ms, true}});
    CHECK(seen<one_wire<cca::delayed<3>>>(6) == seen_inputs{{0, 0, never, false},
                                                            {1, 0, never, false},
                                                            {2, 0, never, false},
                                                            {3, 0, 0, true},
                                                            {4, 1, ms, true},
                                                            {5, 2, 2 * ms, true}});
    CHECK(seen<one_wire<cca::delayed<2>, cca::timed<2, 1>, cca::timed<3>>>(10) ==
          seen_inputs{{1, 0, never, false},
                      {3, 0, 0, true},
                      {5, 3, 3 * ms, true},
                      {7, 3, 3 * ms, false},
                      {9, 6, 6 * ms, true}});
  }

  TEST_CASE("delayed: a reader that comes before its writer and one that comes after see the same") {
    struct g
        : cca::graph<ms1, cca::node<"before", look, cca::timed<1>>, cca::node<"s", count>,
                     cca::node<"after", look, cca::timed<1>>, cca::wire<"s.y", "before.x", cca::delayed<1>>,
                     cca::wire<"s.y", "after.x", cca::delayed<1>>> {};
    const auto c = after<g>(4);
    CHECK(c.get<"before">().log ==
          seen_inputs{{0, 0, never, false}, {1, 0, 0, true}, {2, 1, ms, true}, {3, 2, 2 * ms, true}});
    CHECK(c.get<"after">().log == c.get<"before">().log);
  }

  TEST_CASE(
      "queue: first in, first out - a firing takes the oldest - if there is none it sees again what it took "
      "last") {
    CHECK(seen<one_wire<cca::queue<8, cca::drop_oldest>, cca::timed<2, 3>>>(8) ==
          seen_inputs{{1, 0, 0, true}, {3, 1, ms, true}, {5, 2, 2 * ms, true}, {7, 3, 3 * ms, true}});
    CHECK(seen<one_wire<cca::queue<2, cca::drop_newest>, cca::timed<1>, cca::timed<3, 1>>>(6) ==
          seen_inputs{{0, 0, never, false},
                      {1, 1, ms, true},
                      {2, 1, ms, false},
                      {3, 1, ms, false},
                      {4, 4, 4 * ms, true},
                      {5, 4, 4 * ms, false}});
  }

  TEST_CASE("a full queue: drop_oldest, drop_newest") {
    // Three arrive between two firings, two have place.
    CHECK(seen<one_wire<cca::queue<2, cca::drop_oldest>, cca::timed<3, 2>>>(9) ==
          seen_inputs{{2, 1, ms, true}, {5, 4, 4 * ms, true}, {8, 7, 7 * ms, true}});
    CHECK(seen<one_wire<cca::queue<2, cca::drop_newest>, cca::timed<3, 2>>>(9) ==
          seen_inputs{{2, 0, 0, true}, {5, 1, ms, true}, {8, 3, 3 * ms, true}});
  }

  TEST_CASE("a full queue: reject is a fault where the clocks don't prove it before") {
    struct g : cca::graph<ms1, cca::node<"s", sometimes<1>>, cca::node<"r", look, cca::timed<4, 3>>,
                          cca::wire<"s.y", "r.x", cca::queue<3, cca::reject>>> {};
    cca::controller<g> c;
    c.load();
    c.start();
    for (int k = 0; k < 3; ++k) c.step();  // 0, 1, 2 wait
    CHECK(c.state() == cca::state::started);
    c.step();  // 3 arrives before the reader is called
    CHECK(c.state() == cca::state::faulted);
    CHECK(c.get<"r">().log.empty());
  }

  TEST_CASE("until a first sample has come: the space's zero, or the wire's initial") {
    CHECK(seen<one_wire<cca::latest, cca::timed<1>, cca::timed<3, 2>, cca::initial<2.5>>>(3) ==
          seen_inputs{{0, 2.5, never, false}, {1, 2.5, never, false}, {2, 2, 2 * ms, true}});
    CHECK(seen<one_wire<cca::delayed<2>, cca::timed<1>, cca::timed<1>, cca::initial<-1.5>>>(3) ==
          seen_inputs{{0, -1.5, never, false}, {1, -1.5, never, false}, {2, 0, 0, true}});
    CHECK(seen<one_wire<cca::queue<2, cca::drop_oldest>, cca::timed<1>, cca::timed<3, 1>, cca::initial<4.0>>>(
              3) == seen_inputs{{0, 4, never, false}, {1, 1, ms, true}, {2, 1, ms, false}});
  }

  TEST_CASE("an initial value belongs to its wire, not to the writer") {
    struct g : cca::graph<ms1, cca::node<"s", count, cca::timed<9, 2>>, cca::node<"a", look, cca::timed<1>>,
                          cca::node<"b", look, cca::timed<1>>, cca::node<"c", look, cca::timed<1>>,
                          cca::wire<"s.y", "a.x", cca::latest, cca::initial<1.0>>,
                          cca::wire<"s.y", "b.x", cca::latest>,
                          cca::wire<"s.y", "c.x", cca::delayed<1>, cca::initial<3.0>>> {};
    const auto c = after<g>(4);
    CHECK(
        c.get<"a">().log ==
        seen_inputs{{0, 1, never, false}, {1, 1, never, false}, {2, 2, 2 * ms, true}, {3, 2, 2 * ms, false}});
    CHECK(
        c.get<"b">().log ==
        seen_inputs{{0, 0, never, false}, {1, 0, never, false}, {2, 2, 2 * ms, true}, {3, 2, 2 * ms, false}});
    CHECK(
        c.get<"c">().log ==
        seen_inputs{{0, 3, never, false}, {1, 3, never, false}, {2, 3, never, false}, {3, 2, 2 * ms, true}});
  }

  TEST_CASE("an initial value is not fresh, also where the writer's clock is known only at run time") {
    struct g
        : cca::graph<ms1, cca::node<"s", count, cca::timed<9, 2>>, cca::node<"m", relay, cca::coordinated>,
                     cca::node<"r", look>, cca::node<"q", look, cca::timed<1>>,
                     cca::wire<"s.y", "m.x", cca::latest>, cca::wire<"m.y", "r.x", cca::latest>,
                     cca::wire<"m.y", "q.x", cca::latest, cca::initial<-3.0>>> {};
    const auto c = after<g>(5);
    CHECK(c.get<"r">().log == seen_inputs{{2, 2, 2 * ms, true}});
    CHECK(c.get<"q">().log == seen_inputs{{0, -3, never, false},
                                          {1, -3, never, false},
                                          {2, 2, 2 * ms, true},
                                          {3, 2, 2 * ms, false},
                                          {4, 2, 2 * ms, false}});
  }

  TEST_CASE("fresh: a sample has arrived since the component last fired") {
    // Published in beats 0, 4, 8; read in beats 0, 3, 6, 9.
    CHECK(seen<one_wire<cca::latest, cca::timed<3>, cca::timed<4>>>(10) ==
          seen_inputs{{0, 0, 0, true}, {3, 0, 0, false}, {6, 4, 4 * ms, true}, {9, 8, 8 * ms, true}});
    // A queue is fresh as long as it is not empty.
    struct g
        : cca::graph<ms1, cca::node<"s", count, cca::timed<4>>, cca::node<"t", sometimes<1>, cca::timed<1>>,
                     cca::node<"r", look>, cca::wire<"t.y", "r.x", cca::queue<8, cca::drop_oldest>>> {};
    CHECK(after<g>(3).get<"r">().log == seen_inputs{{0, 0, 0, true}, {1, 1, ms, true}, {2, 2, 2 * ms, true}});
  }

  TEST_CASE("maybe: empty, nothing is published") {
    struct g : cca::graph<ms1, cca::node<"s", sometimes<3>>, cca::node<"r", look>,
                          cca::node<"q", look, cca::timed<1>>, cca::node<"d", look, cca::timed<1>>,
                          cca::wire<"s.y", "r.x">, cca::wire<"s.y", "q.x">,
                          cca::wire<"s.y", "d.x", cca::delayed<2>>> {};
    const auto c = after<g>(6);
    CHECK(c.get<"r">().log == seen_inputs{{0, 0, 0, true}, {3, 3, 3 * ms, true}});
    CHECK(c.get<"q">().log == seen_inputs{{0, 0, 0, true},
                                          {1, 0, 0, false},
                                          {2, 0, 0, false},
                                          {3, 3, 3 * ms, true},
                                          {4, 3, 3 * ms, false},
                                          {5, 3, 3 * ms, false}});
    CHECK(c.get<"d">().log == seen_inputs{{0, 0, never, false},
                                          {1, 0, never, false},
                                          {2, 0, 0, true},
                                          {3, 0, 0, false},
                                          {4, 0, 0, false},
                                          {5, 3, 3 * ms, true}});
  }

  TEST_CASE("an optional_in that is not wired holds the zero, of no origin, and is not fresh") {
    struct reader {
      seen_inputs log;
      std::vector<bool> wired;
      void process(cca::in<"x", value>, cca::optional_in<"z", value> z, cca::beat now) {
        log.push_back({now.index(), z[axis{}], z.origin(), z.fresh()});
        wired.push_back(static_cast<bool>(z));
      }
    };
    struct loose : cca::graph<ms1, cca::node<"s", count>, cca::node<"r", reader>, cca::wire<"s.y", "r.x">> {};
    struct wired : cca::graph<ms1, cca::node<"s", count>, cca::node<"r", reader>, cca::wire<"s.y", "r.x">,
                              cca::wire<"s.y", "r.z">> {};
    const auto a = after<loose>(2);
    CHECK(a.get<"r">().log == seen_inputs{{0, 0, never, false}, {1, 0, never, false}});
    CHECK(a.get<"r">().wired == std::vector{false, false});
    const auto b = after<wired>(2);
    CHECK(b.get<"r">().log == seen_inputs{{0, 0, 0, true}, {1, 1, ms, true}});
    CHECK(b.get<"r">().wired == std::vector{true, true});
  }
}
