// Semantics, "Time" and "One beat", sentence by sentence.
#include <string>

#include "by_hand.hpp"

using namespace by_hand;

namespace {

using ms1 = cca::rate<1000>;

struct clock_reader {
  std::vector<std::int64_t> indices, times;
  std::vector<double> dts;
  void process(cca::beat now) {
    indices.push_back(now.index());
    times.push_back(now.time());
    dts.push_back(now.dt());
  }
};

// Records its name in the order of calls.
template <char Name>
struct writes_name {
  std::string* to = nullptr;
  auto process(cca::optional_in<"x", value>, cca::optional_in<"z", value>) -> cca::out<"y", value> {
    *to += Name;
    return 0.0;
  }
};

template <char Sense, char Act>
struct body {
  std::string* to = nullptr;
  auto sense() -> cca::out<"y", value> {
    *to += Sense;
    return 0.0;
  }
  void act(cca::optional_in<"u", value>) { *to += Act; }
};

}  // namespace

TEST_SUITE("semantics by hand: time and beats") {
  TEST_CASE("beat k is at k * T - T is held as integer nanoseconds, rounded down") {
    struct g : cca::graph<cca::rate<3>, cca::node<"c", clock_reader, cca::timed<2>>> {};
    const auto c = after<g>(5);
    CHECK(c.get<"c">().indices == beats{0, 2, 4});
    CHECK(c.get<"c">().times == beats{0, 666666666, 1333333332});
    CHECK(c.get<"c">().dts == std::vector{0.666666666, 0.666666666, 0.666666666});
  }

  TEST_CASE("T comes from the fastest rate of the spaces where the graph states none") {
    struct slow : cca::space<cca::number, cca::axes<axis>, cca::rate<100>> {};
    struct fast : cca::space<cca::number, cca::axes<axis>, cca::rate<400>> {};
    struct source {
      auto process() -> cca::out<"y", slow> { return 1.0; }
    };
    struct quick {
      auto process(cca::in<"x", slow>) -> cca::out<"y", fast> { return 1.0; }
    };
    struct g : cca::graph<cca::node<"s", source, cca::timed<4>>, cca::node<"q", quick, cca::timed<1>>,
                          cca::node<"c", clock_reader>, cca::wire<"s.y", "q.x", cca::latest>> {};
    CHECK(after<g>(3).get<"c">().times == beats{0, 2500000, 5000000});
  }

  TEST_CASE("dt: since it last fired - the first time N beats for timed<N>, else one beat") {
    struct g : cca::graph<ms1, cca::node<"three", clock_reader, cca::timed<3, 1>>,
                          cca::node<"each", clock_reader>, cca::node<"late", clock_reader, cca::timeout<2>>,
                          cca::node<"mixed", clock_reader, cca::any_of<cca::timed<4, 1>, cca::timed<4, 2>>>> {
    };
    const auto c = after<g>(7);
    CHECK(c.get<"three">().dts == std::vector{0.003, 0.003});
    CHECK(c.get<"each">().dts == std::vector{0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001});
    CHECK(c.get<"late">().indices == beats{2, 4, 6});
    CHECK(c.get<"late">().dts == std::vector{0.001, 0.002, 0.002});
    CHECK(c.get<"mixed">().indices == beats{1, 2, 5, 6});
    CHECK(c.get<"mixed">().dts == std::vector{0.001, 0.001, 0.003, 0.001});
  }

  TEST_CASE("every sense, then every component, then every act") {
    struct g
        : cca::graph<ms1, cca::node<"a", body<'a', 'A'>>, cca::node<"c", writes_name<'c'>, cca::timed<1>>,
                     cca::node<"b", body<'b', 'B'>>, cca::wire<"b.y", "c.x">, cca::wire<"c.y", "a.u">> {};
    cca::controller<g> c;
    std::string order;
    c.get<"a">().to = c.get<"b">().to = c.get<"c">().to = &order;
    c.load();
    c.start();
    c.step();
    c.step();
    CHECK(order == "abcABabcAB");
  }

  TEST_CASE("the schedule: again and again the first declared whose predecessors have all been called") {
    // d waits for a, c for b: b is the first that is ready; then c, declared before a; then a, then d. The
    // delayed wire doesn't count.
    struct g : cca::graph<ms1, cca::node<"d", writes_name<'d'>, cca::timed<1>>,
                          cca::node<"c", writes_name<'c'>, cca::timed<1>>,
                          cca::node<"b", writes_name<'b'>, cca::timed<1>>,
                          cca::node<"a", writes_name<'a'>, cca::timed<1>>, cca::wire<"a.y", "d.x">,
                          cca::wire<"b.y", "c.x">, cca::wire<"d.y", "b.z", cca::delayed<1>>> {};
    cca::controller<g> c;
    std::string order;
    c.get<"a">().to = c.get<"b">().to = c.get<"c">().to = c.get<"d">().to = &order;
    c.load();
    c.start();
    c.step();
    CHECK(order == "bcad");
  }

  TEST_CASE("the nodes of inner graphs are declared where their graph is, depth first") {
    struct inner : cca::graph<cca::node<"p", writes_name<'p'>, cca::timed<1>>,
                              cca::node<"q", writes_name<'q'>, cca::timed<1>>, cca::expose<"p.x", "x">,
                              cca::expose<"q.y", "y">> {};
    struct g : cca::graph<ms1, cca::node<"a", writes_name<'a'>, cca::timed<1>>, cca::node<"i", inner>,
                          cca::node<"b", writes_name<'b'>, cca::timed<1>>,
                          cca::node<"c", writes_name<'c'>, cca::timed<1>>, cca::wire<"c.y", "i.x">,
                          cca::wire<"i.y", "a.x">> {};
    cca::controller<g> c;
    std::string order;
    c.get<"a">().to = c.get<"b">().to = c.get<"c">().to = c.get<"i.p">().to = c.get<"i.q">().to = &order;
    c.load();
    c.start();
    c.step();
    CHECK(order == "qabcp");
  }

  TEST_CASE("an inactive resource node is not called, a slow one in its own beats") {
    struct g : cca::graph<ms1, cca::node<"a", body<'a', 'A'>, cca::inactive>,
                          cca::node<"b", body<'b', 'B'>, cca::timed<2, 1>>,
                          cca::node<"c", body<'c', 'C'>, cca::full_speed>, cca::node<"d", body<'d', 'D'>>> {};
    cca::controller<g> c;
    std::string order;
    c.get<"a">().to = c.get<"b">().to = c.get<"c">().to = c.get<"d">().to = &order;
    c.load();
    c.start();
    c.step();
    c.step();
    CHECK(order == "cdCDbcdBCD");
  }
}
