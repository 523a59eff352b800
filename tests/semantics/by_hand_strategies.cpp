// Semantics, "one of the user's": strategies that ask how many samples wait and arrive, and that keep a
// state.
#include <cca/modes.hpp>

#include "by_hand.hpp"

using namespace by_hand;

namespace {

using ms1 = cca::rate<1000>;

// Fires with every N-th sample that arrives at an input.
template <cca::fixed_string Input, int N>
struct every_nth {
  int come = 0;
  template <class Inputs>
  bool fires(cca::beat, const Inputs& in) {
    come += in.template arrivals<Input>();
    if (come < N) return false;
    come -= N;
    return true;
  }
};
// Fires while at least N samples wait.
template <cca::fixed_string Input, int N>
struct while_waiting {
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& in) {
    return in.template waiting<Input>() >= N;
  }
};
// Fires in the beats in which exactly N samples arrive.
template <cca::fixed_string Input, int N>
struct on_arrivals {
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& in) {
    return in.template arrivals<Input>() == N;
  }
};

template <class Strategy, class... Wires>
struct g : cca::graph<ms1,
                      cca::node<"a", count, cca::timed<2>>,
                      cca::node<"b", sometimes<3>>,
                      cca::node<"r", look, Strategy>,
                      cca::node<"both", look_at_two>,
                      cca::wire<"a.y", "both.x", cca::latest>,
                      cca::wire<"b.y", "both.z">,
                      Wires...> {};
template <class Strategy, class... Wires>
beats fired(int count) {
  return beats_of(after<g<Strategy, Wires...>>(count).template get<"r">().log);
}
template <class... Policies>
using from_a = cca::wire<"a.y", "r.x", Policies...>;  // 0, 2, 4, ...
template <class... Policies>
using from_b = cca::wire<"b.y", "r.x", Policies...>;  // 0, 3, 6, ...
using merged = cca::merged<8>;

}  // namespace

TEST_SUITE("semantics by hand: strategies of the user's own") {
  TEST_CASE("every N-th arrival, whatever the wire") {
    CHECK(fired<every_nth<"x", 3>, from_a<cca::latest>>(17) == beats{4, 10, 16});
    CHECK(fired<every_nth<"x", 3>, from_b<>>(16) == beats{6, 15});
    CHECK(fired<every_nth<"x", 3>, from_a<cca::delayed<3>>>(16) == beats{7, 13});
    CHECK(fired<every_nth<"x", 2>, from_b<cca::delayed<2>>>(15) == beats{5, 11});
    CHECK(fired<every_nth<"x", 3>, from_a<cca::queue<2>>>(17) == beats{4, 10, 16});
    CHECK(fired<every_nth<"x", 3>, from_a<cca::queue<9>, cca::delayed<3>>>(16) == beats{7, 13});
    // a: 0 2 4 6 8 10 12; b: 0 3 6 9 12
    CHECK(fired<every_nth<"x", 3>, from_a<merged>, from_b<merged>>(13) == beats{2, 6, 9, 12});
  }
  TEST_CASE("arrivals: how many samples came in this beat") {
    CHECK(fired<on_arrivals<"x", 2>, from_a<merged>, from_b<merged>>(14) == beats{0, 6, 12});
    CHECK(fired<on_arrivals<"x", 1>, from_a<merged>, from_b<merged>>(10) == beats{2, 3, 4, 8, 9});
    CHECK(fired<on_arrivals<"x", 0>, from_a<merged>, from_b<merged>>(8) == beats{1, 5, 7});
    CHECK(fired<on_arrivals<"x", 1>, from_a<cca::latest>>(5) == beats{0, 2, 4});
    // Those that a full queue loses have arrived, too.
    CHECK(fired<on_arrivals<"x", 2>, from_a<cca::merged<1>>, from_b<cca::merged<1>>>(14) == beats{0, 6, 12});
  }
  TEST_CASE("waiting: how many samples are in the queue - without one: 1 if the input is fresh") {
    CHECK(fired<while_waiting<"x", 3>, from_a<cca::queue<9>>>(9) == beats{4, 6, 8});
    CHECK(fired<while_waiting<"x", 3>, from_a<cca::queue<2>>>(9) == beats{});
    CHECK(fired<while_waiting<"x", 2>, from_a<merged, cca::delayed<1>>, from_b<merged>>(9) ==
          beats{1, 3, 4, 5, 6, 7});
    CHECK(fired<while_waiting<"x", 1>, from_b<>>(8) == beats{0, 3, 6});
  }
  TEST_CASE("an input that is not wired: nothing waits, nothing arrives") {
    struct optional {
      beats log;
      void process(cca::optional_in<"x", value>, cca::beat now) { log.push_back(now.index()); }
    };
    struct loose : cca::graph<ms1, cca::node<"r", optional, on_arrivals<"x", 0>>,
                              cca::node<"s", optional, while_waiting<"x", 0>>,
                              cca::node<"t", optional, while_waiting<"x", 1>>> {};
    const auto c = after<loose>(2);
    CHECK(c.get<"r">().log == beats{0, 1});
    CHECK(c.get<"s">().log == beats{0, 1});
    CHECK(c.get<"t">().log.empty());
  }

  TEST_CASE("each node has a state of its own, and a copy of the controller has it, too") {
    struct two : cca::graph<ms1, cca::node<"a", count>, cca::node<"p", look, every_nth<"x", 4>>,
                            cca::node<"q", look, every_nth<"x", 4>>, cca::wire<"a.y", "p.x">,
                            cca::wire<"a.y", "q.x", cca::delayed<2>>> {};
    auto c = after<two>(6);
    const auto copy = c;
    for (int k = 0; k < 6; ++k) c.step();
    CHECK(beats_of(c.get<"p">().log) == beats{3, 7, 11});
    CHECK(beats_of(c.get<"q">().log) == beats{5, 9});
    auto again = copy;
    for (int k = 0; k < 6; ++k) again.step();
    CHECK(again.get<"p">().log == c.get<"p">().log);
    CHECK(again.get<"q">().log == c.get<"q">().log);
  }
  TEST_CASE("under any_of and all_of it is asked in each beat, whatever the others say") {
    // The 3rd, 6th, ... arrival, in beats 4, 10, 16; and each beat that 5 divides.
    CHECK(fired<cca::any_of<cca::timed<5>, every_nth<"x", 3>>, from_a<cca::latest>>(17) ==
          beats{0, 4, 5, 10, 15, 16});
    CHECK(fired<cca::all_of<cca::timed<5>, every_nth<"x", 3>>, from_a<cca::latest>>(41) == beats{10, 40});
    CHECK(fired<cca::any_of<cca::all_of<cca::timed<5>, every_nth<"x", 3>>, cca::timed<20, 1>>,
                from_a<cca::latest>>(41) == beats{1, 10, 21, 40});
    static_assert(std::is_empty_v<cca::any_of<cca::moderate, cca::all_of<cca::timed<3>, cca::restless>>>);
  }
  TEST_CASE("it begins anew when its component is stopped") {
    auto c =
        after<g<cca::stoppable<every_nth<"x", 3>>, from_a<cca::latest>>>(9);  // 4, then 6, 8: two of three
    c.stop<"r">();
    for (int k = 9; k < 15; ++k) c.step();
    c.start<"r">();
    for (int k = 15; k < 24; ++k) c.step();
    CHECK(beats_of(c.get<"r">().log) == beats{4, 20});  // 16, 18, 20
  }
  TEST_CASE("modes that have the same component with the same strategy share its state") {
    struct one : g<every_nth<"x", 5>, from_a<cca::latest>> {};
    struct two : g<every_nth<"x", 5>, from_a<cca::delayed<1>>> {};
    struct three : g<every_nth<"x", 2>, from_a<cca::latest>> {};
    struct none : cca::graph<ms1, cca::node<"a", count, cca::timed<2>>, cca::node<"b", sometimes<3>>> {};
    struct all : cca::modes<cca::mode<"one", one>, cca::mode<"two", two>, cca::mode<"three", three>,
                            cca::mode<"none", none>> {};
    cca::controller<all> c;
    c.load();
    c.start();
    const auto go_on = [&](int beats) {
      for (int k = 0; k < beats; ++k) c.step();
    };
    go_on(6);  // 0, 2, 4
    c.switch_to<"two">();
    go_on(4);  // those of 6 and 8 arrive in 7 and 9: the fifth
    CHECK(beats_of(c.get<"r">().log) == beats{9});
    c.switch_to<"three">();
    go_on(6);  // 10, 12: the second; 14
    CHECK(beats_of(c.get<"r">().log) == beats{9, 12});
    c.switch_to<"none">();
    go_on(4);
    c.switch_to<"three">();
    go_on(4);  // 20, 22
    CHECK(beats_of(c.get<"r">().log) == beats{9, 12, 22});
  }
}
