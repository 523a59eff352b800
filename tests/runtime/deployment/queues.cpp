// Queues and merged wires between environments: what enters, when, in which order, and what is lost.
#include <doctest/doctest.h>

#include <chrono>
#include <string_view>
#include <thread>
#include <vector>

#include <cca/cca.hpp>
#include <cca/deployment.hpp>

namespace {

struct axis : cca::dimension<"axis"> {};
struct value : cca::space<cca::number, cca::axes<axis>> {};

template <int Base>
struct count {
  auto process(cca::beat now) -> cca::out<"y", value> { return Base + static_cast<double>(now.index()); }
};
template <int Base, int N>
struct sometimes {
  auto process(cca::beat now) -> cca::maybe<"y", value> {
    if (now.index() % N != 0) return {};
    return Base + static_cast<double>(now.index());
  }
};
struct seen {
  std::int64_t beat;
  double value;
  std::int64_t origin;
  bool fresh;
  std::int64_t dropped;
  bool operator==(const seen&) const = default;
};
struct look {
  std::vector<seen> log;
  void process(cca::in<"x", value> x, cca::beat now) {
    log.push_back({now.index(), x[axis{}], x.origin(), x.fresh(), x.dropped()});
  }
};
// Faults in this beat.
template <int Beat>
struct faults {
  auto process(cca::beat now) -> cca::fault {
    return now.index() == Beat ? cca::fault("as planned") : cca::fault();
  }
};

template <class Played>
Played played(int beats, int resumes = 0) {
  Played p;
  p.load();
  p.start();
  while (p.beat_index() < beats) {
    p.run(cca::for_some_beats{beats - p.beat_index()});
    if (p.state() != cca::state::faulted) continue;
    if (resumes-- == 0) break;
    p.resume();
  }
  return p;
}

template <cca::fixed_string Name, cca::fixed_string... Nodes>
using some = cca::environment<Name, cca::nodes<Nodes...>>;
using rest = cca::environment<"rest", cca::other_nodes>;

// ---- merged from everywhere, a slow reader, a queue that is filled while its environment sleeps ----

struct everything
    : cca::graph<cca::rate<1000>,
                 cca::node<"a", count<100>, cca::timed<2>>,
                 cca::node<"b", sometimes<200, 3>>,
                 cca::node<"c", count<300>, cca::timed<5, 1>>,
                 cca::node<"r", look>,
                 cca::node<"slow", look, cca::timed<100, 7>>,
                 cca::node<"rare", look, cca::timed<60>>,
                 cca::wire<"a.y", "r.x", cca::merged<3>, cca::delayed<1>>,
                 cca::wire<"b.y", "r.x", cca::delayed<3>, cca::merged<3>>,
                 cca::wire<"c.y", "r.x", cca::merged<3>, cca::delayed<1>>,
                 cca::wire<"a.y", "slow.x", cca::queue<90, cca::drop_newest>, cca::delayed<2>>,
                 cca::wire<"b.y", "rare.x", cca::merged<9, cca::drop_oldest>, cca::delayed<2>>,
                 cca::wire<"c.y", "rare.x", cca::merged<9, cca::drop_oldest>, cca::delayed<2>>> {};
struct by_reader : cca::deployment<everything, some<"one", "a", "b", "c">, rest> {};
struct by_writer
    : cca::deployment<everything, some<"one", "a">, some<"two", "b", "r">, some<"three", "slow">, rest> {};
struct slow_first : cca::deployment<everything, some<"one", "slow", "rare">, some<"two", "b", "c">, rest> {};

template <class D>
void check_everything(const cca::controller<everything>& expected) {
  for (int again = 0; again < 5; ++again) {
    const auto d = played<cca::deployed<D>>(1000);
    CHECK(d.template get<"r">().log == expected.get<"r">().log);
    CHECK(d.template get<"slow">().log == expected.get<"slow">().log);
    CHECK(d.template get<"rare">().log == expected.get<"rare">().log);
    CHECK(d.dropped() == expected.dropped());
    CHECK(d.template dropped<"slow.x">() == expected.dropped<"slow.x">());
  }
}

// ---- a full queue that rejects what arrives ----

template <class... Items>
struct overflowing : cca::graph<cca::rate<1000>,
                                cca::node<"a", sometimes<100, 1>>,
                                cca::node<"b", count<200>>,
                                cca::node<"p", look, cca::timed<50, 49>>,
                                cca::node<"q", look, cca::timed<50, 49>>,
                                cca::node<"early", look>,
                                cca::node<"late", look>,
                                cca::wire<"a.y", "p.x", cca::queue<7, cca::reject>, cca::delayed<2>>,
                                cca::wire<"b.y", "early.x", cca::delayed<1>>,
                                cca::wire<"b.y", "late.x", cca::delayed<4>>,
                                Items...> {};
struct one_overflows : overflowing<cca::wire<"a.y", "q.x", cca::queue<20>, cca::delayed<2>>> {};
struct both_overflow : overflowing<cca::wire<"a.y", "q.x", cca::queue<8, cca::reject>, cca::delayed<1>>> {};

template <class Graph>
struct overflow_apart
    : cca::deployment<Graph, some<"one", "a", "late">, some<"two", "q">, some<"three", "p", "early">, rest> {
};
template <class Graph>
struct overflow_with_writer : cca::deployment<Graph, some<"one", "b", "q">, rest> {};

template <class Deployment, class Graph>
void check_overflow(int resumes) {
  const auto c = played<cca::controller<Graph>>(60, resumes);
  for (int again = 0; again < 10; ++again) {
    const auto d = played<cca::deployed<Deployment>>(60, resumes);
    CHECK(d.state() == c.state());
    CHECK(d.beat_index() == c.beat_index());
    CHECK(d.fault_path() == c.fault_path());
    CHECK(std::string_view(d.fault().reason()) == std::string_view(c.fault().reason()));
    CHECK(d.template get<"p">().log == c.template get<"p">().log);
    CHECK(d.template get<"q">().log == c.template get<"q">().log);
    CHECK(d.template get<"early">().log == c.template get<"early">().log);
    CHECK(d.template get<"late">().log == c.template get<"late">().log);
    CHECK(d.dropped() == c.dropped());
  }
}

// ---- a beat that a fault cuts ----

struct cut : cca::graph<cca::rate<1000>,
                        cca::node<"before", count<100>>,
                        cca::node<"fault", faults<20>>,
                        cca::node<"after", count<200>>,
                        cca::node<"r", look>,
                        cca::node<"s", look, cca::timed<1>>,
                        cca::wire<"before.y", "r.x", cca::merged<64>, cca::delayed<1>>,
                        cca::wire<"after.y", "r.x", cca::merged<64>, cca::delayed<2>>,
                        cca::wire<"after.y", "s.x", cca::delayed<2>>> {};
struct cut_apart : cca::deployment<cut, some<"one", "before", "fault">, some<"two", "after">, rest> {};

// ---- in a wall-clock run ----

// Stands still in this beat.
template <int Beat, int Milliseconds>
struct stands_still {
  void process(cca::beat now) {
    if (now.index() == Beat) std::this_thread::sleep_for(std::chrono::milliseconds(Milliseconds));
  }
};
struct held_up : cca::graph<cca::rate<1000>,
                            cca::node<"a", count<0>>,
                            cca::node<"block", stands_still<50, 60>>,
                            cca::node<"r", look, cca::timed<1>>,
                            cca::node<"s", look, cca::timed<1>>,
                            cca::wire<"a.y", "r.x", cca::queue<100>, cca::delayed<1>>,
                            cca::wire<"a.y", "s.x", cca::queue<4>, cca::delayed<1>>> {};
struct held_up_apart : cca::deployment<held_up, some<"one", "a">, rest, cca::tolerate<1000>> {};

}  // namespace

TEST_SUITE("queues") {
  TEST_CASE("merged and queued samples cross environments as in one loop") {
    const auto c = played<cca::controller<everything>>(1000);
    REQUIRE(c.get<"r">().log.size() > 900);
    REQUIRE(c.dropped<"r.x">() > 0);
    REQUIRE(c.dropped<"rare.x">() > 0);
    REQUIRE(c.dropped<"slow.x">() > 0);
    check_everything<by_reader>(c);
    check_everything<by_writer>(c);
    check_everything<slow_first>(c);
  }

  TEST_CASE("a queue that rejects faults in the beat of the arrival, before all calls of all environments") {
    const auto c = played<cca::controller<one_overflows>>(60);
    CHECK(c.beat_index() == 10);  // 7 have arrived in beats 2 to 8
    CHECK(c.fault_path() == "p");
    CHECK(c.get<"early">().log.size() == 8);
    check_overflow<overflow_apart<one_overflows>, one_overflows>(0);
    check_overflow<overflow_with_writer<one_overflows>, one_overflows>(0);
  }
  TEST_CASE("two queues that reject in one beat: the first in the order of the inputs is the cause") {
    const auto c = played<cca::controller<both_overflow>>(60);
    CHECK(c.fault_path() == "p");
    CHECK(c.dropped() == 2);
    check_overflow<overflow_apart<both_overflow>, both_overflow>(0);
    check_overflow<overflow_with_writer<both_overflow>, both_overflow>(0);
  }
  TEST_CASE("after resume() what was under way goes on arriving") {
    check_overflow<overflow_apart<one_overflows>, one_overflows>(3);
    check_overflow<overflow_apart<both_overflow>, both_overflow>(3);
    check_overflow<overflow_with_writer<both_overflow>, both_overflow>(3);
  }

  TEST_CASE("a beat that a fault cuts: a queue gets what was published, and nothing else") {
    const auto c = played<cca::controller<cut>>(60, 1);
    std::vector<double> from_after;
    for (const auto& one : c.get<"r">().log)
      if (one.value >= 200) from_after.push_back(one.value);
    REQUIRE(from_after.size() > 25);  // the rest waits still
    for (std::size_t i = 0; i < from_after.size(); ++i)
      CHECK(from_after[i] == 200 + static_cast<double>(i < 20 ? i : i + 1));  // nothing in beat 20
    // In beat 22 an input without a queue sees the sample of beat 19 again: beat 20 counts as done.
    CHECK(c.get<"s">().log[21].value == 219);
    CHECK(c.get<"s">().log[21].fresh);
    for (int again = 0; again < 10; ++again) {
      const auto d = played<cca::deployed<cut_apart>>(60, 1);
      CHECK(d.get<"r">().log == c.get<"r">().log);
      CHECK(d.get<"s">().log == c.get<"s">().log);
    }
  }

  TEST_CASE("in a wall-clock run a reader that stands still loses what its queue loses, not more") {
    cca::deployed<held_up_apart> d;
    d.load();
    d.start();
    d.run(cca::for_<0.3>{}, cca::at_wall_clock());
    REQUIRE(d.state() == cca::state::started);
    REQUIRE(d.lost_periods() >= 20);  // the blocked environment did not make them up
    // What a reader sees is in order, and what is missing has been counted.
    const auto check = [](const std::vector<seen>& all) {
      double newest = -1;
      std::int64_t missing = 0;
      for (const auto& one : all) {
        if (!one.fresh) continue;
        CHECK(one.value > newest);
        missing += static_cast<std::int64_t>(one.value - newest) - 1;
        newest = one.value;
        CHECK(missing == one.dropped);
      }
      return missing;
    };
    CHECK(check(d.get<"s">().log) == d.dropped<"s.x">());
    CHECK(d.dropped<"s.x">() >= 20);  // it has room for 4
    CHECK(check(d.get<"r">().log) == d.dropped<"r.x">());
    CHECK(d.get<"r">().log.size() > 100);
    if (d.lost_periods() < 90) CHECK(d.dropped<"r.x">() == 0);  // it has room for 100
  }
}
