// The policy of an observe holds for each output that it names, as on a wire: where a component observes,
// over environments too, and where the graph itself does, so the program reads.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>
#include <cca/runtime/live/live_access.hpp>

#include "../running.hpp"

namespace {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};

struct counter {
  double y = 0;
  auto process(cca::beat) -> cca::out<"y", number> { return ++y; }
};
struct relay {
  auto process(cca::in<"x", number> x) -> cca::out<"y", number> { return 10 * x[cca::x{}]; }
};
// What it has heard, as text.
template <cca::fixed_string Pattern, class... Policy>
struct listener {
  std::string heard{};
  void process(cca::observe<Pattern, Policy...> all, cca::beat now) {
    std::ostringstream text;
    text << now.index() << ':';
    for (const auto& one : all)
      text << ' ' << one.path << ' ' << one.values[0] << ' ' << one.origin << ' ' << one.fresh;
    heard += text.str() + '\n';
  }
};

struct watched : cca::graph<cca::rate<1000>,
                            cca::node<"a", counter>,
                            cca::node<"b", relay>,
                            cca::wire<"a.y", "b.x", cca::delayed<1>>,
                            cca::observe<"a.y">,
                            cca::observe<"a.*", cca::queue<3>>,
                            cca::observe<"b.**", cca::delayed<2>>,
                            cca::observe<"b.y", cca::delayed<1>, cca::queue<2, cca::drop_newest>>> {};
struct watched_apart : cca::deployment<watched,
                                       cca::environment<"one", cca::nodes<"a">>,
                                       cca::environment<"two", cca::nodes<"b">>> {};
struct once_more : cca::graph<cca::rate<1000>, cca::node<"a", counter>, cca::observe<"a.*", cca::queue<3>>> {
};
// The same twice, and an input of the same component that has such a queue, too.
struct looped : cca::graph<cca::rate<1000>,
                           cca::node<"a", counter>,
                           cca::node<"b", relay, cca::timed<2>>,
                           cca::wire<"b.y", "b.x", cca::delayed<1>, cca::queue<3>>,
                           cca::observe<"a.y", cca::queue<3>>,
                           cca::observe<"a.*", cca::queue<3>>,
                           cca::observe<"b.y", cca::delayed<1>, cca::queue<3>>> {};
struct looped_modes : cca::modes<cca::mode<"one", looped>, cca::mode<"two", once_more>> {};
struct in_modes : cca::modes<cca::mode<"one", watched>, cca::mode<"two", once_more>> {};

// What a component publishes is of another space than what it reads. Nobody has published yet what `slow`
// tells: its reader begins with 5, but that is the wire's value.
struct three : cca::space<cca::number, cca::axes<cca::x, cca::y, cca::z>> {};
struct narrow {
  auto process(cca::in<"x", three> x) -> cca::out<"y", number> { return x[cca::z{}]; }
};
struct wide {
  auto process(cca::in<"x", number> x) -> cca::out<"y", three> {
    cca::out<"y", three> y;
    y.vector() << x[cca::x{}], 2 * x[cca::x{}], 3 * x[cca::x{}];
    return y;
  }
};
struct reader {
  void process(cca::in<"x", number>) {}
};
struct of_other_spaces : cca::graph<cca::rate<1000>,
                                    cca::node<"a", counter>,
                                    cca::node<"wide", wide>,
                                    cca::node<"narrow", narrow>,
                                    cca::node<"slow", counter, cca::timed<10, 9>>,
                                    cca::node<"reader", reader, cca::timed<1>>,
                                    cca::wire<"a.y", "wide.x">,
                                    cca::wire<"wide.y", "narrow.x">,
                                    cca::wire<"slow.y", "reader.x", cca::latest, cca::initial<5>>,
                                    cca::observe<"wide.y", cca::delayed<1>>,
                                    cca::observe<"narrow.*", cca::queue<2>>,
                                    cca::observe<"slow.y">> {};

template <class Played>
std::vector<std::string> told(Played& c) {
  std::vector<std::string> all;
  c.observed([&](const cca::observation& o) {
    std::ostringstream text;
    text << o.path << ' ' << o.values[0] << ' ' << o.fresh;
    all.push_back(text.str());
  });
  return all;
}

struct rare : cca::graph<cca::rate<1000>,
                         cca::node<"a", counter>,
                         cca::node<"slow", counter, cca::timed<5>>,
                         cca::observe<"slow.y", cca::delayed<2>, cca::queue<1, cca::drop_oldest>>> {};
struct rare_apart : cca::deployment<rare,
                                    cca::environment<"one", cca::nodes<"a">>,
                                    cca::environment<"two", cca::nodes<"slow">>> {};

// Slow and fast listeners of a component elsewhere.
struct heard
    : cca::graph<
          cca::rate<1000>,
          cca::node<"a", counter>,
          cca::node<"eyes", counter, cca::full_speed>,
          cca::node<"fast", listener<"a.*", cca::delayed<2>, cca::queue<3>>, cca::timed<1>>,
          cca::node<"slow", listener<"a.*", cca::delayed<1>, cca::queue<3, cca::drop_newest>>, cca::timed<3>>,
          cca::node<"free", listener<"eyes.*", cca::queue<4>>, cca::timed<2>>,
          cca::node<"events", listener<"eyes.*", cca::delayed<1>, cca::queue<4>>>> {};
struct heard_apart : cca::deployment<heard,
                                     cca::environment<"one", cca::nodes<"a">>,
                                     cca::environment<"eyes", cca::nodes<"eyes">, cca::free_running>,
                                     cca::environment<"rest", cca::other_nodes>> {};

using test::running;

}  // namespace

TEST_SUITE("policies of what is observed") {
  TEST_CASE("of the graph: a program reads over a wire of its own") {
    auto c = running<cca::controller<watched>>();
    c.run(cca::for_beats<5>{});
    // The newest; the oldest of three that wait; late by two beats, and one more where it is the input; the
    // first of two that were kept.
    using all = std::vector<std::string>;
    CHECK_EQ(told(c), all{"a.y 5 1", "a.y 3 1", "b.y 20 1", "b.x 2 1", "b.y 10 1"});
    CHECK_EQ(told(c), all{"a.y 5 1", "a.y 4 1", "b.y 20 1", "b.x 2 1", "b.y 20 1"});
    CHECK_EQ(told(std::as_const(c)), all{"a.y 5 1", "a.y 5 1", "b.y 20 1", "b.x 2 1", "b.y 20 0"});
    CHECK_EQ(told(c), all{"a.y 5 1", "a.y 5 1", "b.y 20 1", "b.x 2 1", "b.y 20 0"});
    CHECK_EQ(told(c), all{"a.y 5 1", "a.y 5 0", "b.y 20 1", "b.x 2 1", "b.y 20 0"});
    CHECK_EQ(c.dropped(), 3);
    auto d = running<cca::deployed<watched_apart>>();
    auto m = running<cca::controller<in_modes>>();
    auto one = running<cca::controller<watched>>();
    for (int i = 0; i < 9; ++i) {
      one.run(cca::for_some_beats{i});
      d.run(cca::for_some_beats{i});
      m.run(cca::for_some_beats{i});
      auto expected = told(one), is = told(d);
      CHECK_EQ(told(m), expected);
      std::ranges::sort(expected);
      std::ranges::sort(is);
      CHECK_EQ(is, expected);
    }
    CHECK_EQ(one.dropped(), d.dropped());
  }

  TEST_CASE("of the graph: what arrives while its environment has nothing to do is there") {
    auto one = running<cca::controller<rare>>();
    auto d = running<cca::deployed<rare_apart>>();
    for (int i = 0; i < 9; ++i) {
      CAPTURE(i);
      one.run(cca::for_some_beats{i});
      d.run(cca::for_some_beats{i});
      CHECK_EQ(told(d), told(one));
      CHECK_EQ(d.dropped(), one.dropped());
    }
  }

  TEST_CASE("of the graph: the space is that of the output, whatever its component reads") {
    auto c = running<cca::controller<of_other_spaces>>();
    c.run(cca::for_beats<4>{});
    std::vector<std::string> all;
    c.observed([&](const cca::observation& o) {
      std::ostringstream text;
      text << o.path;
      for (const double value : o.values) text << ' ' << value;
      text << ' ' << o.axes().size() << ' ' << (o.origin == cca::never);
      all.push_back(text.str());
    });
    CHECK_EQ(all, std::vector<std::string>{"slow.y 0 1 1", "wide.y 3 6 9 3 0", "narrow.y 9 1 0"});
  }

  TEST_CASE("of the graph: each pattern has a queue of its own, in modes too") {
    auto one = running<cca::controller<looped>>();
    auto m = running<cca::controller<looped_modes>>();
    for (int i = 0; i < 6; ++i) {
      one.run(cca::for_some_beats{i});
      m.run(cca::for_some_beats{i});
      CHECK_EQ(told(m), told(one));
    }
    CHECK_EQ(one.dropped(), m.dropped());
  }

  TEST_CASE("of the graph: another thread sees the newest sample, and takes nothing") {
    auto c = running<cca::controller<watched>>();
    cca::live_access live(c);
    c.run(cca::for_beats<4>{}, cca::as_fast_as_possible{}, live);
    REQUIRE(live.newest("a.y"));
    CHECK_EQ(live.newest("a.y")->values[0], 4);
    CHECK_EQ(live.newest("b.y")->values[0], 30);
    CHECK_EQ(told(c)[1], "a.y 2 1");
  }

  TEST_CASE("of a component: a queue over environments loses what it loses in one loop") {
    auto one = running<cca::controller<heard>>();
    auto all = running<cca::deployed<heard_apart>>();
    const auto check = [&] {
      CHECK_EQ(one.get<"fast">().heard, all.get<"fast">().heard);
      CHECK_EQ(one.get<"slow">().heard, all.get<"slow">().heard);
      CHECK_EQ(one.get<"free">().heard, all.get<"free">().heard);
      CHECK_EQ(one.get<"events">().heard, all.get<"events">().heard);
      CHECK_EQ(one.dropped(), all.dropped());
    };
    for (const int beats : {1, 2, 7, 40}) {
      one.run(cca::for_some_beats{beats});
      all.run(cca::for_some_beats{beats});
      check();
    }
    CHECK_GT(one.dropped(), 20);
  }
}
