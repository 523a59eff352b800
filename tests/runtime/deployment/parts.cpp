// Parts that stop and start where their components, and those that stop them, run in different environments:
// in a fast run the bits are those of one loop.
#include <doctest/doctest.h>

#include <string>
#include <tuple>
#include <vector>

#include <cca/deployment.hpp>

#include "asking.hpp"

using deployment_test::asking;
using deployment_test::which;

namespace {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};

struct seen {
  std::int64_t beat;
  double x, dt;
  std::int64_t origin;
  bool fresh;
};
template <int Id>
struct noting {
  auto process(cca::in<"x", number> x, cca::beat now) -> cca::out<"y", number> {
    all.push_back({now.index(), x[cca::x{}], now.dt(), x.origin(), x.fresh()});
    return x[cca::x{}] * 1.25 + Id;
  }
  void on_start() { ++starts; }
  void on_stop() { ++stops; }
  std::vector<seen> all;
  int starts = 0, stops = 0;
};
struct source {
  auto process(cca::beat now) -> cca::out<"y", number> { return std::sin(static_cast<double>(now.index())); }
};
// In some beats it asks for both; it may fault.
template <int Seed, std::int64_t FaultsIn = -1>
struct orders {
  auto process(cca::in<"x", number> x, cca::beat now) -> std::tuple<cca::out<"y", number>,
                                                                    cca::stops<"mind.reach">,
                                                                    cca::starts<"mind.reach">,
                                                                    cca::stops<"mind">,
                                                                    cca::starts<"mind">,
                                                                    cca::fault> {
    const auto chance = [&](std::uint64_t salt, std::uint64_t of) {
      std::uint64_t h =
          (static_cast<std::uint64_t>(now.index()) * 2654435761u + Seed * 97u + salt) * 0x9e3779b97f4a7c15ull;
      return (h >> 33) % of == 0;
    };
    return {x[cca::x{}],   chance(1, 7), chance(2, 5),
            chance(3, 23), chance(4, 9), now.index() == FaultsIn ? cca::fault("as planned") : cca::fault()};
  }
};
using none = cca::delayed<1>;

struct reaching : cca::graph<cca::node<"aim", noting<1>>,
                             cca::node<"move", noting<2>, cca::timed<3>>,
                             cca::wire<"aim.y", "move.x", cca::delayed<1>>,
                             cca::expose<"aim.x", "x">,
                             cca::expose<"move.y", "y">> {};
struct mind : cca::graph<cca::node<"first", noting<3>, cca::timed<2>>,
                         cca::node<"reach", reaching, cca::stoppable<>>,
                         cca::wire<"first.y", "reach.x", cca::delayed<2>>,
                         cca::expose<"first.x", "x">,
                         cca::expose<"reach.y", "y">> {};
template <std::int64_t FaultsIn>
struct skilled : cca::graph<cca::rate<1000>,
                            cca::node<"source", source>,
                            cca::node<"orders", orders<1, FaultsIn>>,
                            cca::node<"others", orders<2>>,
                            cca::node<"mind", mind, cca::stoppable<>>,
                            cca::node<"last", noting<4>>,
                            cca::wire<"source.y", "orders.x", cca::delayed<1>>,
                            cca::wire<"orders.y", "others.x", cca::delayed<1>>,
                            cca::wire<"source.y", "mind.x", cca::delayed<1>>,
                            cca::wire<"mind.y", "last.x", cca::delayed<1>>> {};

// The components of a part, and those that stop it, each elsewhere.
template <std::int64_t FaultsIn = -1>
struct scattered : cca::deployment<skilled<FaultsIn>,
                                   cca::environment<"a", cca::nodes<"source", "mind.reach.aim">>,
                                   cca::environment<"b", cca::nodes<"orders", "mind.first">>,
                                   cca::environment<"c", cca::nodes<"others", "last">>,
                                   cca::environment<"d", cca::nodes<"mind.reach.move">>> {};
// The part is in one environment, which sleeps in most beats, and is stopped from another.
template <std::int64_t FaultsIn = -1>
struct in_two : cca::deployment<skilled<FaultsIn>,
                                cca::environment<"robot", cca::nodes<"source", "orders", "others", "last">>,
                                cca::environment<"mind", cca::other_nodes>> {};

template <class Played>
Played running() {
  Played c;
  c.load();
  c.start();
  return c;
}

void check_equal(auto& one, auto& other) {
  const auto same = [](const auto& a, const auto& b) {
    REQUIRE_EQ(a.all.size(), b.all.size());
    for (std::size_t i = 0; i < a.all.size(); ++i) {
      CAPTURE(a.all[i].beat);
      CHECK_EQ(a.all[i].beat, b.all[i].beat);
      CHECK_EQ(a.all[i].x, b.all[i].x);
      CHECK_EQ(a.all[i].dt, b.all[i].dt);
      CHECK_EQ(a.all[i].origin, b.all[i].origin);
      CHECK_EQ(a.all[i].fresh, b.all[i].fresh);
    }
    CHECK_EQ(a.starts, b.starts);
    CHECK_EQ(a.stops, b.stops);
  };
  same(one.template get<"mind.first">(), other.template get<"mind.first">());
  same(one.template get<"mind.reach.aim">(), other.template get<"mind.reach.aim">());
  same(one.template get<"mind.reach.move">(), other.template get<"mind.reach.move">());
  same(one.template get<"last">(), other.template get<"last">());
  CHECK_EQ(one.template is_stopped<"mind">(), other.template is_stopped<"mind">());
  CHECK_EQ(one.template is_stopped<"mind.reach">(), other.template is_stopped<"mind.reach">());
  CHECK_EQ(one.beat_index(), other.beat_index());
}

}  // namespace

TEST_SUITE("parts of deployments") {
  TEST_CASE_TEMPLATE("as in one loop", D, scattered<>, in_two<>) {
    auto loop = running<cca::controller<skilled<-1>>>();
    auto spread = running<cca::deployed<D>>();
    for (const std::int64_t beats : {1, 7, 300, 2, 1, 90}) {
      loop.run(cca::for_some_beats{beats});
      spread.run(cca::for_some_beats{beats});
      check_equal(loop, spread);
    }
    CHECK_GT(loop.template get<"mind.reach.aim">().stops, 20);
    CHECK_LT(loop.template get<"mind.reach.aim">().all.size(), 150);
  }

  TEST_CASE_TEMPLATE("between two runs", D, scattered<>, in_two<>) {
    auto loop = running<cca::controller<skilled<-1>>>();
    auto spread = running<cca::deployed<D>>();
    const auto both = [&](auto f) { f(loop), f(spread); };
    both([](auto& c) { c.run(cca::for_beats<20>{}); });
    both([](auto& c) { c.template stop<"mind">(); });
    both([](auto& c) { c.run(cca::for_beats<5>{}); });
    both([](auto& c) { c.start("mind"), c.stop("mind.reach"); });
    both([](auto& c) { c.run(cca::for_beats<40>{}); });
    check_equal(loop, spread);
    both([](auto& c) { c.stop(), c.start(); });
    both([](auto& c) { c.run(cca::for_beats<40>{}); });
    check_equal(loop, spread);
  }

  TEST_CASE_TEMPLATE("in `between` of a fast run, after what components ask for", D, scattered<>, in_two<>) {
    auto loop = running<cca::controller<skilled<-1>>>();
    auto spread = running<cca::deployed<D>>();
    const auto run = [](auto& c) {
      c.run(cca::for_beats<400>{}, cca::as_fast_as_possible(), [](auto& now) {
        const int what = which(now.beat_index(), 4);
        if (what == 0) now.template stop<"mind">();
        if (what == 1) now.template start<"mind">();
        if (what == 2) now.stop("mind.reach");
        if (what == 3) now.start("mind.reach");
        return true;
      });
    };
    run(loop);
    run(spread);
    check_equal(loop, spread);
  }

  TEST_CASE("from outside, a part stops in one and the same beat in all environments") {
    using D = scattered<>;
    constexpr const char* parts[] = {"mind", "mind.reach"};
    auto loop = running<cca::controller<skilled<-1>>>();
    auto spread = running<cca::deployed<D>>();
    loop.run(cca::for_beats<400>{}, cca::as_fast_as_possible(), [&](auto& now) {
      if (const int what = which(now.beat_index(), 4); what >= 0)
        what < 2 ? now.stop(parts[what]) : now.start(parts[what - 2]);
      return true;
    });
    cca::live_access live(spread);
    int asked = 0;
    const auto ask = [&](auto& at, auto& d) {
      const int what = which(d.beat_index(), 4);
      if (what < 0) return;
      ++asked;
      CHECK((what < 2 ? at.stop(parts[what]) : at.start(parts[what - 2])));
    };
    asking<D, decltype(ask)> outside{live, ask};
    spread.run(cca::for_beats<400>{}, cca::as_fast_as_possible(), outside);
    CHECK(live.is_taken());
    CHECK_EQ(live.refused_by(), "");
    CHECK_GT(asked, 20);
    check_equal(loop, spread);
  }

  TEST_CASE_TEMPLATE("a fault ends the beat for requests too", D, scattered<47>, in_two<47>) {
    auto loop = running<cca::controller<skilled<47>>>();
    auto spread = running<cca::deployed<D>>();
    for (int i = 0; i < 2; ++i) {
      loop.run(cca::for_beats<80>{});
      spread.run(cca::for_beats<80>{});
      check_equal(loop, spread);
      if (i == 0) {
        CHECK_EQ(spread.state(), cca::state::faulted);
        loop.resume();
        spread.resume();
      }
    }
    CHECK_EQ(spread.beat_index(), 128);
  }
}
