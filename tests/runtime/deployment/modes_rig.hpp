// A set of modes whose components, wires, clocks, queues and parts differ as much as they may, for
// deployments of it: what its components see in a deployment is what they see in one loop.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>

namespace modes_test {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};

struct seen {
  std::int64_t beat;
  double x, dt;
  std::int64_t origin;
  bool fresh;
  bool operator==(const seen&) const = default;
};

// By the number of the beat alone, so that it is the same wherever and whenever the component runs.
inline bool chance(cca::beat now, std::uint64_t salt, std::uint64_t of) {
  std::uint64_t h = (static_cast<std::uint64_t>(now.index()) * 2654435761u + salt) * 0x9e3779b97f4a7c15ull;
  return (h >> 33) % of == 0;
}

struct journal {
  void on_start() { all.push_back({-1, 0, 0, 0, false}); }
  void on_stop() { all.push_back({-2, 0, 0, 0, false}); }
  void note(cca::beat now, double x, std::int64_t origin, bool fresh) {
    all.push_back({now.index(), x, now.dt(), origin, fresh});
  }
  std::vector<seen> all;
};
template <int Id>
struct noting : journal {
  auto process(cca::in<"x", number> x, cca::beat now) -> cca::out<"y", number> {
    note(now, x[cca::x{}], x.origin(), x.fresh());
    return x[cca::x{}] * 0.75 + Id + 0.001 * static_cast<double>(all.size());
  }
};
template <int Id>
struct seldom : journal {
  auto process(cca::in<"x", number> x, cca::beat now) -> cca::maybe<"y", number> {
    note(now, x[cca::x{}], x.origin(), x.fresh());
    if (chance(now, Id, 3)) return {};
    return x[cca::x{}] * 0.5 + Id;
  }
};
struct pair : journal {
  auto process(cca::in<"a", number> a, cca::in<"b", number> b, cca::beat now) -> cca::out<"y", number> {
    note(now, a[cca::x{}] + 1e3 * b[cca::x{}], a.origin() + b.origin(), a.fresh() != b.fresh());
    return a[cca::x{}] + b[cca::x{}];
  }
};
struct listener : journal {
  void process(cca::observe<"mind.**.*|queued.**", cca::delayed<2>> scope, cca::beat now) {
    for (const auto& one : scope) note(now, one.values[0], one.origin, one.fresh);
  }
};
struct robot : journal {
  auto sense(cca::beat now) -> cca::out<"y", number> { return std::sin(static_cast<double>(now.index())); }
  void act(cca::in<"x", number> x, cca::beat now) { note(now, x[cca::x{}], x.origin(), x.fresh()); }
  void on_fault() { all.push_back({-3, 0, 0, 0, false}); }
};
struct every_third {
  int come = 0;
  static constexpr void add_name(auto& text) { text << "every_third"; }
  template <class Inputs>
  bool fires(cca::beat, const Inputs& in) {
    come += in.template arrivals<"x">();
    if (come < 3) return false;
    come = 0;
    return true;
  }
};
// Asks for other modes in some beats, and may fault in one.
template <int Seed, cca::fixed_string One, cca::fixed_string Other>
struct orders : journal {
  bool asks = true;
  std::int64_t faults_in = -1;

  auto process(cca::in<"x", number> x, cca::beat now)
      -> std::tuple<cca::out<"y", number>, cca::switch_to<One>, cca::switch_to<Other>, cca::fault> {
    note(now, x[cca::x{}], x.origin(), x.fresh());
    return {x[cca::x{}] + Seed, asks && chance(now, 300 + Seed, 21), asks && chance(now, 400 + Seed, 22),
            now.index() == faults_in ? cca::fault("as planned") : cca::fault()};
  }
};
// Asks for parts.
struct stopper : journal {
  auto process(cca::in<"x", number> x, cca::beat now)
      -> std::tuple<cca::stops<"mind.deep">, cca::starts<"mind.deep">> {
    note(now, x[cca::x{}], x.origin(), x.fresh());
    return {chance(now, 100, 9), chance(now, 200, 6)};
  }
};

// `deep` is a part that has nodes in several environments. `both` has other clocks in another mode.
template <class Clock, class... More>
struct deep : cca::graph<cca::node<"both", noting<1>, Clock>,
                         cca::node<"steady", noting<2>, cca::timed<3>>,
                         cca::wire<"both.y", "steady.x", cca::delayed<2>>,
                         cca::expose<"both.x", "x">,
                         cca::expose<"steady.y", "y">,
                         More...> {};
template <class Deep, class... More>
struct mind : cca::graph<cca::node<"deep", Deep, cca::stoppable<>>, cca::expose<"deep.x", "x">, More...> {};

struct walk
    : cca::graph<
          cca::rate<1000>,
          cca::node<"robot", robot>,
          cca::node<"asks", orders<1, "stand", "fall">>,
          cca::node<"maybe", seldom<5>>,
          cca::node<"mind",
                    mind<deep<cca::timed<2>, cca::node<"mine", noting<3>>, cca::wire<"steady.y", "mine.x">>>>,
          cca::node<"plan", noting<4>>,
          cca::node<"queued", noting<6>, cca::timed<2>>,
          cca::node<"slow", noting<7>, cca::timed<5, 3>>,
          cca::node<"after_slow", noting<8>>,
          cca::node<"pair", pair, cca::any_of<cca::coordinated, cca::timeout<7>>>,
          cca::node<"third", noting<9>, every_third>,
          cca::node<"listener", listener>,
          cca::node<"stopper", stopper>,
          cca::wire<"maybe.y", "stopper.x", cca::delayed<1>>,
          cca::wire<"plan.y", "robot.x", cca::delayed<1>, cca::initial<3>>,
          cca::wire<"robot.y", "asks.x">,
          cca::wire<"robot.y", "maybe.x">,
          cca::wire<"asks.y", "mind.x", cca::delayed<1>>,
          cca::wire<"maybe.y", "plan.x", cca::delayed<1>>,
          cca::wire<"maybe.y", "queued.x", cca::delayed<2>, cca::queue<3>>,
          cca::wire<"robot.y", "slow.x", cca::delayed<4>>,
          cca::wire<"slow.y", "after_slow.x", cca::delayed<1>>,
          cca::wire<"robot.y", "pair.a", cca::delayed<2>>,
          cca::wire<"maybe.y", "pair.b", cca::delayed<3>>,
          cca::wire<"maybe.y", "third.x", cca::delayed<1>>,
          cca::observe<"plan.y">,
          cca::observe<"queued.*">> {};

struct stand : cca::graph<cca::rate<1000>,
                          cca::node<"robot", robot>,
                          cca::node<"maybe", seldom<5>>,
                          cca::node<"also_asks", orders<2, "walk", "fall">>,
                          cca::node<"mind", mind<deep<cca::timed<3, 1>>>>,
                          cca::node<"stance", noting<10>, cca::stoppable<>>,
                          cca::node<"queued", noting<6>, cca::timed<2>>,
                          cca::node<"old", noting<11>, cca::timed<1>>,
                          cca::node<"stopper", stopper>,
                          cca::wire<"maybe.y", "stopper.x", cca::delayed<1>>,
                          cca::node<"after_slow", noting<8>>,
                          cca::node<"slow", noting<7>, cca::timed<5, 3>>,
                          cca::node<"moderate", pair, cca::moderate>,
                          cca::node<"third", noting<9>, every_third>,
                          cca::wire<"stance.y", "robot.x", cca::delayed<2>>,
                          cca::wire<"robot.y", "maybe.x">,
                          cca::wire<"robot.y", "also_asks.x", cca::delayed<1>>,
                          cca::wire<"also_asks.y", "mind.x", cca::delayed<1>>,
                          cca::wire<"maybe.y", "stance.x", cca::delayed<1>>,
                          cca::wire<"maybe.y", "queued.x", cca::delayed<2>, cca::queue<3>>,
                          cca::wire<"robot.y", "old.x", cca::delayed<9>>,
                          cca::wire<"robot.y", "slow.x", cca::delayed<4>>,
                          cca::wire<"slow.y", "after_slow.x", cca::delayed<1>>,
                          cca::wire<"stance.y", "moderate.a", cca::delayed<1>>,
                          cca::wire<"maybe.y", "moderate.b", cca::delayed<1>>,
                          cca::wire<"stance.y", "third.x", cca::delayed<1>>,
                          cca::observe<"stance.y">> {};

struct fall : cca::graph<cca::rate<1000>,
                         cca::node<"robot", robot>,
                         cca::node<"asks", orders<1, "stand", "fall">>,
                         cca::node<"queued", noting<6>, cca::timed<3>>,
                         cca::node<"also_asks", orders<2, "walk", "fall">>,
                         cca::node<"plan", noting<4>>,
                         cca::node<"stance", noting<10>, cca::stoppable<>>,
                         cca::node<"rare", noting<12>, cca::timed<11>>,
                         cca::node<"listener", listener>,
                         cca::wire<"plan.y", "robot.x", cca::delayed<3>>,
                         cca::wire<"robot.y", "asks.x">,
                         cca::wire<"asks.y", "also_asks.x", cca::delayed<1>>,
                         cca::wire<"also_asks.y", "plan.x", cca::delayed<1>>,
                         cca::wire<"plan.y", "queued.x", cca::merged<3>, cca::delayed<1>>,
                         cca::wire<"asks.y", "queued.x", cca::merged<3>, cca::delayed<4>>,
                         cca::wire<"rare.y", "stance.x", cca::delayed<2>>,
                         cca::wire<"robot.y", "rare.x", cca::delayed<3>>> {};

struct moves : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>, cca::mode<"fall", fall>> {};

struct in_two : cca::deployment<moves,
                                cca::environment<"robot", cca::nodes<"robot", "asks", "maybe", "queued">>,
                                cca::environment<"mind", cca::other_nodes>> {};
struct in_four
    : cca::deployment<
          moves,
          cca::environment<"robot", cca::nodes<"robot", "asks", "maybe", "mind.deep.both", "third">>,
          cca::environment<"mind", cca::nodes<"also_asks", "mind.deep.steady", "mind.deep.mine", "slow">>,
          cca::environment<"plans", cca::nodes<"plan", "stance", "pair", "after_slow">>,
          cca::environment<"rest", cca::other_nodes>> {};

template <class Played>
void begin(Played& c) {
  c.load();
  c.start();
}

template <class A, class B>
void check_equal(A& one, B& other) {
  const auto same = [](const std::string& path, const journal& a, const journal& b) {
    CAPTURE(path);
    std::size_t i = 0;
    while (i < a.all.size() && i < b.all.size() && a.all[i] == b.all[i]) ++i;
    CAPTURE(i);
    if (i < a.all.size() && i < b.all.size()) {
      CHECK_EQ(a.all[i].beat, b.all[i].beat);
      CHECK_EQ(a.all[i].x, b.all[i].x);
      CHECK_EQ(a.all[i].dt, b.all[i].dt);
      CHECK_EQ(a.all[i].origin, b.all[i].origin);
      CHECK_EQ(a.all[i].fresh, b.all[i].fresh);
    }
    REQUIRE_EQ(a.all.size(), b.all.size());
    REQUIRE_EQ(i, a.all.size());
  };
  CHECK_EQ(one.mode(), other.mode());
  CHECK_EQ(one.beat_index(), other.beat_index());
  CHECK_EQ(one.state(), other.state());
#define CCA_SAME(path) same(path, one.template get<path>(), other.template get<path>())
  CCA_SAME("robot");
  CCA_SAME("asks");
  CCA_SAME("maybe");
  CCA_SAME("mind.deep.both");
  CCA_SAME("mind.deep.steady");
  CCA_SAME("mind.deep.mine");
  CCA_SAME("plan");
  CCA_SAME("queued");
  CCA_SAME("slow");
  CCA_SAME("after_slow");
  CCA_SAME("pair");
  CCA_SAME("third");
  CCA_SAME("listener");
  CCA_SAME("also_asks");
  CCA_SAME("stance");
  CCA_SAME("old");
  CCA_SAME("moderate");
  CCA_SAME("rare");
  CCA_SAME("stopper");
#undef CCA_SAME
  std::vector<std::tuple<std::string, double, std::int64_t, bool>> a, b;
  one.observed([&](const cca::observation& o) { a.emplace_back(o.path, o.values[0], o.origin, o.fresh); });
  other.observed([&](const cca::observation& o) { b.emplace_back(o.path, o.values[0], o.origin, o.fresh); });
  CHECK_EQ(a.size(), b.size());
  CHECK(a == b);
  CHECK_EQ(one.dropped(), other.dropped());
}

}  // namespace modes_test
