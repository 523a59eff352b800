// A switch keeps what both modes have: components, samples with their origins, delays, queues, last firings.
// Two modes of equal graphs show it: however often one switches, the results are those of one graph.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <cca/modes.hpp>

#include "../core/counting.hpp"

using namespace core_test;

namespace {

struct now_and_then {  // seldom
  auto process(cca::beat now) -> cca::maybe<"y", reading> {
    if (now.index() % 3 == 0 || now.index() % 7 == 4) return {};
    return ++value;
  }
  double value = 0;
};
struct timer {  // its own dt and the freshness of what it reads
  void process(cca::in<"x", reading> x, cca::beat now) {
    all.push_back({now.index(), x[cca::x{}] + 1000 * now.dt(), x.origin(), x.fresh()});
  }
  std::vector<seen> all;
};
struct pair_journal {
  void process(cca::in<"a", reading> a, cca::in<"b", reading> b, cca::beat now) {
    all.push_back(
        {now.index(), a[cca::x{}] + 1e6 * b[cca::x{}], a.origin() + b.origin(), a.fresh() != b.fresh()});
  }
  std::vector<seen> all;
};
struct listener {
  void process(cca::observe<"inner.**.*", cca::delayed<2>> scope, cca::beat now) {
    for (const auto& one : scope) all.push_back({now.index(), one.values[0], one.origin, one.fresh});
  }
  std::vector<seen> all;
};
struct inner : cca::graph<cca::node<"sum", adder>,
                          cca::node<"late", adder>,
                          cca::wire<"sum.y", "late.x", cca::delayed<3>>,
                          cca::expose<"sum.x", "x">,
                          cca::expose<"late.y", "y">> {};

// Every way to store a sample, and every kind of clock.
template <int>
struct everything
    : cca::graph<cca::rate<1000>,
                 cca::node<"source", now_and_then>,
                 cca::node<"slow", counter, cca::timed<10, 3>>,
                 cca::node<"fast", counter>,
                 cca::node<"inner", inner>,
                 cca::node<"queued", journal, cca::timed<2>>,
                 cca::node<"merged", journal, cca::timed<1>>,
                 cca::node<"later", journal, cca::timed<2, 1>>,
                 cca::node<"slow_reader", timer, cca::timed<4, 1>>,
                 cca::node<"every_beat", timer, cca::timed<1>>,
                 cca::node<"restless", timer>,
                 cca::node<"by_slow", timer>,
                 cca::node<"delayed", timer, cca::timed<3>>,
                 cca::node<"together", pair_journal, cca::any_of<cca::coordinated, cca::timeout<7>>>,
                 cca::node<"moderate", pair_journal, cca::moderate>,
                 cca::node<"listener", listener>,
                 cca::wire<"source.y", "inner.x">,
                 cca::wire<"source.y", "queued.x", cca::queue<3, cca::drop_oldest>>,
                 cca::wire<"slow.y", "merged.x", cca::merged<3>>,
                 cca::wire<"source.y", "merged.x", cca::merged<3>, cca::delayed<2>>,
                 cca::wire<"inner.y", "merged.x", cca::merged<3>, cca::delayed<3>>,
                 cca::wire<"fast.y", "later.x", cca::queue<4, cca::drop_newest>, cca::delayed<6>>,
                 cca::wire<"source.y", "slow_reader.x", cca::latest>,
                 cca::wire<"slow.y", "every_beat.x", cca::latest, cca::initial<-5>>,
                 cca::wire<"source.y", "restless.x", cca::delayed<2>>,
                 cca::wire<"slow.y", "by_slow.x", cca::delayed<4>>,
                 cca::wire<"fast.y", "delayed.x", cca::delayed<6>>,
                 cca::wire<"inner.y", "together.a">,
                 cca::wire<"source.y", "together.b", cca::delayed<1>>,
                 cca::wire<"slow.y", "moderate.a", cca::latest, cca::initial<7>>,
                 cca::wire<"source.y", "moderate.b">,
                 cca::observe<"inner.**.*">> {};

template <class Controller>
std::vector<seen> seen_by(const Controller& c) {
  std::vector<seen> all;
  const auto add = [&](const std::vector<seen>& more) { all.insert(all.end(), more.begin(), more.end()); };
  add(c.template get<"queued">().all);
  add(c.template get<"merged">().all);
  add(c.template get<"later">().all);
  add(c.template get<"slow_reader">().all);
  add(c.template get<"every_beat">().all);
  add(c.template get<"restless">().all);
  add(c.template get<"by_slow">().all);
  add(c.template get<"delayed">().all);
  add(c.template get<"together">().all);
  add(c.template get<"moderate">().all);
  add(c.template get<"listener">().all);
  c.observed([&](const cca::observation& one) { all.push_back({0, one.values[0], one.origin, one.fresh}); });
  return all;
}

struct twins : cca::modes<cca::mode<"one", everything<1>>, cca::mode<"two", everything<2>>> {};

// The second mode reads more, and later, so more is stored; and it has another component before all others.
struct more : cca::graph<cca::rate<1000>,
                         cca::node<"slow", counter, cca::timed<10, 3>>,
                         cca::node<"fast", counter>,
                         cca::node<"delayed", timer, cca::timed<3>>,
                         cca::node<"old", timer, cca::timed<1>>,
                         cca::node<"spare", counter>,
                         cca::wire<"fast.y", "delayed.x", cca::delayed<6>>,
                         cca::wire<"slow.y", "old.x", cca::delayed<30>>> {};
struct less : cca::graph<cca::rate<1000>,
                         cca::node<"slow", counter, cca::timed<10, 3>>,
                         cca::node<"fast", counter>,
                         cca::node<"delayed", timer, cca::timed<3>>,
                         cca::wire<"fast.y", "delayed.x", cca::delayed<6>>> {};
struct less_or_more : cca::modes<cca::mode<"less", less>, cca::mode<"more", more>> {};

// One component at three clocks: every two beats, every five, and never.
template <class Strategy>
struct at_clock : cca::graph<cca::rate<1000>,
                             cca::node<"counts", counter, Strategy>,
                             cca::node<"reads", timer, cca::timed<1>>,
                             cca::node<"waits", timer, cca::restless>,
                             cca::wire<"counts.y", "reads.x", cca::latest>,
                             cca::wire<"counts.y", "waits.x">> {};
struct clocks : cca::modes<cca::mode<"two", at_clock<cca::timed<2>>>,
                           cca::mode<"five", at_clock<cca::timed<5>>>,
                           cca::mode<"never", at_clock<cca::inactive>>> {};

}  // namespace

TEST_SUITE("same state") {
  TEST_CASE("without a switch the results are those of the first graph") {
    auto one = started<everything<1>>();
    auto set = started<twins>();
    one.run(cca::for_beats<200>{});
    set.run(cca::for_beats<200>{});
    CHECK(seen_by(one) == seen_by(set));
    CHECK_EQ(set.mode(), "one");
  }

  TEST_CASE("between equal graphs a switch changes nothing") {
    auto expected = started<everything<1>>();
    expected.run(cca::for_beats<400>{});
    for (const int beats : {1, 2, 3, 5, 7, 10, 37}) {
      CAPTURE(beats);
      auto set = started<twins>();
      for (int k = 0; k < 400; ++k) {
        set.step();
        if (k % beats == 0) set.switch_to(set.mode() == "one" ? "two" : "one");
      }
      CHECK(seen_by(set) == seen_by(expected));
    }
  }

  TEST_CASE("what only another mode reads later is kept for it") {
    auto c = started<less_or_more>();
    c.run(cca::for_beats<57>{});
    c.switch_to<"more">();
    c.run(cca::for_beats<10>{});
    // `old` sees what `slow` published 30 beats before, in the other mode: in beat 57 that of beat 23.
    const auto& all = c.get<"old">().all;
    REQUIRE_EQ(all.size(), 10);
    CHECK_EQ(all.front().origin, 23'000'000);
    CHECK_EQ(all.front().value, doctest::Approx(3 + 1));
    CHECK_EQ(all.back().origin, 33'000'000);
    auto less_alone = started<less>();
    less_alone.run(cca::for_beats<67>{});
    CHECK(c.get<"delayed">().all == less_alone.get<"delayed">().all);
  }

  TEST_CASE(
      "a component whose clock differs fires by the beat index, and its dt is the time since it fired") {
    auto c = started<clocks>();
    c.run(cca::for_beats<8>{});  // counts fires in 0, 2, 4, 6
    CHECK_EQ(c.get<"counts">().value, 4);
    c.switch_to<"five">();
    c.run(cca::for_beats<13>{});  // 10, 15, 20
    CHECK_EQ(c.get<"counts">().value, 7);
    c.switch_to<"never">();
    c.run(cca::for_beats<20>{});
    CHECK_EQ(c.get<"counts">().value, 7);
    c.switch_to<"two">();
    c.run(cca::for_beats<2>{});  // 42
    CHECK_EQ(c.get<"counts">().value, 8);

    const auto& reads = c.get<"reads">().all;
    REQUIRE_EQ(reads.size(), 43);
    CHECK_EQ(reads[9].origin, 6'000'000);  // the newest is that of the other mode
    CHECK_FALSE(reads[8].fresh);
    CHECK_FALSE(reads[9].fresh);
    CHECK(reads[10].fresh);
    CHECK_EQ(reads[40].origin, 20'000'000);
    const auto& waits = c.get<"waits">().all;
    REQUIRE_EQ(waits.size(), 8);
    CHECK_EQ(waits[4].beat, 10);  // since beat 6: four beats of 1 ms
    CHECK_EQ(waits[4].value, doctest::Approx(5 + 4));
    CHECK_EQ(waits[7].beat, 42);
    CHECK_EQ(waits[7].value, doctest::Approx(8 + 22));
  }
}
