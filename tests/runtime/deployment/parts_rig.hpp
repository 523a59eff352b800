// Parts whose components run in several environments, and are stopped and started from others. A component
// sees in a deployment what it sees in one loop.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include <cca/deployment.hpp>

#include "../running.hpp"

namespace parts_test {

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

using test::running;

inline void check_equal(auto& one, auto& other) {
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

}  // namespace parts_test
