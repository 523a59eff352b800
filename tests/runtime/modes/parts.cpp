// Inner graphs that stop as a whole, and a switch of modes: what both modes have stays stopped, what comes is
// started, unless the part around it rests.
#include <doctest/doctest.h>

#include <string>
#include <tuple>
#include <vector>

#include <cca/modes.hpp>

#include "../core/counting.hpp"

using namespace core_test;

namespace {

using beats = std::vector<std::int64_t>;

struct noting {
  auto process(cca::in<"x", reading> x, cca::beat now) -> cca::out<"y", reading> {
    all.push_back(now.index());
    dts.push_back(now.dt());
    news.push_back(x.fresh());
    return x[cca::x{}] + 1;
  }
  void on_start() { ++starts; }
  void on_stop() { ++stops; }
  beats all;
  std::vector<double> dts;
  std::vector<bool> news;
  int starts = 0, stops = 0;
};
struct orders {
  auto process(cca::in<"x", reading>, cca::beat now)
      -> std::tuple<cca::stops<"reach">, cca::starts<"reach">, cca::switch_to<"two">> {
    return {now.index() == 24, now.index() == 27, now.index() == 40};
  }
};

// `shared` is in both modes at two clocks, `steady` at one; `mine` in one of them.
template <int N, class... More>
struct reaching : cca::graph<cca::node<"shared", noting, cca::timed<N>>,
                             cca::node<"steady", noting, cca::timed<3>>,
                             cca::wire<"shared.y", "steady.x", cca::latest>,
                             cca::expose<"shared.x", "x">,
                             More...> {};
template <class Reach, class... More>
struct mode : cca::graph<cca::rate<1000>,
                         cca::node<"counter", counter>,
                         cca::node<"orders", orders>,
                         cca::wire<"counter.y", "orders.x">,
                         cca::node<"reach", Reach, cca::stoppable<>>,
                         cca::wire<"counter.y", "reach.x", cca::latest>,
                         More...> {};
struct one : mode<reaching<1, cca::node<"mine", noting, cca::timed<1>>, cca::wire<"shared.y", "mine.x">>,
                  cca::node<"walk", noting, cca::stoppable<>>,
                  cca::wire<"counter.y", "walk.x">> {};
struct two : mode<reaching<2>> {};
struct both : cca::modes<cca::mode<"one", one>, cca::mode<"two", two>> {};

// All clocks are known in both modes, and one of them lacks the part.
struct with_part : cca::graph<cca::rate<1000>,
                              cca::node<"slow", counter, cca::timed<10>>,
                              cca::node<"walk", noting, cca::stoppable<cca::timed<3>>>,
                              cca::wire<"slow.y", "walk.x", cca::latest>> {};
struct without_part : cca::graph<cca::rate<1000>, cca::node<"slow", counter, cca::timed<10>>> {};
struct known_clocks : cca::modes<cca::mode<"with", with_part>, cca::mode<"without", without_part>> {};

}  // namespace

TEST_SUITE("parts in modes") {
  TEST_CASE("what both modes have stays stopped, and what comes waits for the part around it") {
    auto c = started<both>();
    auto& shared = c.get<"reach.shared">();
    auto& steady = c.get<"reach.steady">();
    auto& mine = c.get<"reach.mine">();
    c.run(cca::for_beats<5>{});
    c.stop<"reach">();
    CHECK_EQ(mine.stops, 1);
    c.switch_to("two");
    CHECK(c.is_stopped<"reach">());
    CHECK_EQ(mine.stops, 1);  // it rested
    c.run(cca::for_beats<5>{});
    c.switch_to("one");
    CHECK_EQ(mine.starts, 1);
    c.run(cca::for_beats<2>{});
    CHECK_EQ(shared.all, beats{0, 1, 2, 3, 4});
    c.start("reach");
    CHECK_EQ(mine.starts, 2);
    c.run(cca::for_beats<3>{});
    CHECK_EQ(shared.all, beats{0, 1, 2, 3, 4, 12, 13, 14});
    CHECK_EQ(mine.all, beats{0, 1, 2, 3, 4, 12, 13, 14});
    CHECK_EQ(steady.all, beats{0, 3, 12});
    CHECK_EQ(steady.dts, std::vector<double>{0.003, 0.003, 0.003});
    c.switch_to("two");
    c.run(cca::for_beats<4>{});
    CHECK_EQ(shared.all, beats{0, 1, 2, 3, 4, 12, 13, 14, 16, 18});
    CHECK_EQ(steady.all, beats{0, 3, 12, 15, 18});
    CHECK_EQ(shared.dts,
             std::vector<double>{0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.002, 0.002});
    CHECK_EQ(mine.stops, 2);
  }

  TEST_CASE("what has arrived before a part starts is not fresh, where all clocks are known") {
    auto c = started<known_clocks>();
    auto& walk = c.get<"walk">();
    c.run(cca::for_beats<11>{});
    c.stop<"walk">();
    c.run(cca::for_beats<1>{});
    c.start<"walk">();
    c.run(cca::for_beats<10>{});
    CHECK_EQ(walk.all, beats{0, 3, 6, 9, 12, 15, 18, 21});
    CHECK_EQ(walk.news, std::vector<bool>{true, false, false, false, false, false, false, true});
  }

  TEST_CASE("components stop and start parts, and switch to a mode") {
    auto c = started<both>();
    auto& steady = c.get<"reach.steady">();
    c.run(cca::for_beats<50>{});
    CHECK_EQ(c.mode(), "two");
    CHECK_EQ(steady.all, beats{0, 3, 6, 9, 12, 15, 18, 21, 24, 30, 33, 36, 39, 42, 45, 48});
    CHECK_EQ(c.get<"reach.mine">().all.size(), 38);  // 41 beats in its mode, without three
    CHECK_EQ(c.get<"reach.shared">().all.back(), 48);
  }

  TEST_CASE("a part that the next mode lacks is started when it comes again") {
    auto c = started<both>();
    c.stop<"walk">();
    CHECK_EQ(c.get<"walk">().stops, 1);
    c.switch_to("two");
    CHECK_EQ(
        words_of([&] { c.start("walk"); }),
        "cca::controller: start(`walk`) is refused in the mode `two`, which has no such component: it is "
        "started when a mode begins that has it");
    c.run(cca::for_beats<3>{});
    c.switch_to("one");
    CHECK_FALSE(c.is_stopped<"walk">());
    c.run(cca::for_beats<3>{});
    CHECK_EQ(c.get<"walk">().all, beats{3, 4, 5});
  }
}
