// Observing a scope: inside the graph by a port, outside by the controller.
#include <doctest/doctest.h>

#include <map>
#include <vector>

#include "counting.hpp"

using namespace core_test;

namespace {

struct pair_of : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};
struct state_of_it {
  auto process(cca::in<"x", reading> x) -> cca::out<"state", pair_of> {
    return pair_of::vector_type{x[cca::x{}], -x[cca::x{}]};
  }
};

// [observe]
struct recorder {  // records every change under `leg`
  void process(cca::observe<"leg.**"> all, cca::beat now) {
    for (const cca::observation& one : all)
      if (one.fresh) recorded[std::string(one.path)] = {one.values.begin(), one.values.end()};
    ++fired;
    beat = now.index();
  }
  std::map<std::string, std::vector<double>> recorded;
  int fired = 0;
  std::int64_t beat = -1;
};

struct leg : cca::graph<cca::node<"slow", adder, cca::timed<3>>,
                        cca::node<"state", state_of_it>,
                        cca::wire<"slow.y", "state.x">,
                        cca::expose<"slow.x", "x">> {};

struct watched : cca::graph<cca::rate<1000>,
                            cca::node<"counter", counter>,
                            cca::node<"leg", leg>,
                            cca::node<"recorder", recorder>,
                            cca::wire<"counter.y", "leg.x", cca::latest>,
                            cca::observe<"leg.state.*">> {};  // for use outside of the graph: c.observed(...)
// [observe end]

struct late_recorder {
  void process(cca::observe<"leg.**.*", cca::delayed<2>> all, cca::beat now) {
    for (const auto& one : all) recorded.push_back({now.index(), one.values[0], one.origin, one.fresh});
  }
  std::vector<seen> recorded;
};
struct late : cca::graph<cca::rate<1000>,
                         cca::node<"counter", counter>,
                         cca::node<"leg", leg>,
                         cca::node<"recorder", late_recorder, cca::full_speed>,
                         cca::wire<"counter.y", "leg.x", cca::latest>> {};

// Whenever `reader` fires, `source` has just published. For somebody outside its input shows more.
struct source {
  auto process(cca::beat now) -> cca::out<"y", reading> { return static_cast<double>(now.index()); }
};
struct reader {
  void process(cca::in<"x", reading>) {}
};
template <class... Policy>
struct watched_input : cca::graph<cca::rate<1000>,
                                  cca::node<"source", source, cca::timed<4, 2>>,
                                  cca::node<"reader", reader, cca::timed<4, 2>>,
                                  cca::wire<"source.y", "reader.x", cca::initial<5>>,
                                  cca::observe<"reader.**", Policy...>> {};
struct without_policy : watched_input<> {};
struct with_queue : watched_input<cca::queue<2>> {};  // an input without a queue gets none
struct with_delay : watched_input<cca::delayed<1>> {};

template <class Graph>
std::vector<seen> seen_outside(int beats) {
  cca::controller<Graph> c;
  c.load();
  c.start();
  std::vector<seen> all;
  for (int k = 0; k < beats; ++k) {
    c.observed(
        [&](const cca::observation& one) { all.push_back({k, one.values[0], one.origin, one.fresh}); });
    c.step();
  }
  return all;
}

}  // namespace

TEST_SUITE("observing") {
  TEST_CASE("a port that observes a scope") {
    auto c = started<watched>();
    c.step();
    const auto& r = c.get<"recorder">();
    CHECK_EQ(r.fired, 1);
    CHECK_EQ(r.recorded.size(), 4);
    CHECK_EQ(r.recorded.at("leg.slow.x"), std::vector<double>{1});
    CHECK_EQ(r.recorded.at("leg.state.x"), std::vector<double>{1});
    CHECK_EQ(r.recorded.at("leg.slow.y"), std::vector<double>{1});
    CHECK_EQ(r.recorded.at("leg.state.state"), std::vector<double>{1, -1});
    c.run(cca::for_beats<2>{});
    CHECK_EQ(r.fired, 3);  // the counter's wire brings a sample to `leg.slow.x` in each beat
    CHECK_EQ(r.recorded.at("leg.slow.x"), std::vector<double>{3});
    c.step();
    CHECK_EQ(r.fired, 4);
    CHECK_EQ(r.beat, 3);
    CHECK_EQ(r.recorded.at("leg.state.state"), std::vector<double>{1 + 4, -1 - 4});
  }

  TEST_CASE("outside of the graph, between two beats") {
    auto c = started<watched>();
    std::vector<std::string> recorded;
    const auto listen = [&] {
      recorded.clear();
      c.observed([&](const cca::observation& one) {
        recorded.push_back(std::string(one.path) + " " + std::to_string(static_cast<int>(one.values[1])) +
                           (one.fresh ? " fresh" : "") +
                           (one.origin == cca::never ? " never" : " " + std::to_string(one.origin)));
      });
    };
    listen();
    CHECK_EQ(recorded, std::vector<std::string>{"leg.state.state 0 never"});
    c.step();
    listen();
    CHECK_EQ(recorded, std::vector<std::string>{"leg.state.state -1 fresh 0"});
    c.run(cca::for_beats<2>{});
    listen();
    CHECK_EQ(recorded, std::vector<std::string>{"leg.state.state -1 0"});
    c.step();
    listen();
    CHECK_EQ(recorded, std::vector<std::string>{"leg.state.state -5 fresh 3000000"});
  }

  TEST_CASE("with a delay") {
    auto c = started<late>();
    c.run(cca::for_beats<6>{});
    std::vector<seen> slow;
    for (std::size_t i = 0; i < c.get<"recorder">().recorded.size(); i += 2)
      slow.push_back(c.get<"recorder">().recorded[i]);
    REQUIRE_EQ(slow.size(), 6);
    CHECK_EQ(slow[1], seen{1, 0, cca::never, false});
    CHECK_EQ(slow[2], seen{2, 1, 0, true});
    CHECK_EQ(slow[3], seen{3, 1, 0, false});
    CHECK_EQ(slow[4], seen{4, 1, 0, false});
    CHECK_EQ(slow[5], seen{5, 5, 3'000'000, true});
  }

  TEST_CASE("an input that its component reads in the beat of publication is seen after it, and before") {
    const std::int64_t published = 2'000'000;
    const std::vector<seen> expected{{0, 5, cca::never, false},
                                     {1, 5, cca::never, false},
                                     {2, 5, cca::never, false},
                                     {3, 2, published, true},
                                     {4, 2, published, false}};
    CHECK(seen_outside<without_policy>(5) == expected);
    CHECK(seen_outside<with_queue>(5) == expected);
    const std::vector<seen> a_beat_later{{0, 5, cca::never, false},
                                         {1, 5, cca::never, false},
                                         {2, 5, cca::never, false},
                                         {3, 5, cca::never, false},
                                         {4, 2, published, true}};
    CHECK(seen_outside<with_delay>(5) == a_beat_later);
  }
}
