// Semantics, "What an input sees": several wires at one input, and queues whose samples arrive later.
#include <string>

#include <cca/main/end_of_run.hpp>

#include "by_hand.hpp"

using namespace by_hand;

namespace {

using ms1 = cca::rate<1000>;

// Publishes Base plus the beat's index.
template <int Base>
struct count_from {
  auto process(cca::beat now) -> cca::out<"y", value> { return Base + static_cast<double>(now.index()); }
};
// The same, in beats that N divides.
template <int Base, int N>
struct sometimes_from {
  auto process(cca::beat now) -> cca::maybe<"y", value> {
    if (now.index() % N != 0) return {};
    return Base + static_cast<double>(now.index());
  }
};

struct look_and_count : look {
  std::vector<std::int64_t> dropped;
  void process(cca::in<"x", value> x, cca::beat now) {
    look::process(x, now);
    dropped.push_back(x.dropped());
  }
};

template <class... Items>
seen_inputs seen(int beats) {
  struct g : cca::graph<ms1, Items...> {};
  return after<g>(beats).template get<"r">().log;
}

std::vector<double> values_of(const seen_inputs& all) {
  std::vector<double> values;
  for (const auto& s : all) values.push_back(s.value);
  return values;
}
using values = std::vector<double>;

}  // namespace

TEST_SUITE("semantics by hand: merged wires and delayed queues") {
  TEST_CASE("merged: every sample of two writers is read, in the order in which it was published") {
    // Each publishes 5 in 10 beats, the reader can fire in each: an arbiter would lose half of them.
    CHECK(seen<cca::node<"a", count_from<100>, cca::timed<2>>, cca::node<"b", count_from<200>, cca::timed<2>>,
               cca::node<"r", look>, cca::wire<"b.y", "r.x", cca::merged<8>>,
               cca::wire<"a.y", "r.x", cca::merged<8>>>(10) == seen_inputs{{0, 100, 0, true},
                                                                           {1, 200, 0, true},
                                                                           {2, 102, 2 * ms, true},
                                                                           {3, 202, 2 * ms, true},
                                                                           {4, 104, 4 * ms, true},
                                                                           {5, 204, 4 * ms, true},
                                                                           {6, 106, 6 * ms, true},
                                                                           {7, 206, 6 * ms, true},
                                                                           {8, 108, 8 * ms, true},
                                                                           {9, 208, 8 * ms, true}});
  }

  TEST_CASE("merged: of one beat in the order of publication, which is that of the calls") {
    // `late` is declared first, but hears `early`.
    struct g
        : cca::graph<ms1, cca::node<"late", relay>, cca::node<"early", count_from<100>, cca::timed<4>>,
                     cca::node<"r", look>, cca::wire<"early.y", "late.x">,
                     cca::wire<"late.y", "r.x", cca::merged<4>>, cca::wire<"early.y", "r.x", cca::merged<4>>,
                     cca::wire<"early.y", "r.x", cca::merged<4>, cca::delayed<4>>> {};
    CHECK(values_of(after<g>(7).get<"r">().log) == values{100, 100, 100, 104, 104});
    CHECK(beats_of(after<g>(7).get<"r">().log) == beats{0, 1, 4, 5, 6});
  }

  TEST_CASE("merged and delayed: what arrives when a beat begins comes before what is published in it") {
    // In beat 3 arrive: b's of beat 0 (delayed 3), c's of beat 1 (delayed 2), then a's of beat 3.
    CHECK(seen<cca::node<"a", count_from<100>, cca::timed<4, 3>>,
               cca::node<"c", count_from<300>, cca::timed<4, 1>>,
               cca::node<"b", count_from<200>, cca::timed<4>>, cca::node<"r", look>,
               cca::wire<"a.y", "r.x", cca::merged<8>>,
               cca::wire<"b.y", "r.x", cca::merged<8>, cca::delayed<3>>,
               cca::wire<"c.y", "r.x", cca::delayed<2>, cca::merged<8>>>(6) ==
          seen_inputs{{3, 200, 0, true}, {4, 301, ms, true}, {5, 103, 3 * ms, true}});
    // Equal delays: in the order in which they were published, whatever the order of the wires.
    CHECK(values_of(seen<cca::node<"a", count_from<100>, cca::timed<4>>,
                         cca::node<"b", count_from<200>, cca::timed<4>>, cca::node<"r", look>,
                         cca::wire<"b.y", "r.x", cca::merged<8>, cca::delayed<2>>,
                         cca::wire<"a.y", "r.x", cca::merged<8>, cca::delayed<2>>>(8)) ==
          values{100, 200, 104, 204});
  }

  TEST_CASE("a full merged queue loses what its policy says, and counts it") {
    const auto run = []<class Full>(Full) {
      struct g : cca::graph<ms1, cca::node<"a", count_from<100>>, cca::node<"b", count_from<200>>,
                            cca::node<"r", look_and_count, cca::timed<2, 1>>,
                            cca::wire<"a.y", "r.x", cca::merged<2, Full>>,
                            cca::wire<"b.y", "r.x", cca::merged<2, Full>>> {};
      return after<g>(6).template get<"r">();
    };
    // 100 200, then 101 201: read in beat 1.
    const auto oldest = run(cca::drop_oldest{});
    CHECK(values_of(oldest.log) == values{101, 103, 105});
    CHECK(oldest.dropped == std::vector<std::int64_t>{2, 5, 8});
    const auto newest = run(cca::drop_newest{});
    CHECK(values_of(newest.log) == values{100, 200, 102});
    CHECK(newest.dropped == std::vector<std::int64_t>{2, 5, 8});
  }

  TEST_CASE("what a queue has lost can be read from outside, too") {
    struct two : cca::graph<cca::node<"r", look_and_count, cca::timed<2, 1>>, cca::expose<"r.x", "x">> {};
    struct g : cca::graph<ms1, cca::node<"a", count>, cca::node<"g", two>, cca::node<"q", look>,
                          cca::node<"s", look, cca::timed<3>>, cca::wire<"a.y", "g.x", cca::queue<2>>,
                          cca::wire<"a.y", "q.x">,
                          cca::wire<"a.y", "s.x", cca::queue<1, cca::drop_newest>, cca::delayed<2>>> {};
    const auto c = after<g>(7);
    CHECK(c.dropped<"g.r.x">() == 2);
    CHECK(c.dropped("s.x") == 3);  // arrivals in 2, 3, ..., 6; taken in 3 and 6
    CHECK(c.dropped("q.x") == 0);
    CHECK(c.dropped() == 5);
    CHECK(cca::summaries_of(c) ==
          std::vector<std::string>{"`g.r.x`: its queue of 2 was full and lost 2 samples",
                                   "`s.x`: its queue of 1 was full and lost 3 samples"});
    CHECK_THROWS_WITH(c.dropped("g.r.y"),
                      "cca::controller: dropped(`g.r.y`): there is no such input; did you mean `g.r.x`?");
  }

  TEST_CASE("a single wire that is merged is a queue") {
    CHECK(seen<cca::node<"a", count>, cca::node<"r", look, cca::timed<2, 1>>,
               cca::wire<"a.y", "r.x", cca::merged<8>>>(6) ==
          seen<cca::node<"a", count>, cca::node<"r", look, cca::timed<2, 1>>,
               cca::wire<"a.y", "r.x", cca::queue<8>>>(6));
  }

  TEST_CASE("without a second number a full queue drops the oldest") {
    CHECK(values_of(seen<cca::node<"a", count>, cca::node<"r", look, cca::timed<3, 2>>,
                         cca::wire<"a.y", "r.x", cca::queue<2>>>(9)) == values{1, 4, 7});
  }

  TEST_CASE("delayed with a queue: the sample enters the queue when it arrives, and fullness counts then") {
    CHECK(seen<cca::node<"a", count>, cca::node<"r", look, cca::timed<1>>,
               cca::wire<"a.y", "r.x", cca::delayed<2>, cca::queue<8>>>(5) ==
          seen_inputs{{0, 0, never, false},
                      {1, 0, never, false},
                      {2, 0, 0, true},
                      {3, 1, ms, true},
                      {4, 2, 2 * ms, true}});
    // Two have place. Arrivals: 0 in beat 2, 1 in 3, ...; read in beats 2, 5, 8.
    struct g : cca::graph<ms1, cca::node<"a", count>, cca::node<"r", look_and_count, cca::timed<3, 2>>,
                          cca::wire<"a.y", "r.x", cca::queue<2>, cca::delayed<2>>> {};
    const auto r = after<g>(9).get<"r">();
    CHECK(r.log == seen_inputs{{2, 0, 0, true}, {5, 2, 2 * ms, true}, {8, 5, 5 * ms, true}});
    CHECK(r.dropped == std::vector<std::int64_t>{0, 1, 3});
    CHECK(values_of(seen<cca::node<"a", count>, cca::node<"r", look, cca::timed<3, 2>>,
                         cca::wire<"a.y", "r.x", cca::queue<2, cca::drop_newest>, cca::delayed<2>>>(9)) ==
          values{0, 1, 2});
  }

  TEST_CASE("delayed with a queue: a reader fires with what arrives") {
    CHECK(seen<cca::node<"a", count, cca::timed<3, 1>>, cca::node<"r", look>,
               cca::wire<"a.y", "r.x", cca::delayed<2>, cca::queue<4>>>(8) ==
          seen_inputs{{3, 1, ms, true}, {6, 4, 4 * ms, true}});
    CHECK(seen<cca::node<"a", sometimes<3>>, cca::node<"r", look>,
               cca::wire<"a.y", "r.x", cca::delayed<2>, cca::queue<4>>>(8) ==
          seen_inputs{{2, 0, 0, true}, {5, 3, 3 * ms, true}});
  }

  TEST_CASE("delayed with a queue that rejects: the fault is in the beat of the arrival, before all calls") {
    struct g : cca::graph<ms1, cca::node<"a", sometimes<1>>, cca::node<"r", look, cca::timed<9, 8>>,
                          cca::wire<"a.y", "r.x", cca::queue<2, cca::reject>, cca::delayed<3>>,
                          cca::node<"s", look>, cca::wire<"a.y", "s.x">> {};
    cca::controller<g> c;
    c.load();
    c.start();
    for (int k = 0; k < 5; ++k) c.step();  // 0 arrives in beat 3, 1 in beat 4
    CHECK(c.state() == cca::state::started);
    c.step();
    CHECK(c.state() == cca::state::faulted);
    CHECK(c.fault().reason() == std::string_view("a sample arrived while the queue was full"));
    CHECK(c.fault_path() == "r");
    CHECK(c.get<"s">().log.size() == 5);  // nothing fires in beat 5
    c.resume();
    c.step();
    CHECK(c.get<"s">().log.size() == 5);
    CHECK(c.state() == cca::state::faulted);  // what was under way goes on arriving
  }

  TEST_CASE("coordinated: a merged input shows its oldest waiting sample") {
    struct g : cca::graph<ms1, cca::node<"a", count_from<100>, cca::timed<4>>,
                          cca::node<"b", count_from<200>, cca::timed<4, 1>>, cca::node<"c", count_from<300>>,
                          cca::node<"r", look_at_two, cca::coordinated>,
                          cca::wire<"a.y", "r.x", cca::merged<8>, cca::delayed<2>>,
                          cca::wire<"b.y", "r.x", cca::merged<8>, cca::delayed<1>>,
                          cca::wire<"c.y", "r.z", cca::delayed<2>>> {};
    // In beat 2 arrive a's 100 of beat 0, then b's 201 of beat 1; z is of beat k - 2.
    const auto r = after<g>(8).get<"r">();
    CHECK(r.x ==
          seen_inputs{{2, 100, 0, true}, {3, 201, ms, true}, {6, 104, 4 * ms, true}, {7, 205, 5 * ms, true}});
    CHECK(r.z ==
          seen_inputs{{2, 300, 0, true}, {3, 301, ms, true}, {6, 304, 4 * ms, true}, {7, 305, 5 * ms, true}});
  }

  TEST_CASE("origin: of what is merged the samples that close a loop don't count, the others do") {
    // m hears the slow sensor, and itself a beat later.
    struct g : cca::graph<ms1, cca::node<"s", count_from<100>, cca::timed<4>>,
                          cca::node<"m", relay, cca::timed<1>>, cca::node<"r", look>,
                          cca::wire<"s.y", "m.x", cca::merged<4>, cca::delayed<2>>,
                          cca::wire<"m.y", "m.x", cca::merged<4>, cca::delayed<1>>,
                          cca::wire<"m.y", "r.x", cca::queue<4>>> {};
    // Beat 2: m's own of beat 1 was published later than s's of beat 0: s's comes first.
    const auto log = after<g>(4).get<"r">().log;
    CHECK(log == seen_inputs{{0, 0, 0, true}, {1, 0, ms, true}, {2, 100, 0, true}, {3, 0, 3 * ms, true}});
  }

  TEST_CASE("origin: an observer of what is merged counts the samples that close no loop for it") {
    // o observes the queue of q, and publishes into the same queue, as the slow sensor does.
    struct relay_heard {
      auto process(cca::observe<"q.x.**"> all) -> cca::out<"y", value> { return all.begin()->values[0]; }
    };
    struct g : cca::graph<ms1, cca::node<"s", count_from<100>, cca::timed<4>>,
                          cca::node<"o", relay_heard, cca::timed<1>>, cca::node<"q", look, cca::timed<1>>,
                          cca::node<"r", look>, cca::wire<"o.y", "q.x", cca::merged<4>, cca::delayed<1>>,
                          cca::wire<"s.y", "q.x", cca::merged<4>>, cca::wire<"o.y", "r.x", cca::queue<4>>> {};
    // Beat 4: o's own of beat 3 came when the beat began. Beat 5: the sensor's of beat 4 is the oldest.
    const auto log = after<g>(6).get<"r">().log;
    CHECK(log == seen_inputs{{0, 100, 0, true},
                             {1, 100, ms, true},
                             {2, 100, 2 * ms, true},
                             {3, 100, 3 * ms, true},
                             {4, 100, 4 * ms, true},
                             {5, 104, 4 * ms, true}});
  }

  TEST_CASE("until a first sample has come: the initial value of whichever wire states one") {
    CHECK(seen<cca::node<"a", count, cca::timed<9, 8>>, cca::node<"b", count, cca::timed<9, 2>>,
               cca::node<"r", look, cca::timed<1>>, cca::wire<"a.y", "r.x", cca::merged<4>>,
               cca::wire<"b.y", "r.x", cca::merged<4>, cca::initial<2.5>>>(3) ==
          seen_inputs{{0, 2.5, never, false}, {1, 2.5, never, false}, {2, 2, 2 * ms, true}});
  }

  TEST_CASE("merged at an input that inner graphs expose") {
    struct two : cca::graph<cca::node<"q", look>, cca::node<"r", look>, cca::expose<"q.x", "x">,
                            cca::expose<"r.x", "x">> {};
    struct inside : cca::graph<cca::node<"a", count_from<100>, cca::timed<2>>, cca::node<"r", look>,
                               cca::wire<"a.y", "r.x", cca::merged<4>>, cca::expose<"r.x", "x">> {};
    struct g : cca::graph<ms1, cca::node<"a", count_from<100>, cca::timed<2>>,
                          cca::node<"b", count_from<200>, cca::timed<2>>, cca::node<"g", two>,
                          cca::node<"h", inside>, cca::wire<"a.y", "g.x", cca::merged<4>>,
                          cca::wire<"b.y", "g.x", cca::merged<4>>, cca::wire<"b.y", "h.x", cca::merged<4>>> {
    };
    const auto c = after<g>(4);
    CHECK(values_of(c.get<"g.q">().log) == values{100, 200, 102, 202});
    CHECK(c.get<"g.r">().log == c.get<"g.q">().log);
    CHECK(values_of(c.get<"h.r">().log) == values{200, 100, 202, 102});
  }

  TEST_CASE("a copy of a controller goes on with what waits and what is under way") {
    struct g : cca::graph<ms1, cca::node<"a", count_from<100>>, cca::node<"b", sometimes_from<200, 3>>,
                          cca::node<"r", look, cca::timed<1>>,
                          cca::wire<"a.y", "r.x", cca::merged<3>, cca::delayed<2>>,
                          cca::wire<"b.y", "r.x", cca::merged<3>>> {};
    auto c = after<g>(7);
    auto copy = c;
    for (int k = 0; k < 9; ++k) c.step(), copy.step();
    CHECK(copy.get<"r">().log == c.get<"r">().log);
    CHECK(c.get<"r">().log.size() == 16);
  }
}
