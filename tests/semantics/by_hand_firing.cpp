// Semantics, "When a component fires", sentence by sentence.
#include "by_hand.hpp"

using namespace by_hand;

namespace {

using ms1 = cca::rate<1000>;

// A source with this strategy, read by a restless component.
template <class Strategy>
struct alone : cca::graph<ms1,
                          cca::node<"s", count, Strategy>,
                          cca::node<"r", look, cca::restless>,
                          cca::wire<"s.y", "r.x", cca::latest>> {};

template <class Strategy>
beats fired(int count) {
  return beats_of(after<alone<Strategy>>(count).template get<"r">().log);
}

// A reader with two inputs: x from a source in beats 1, 4, 7, ..., z from one in beats 0, 2, 4, ...
template <class Strategy>
struct of_two : cca::graph<ms1,
                           cca::node<"a", count, cca::timed<3, 1>>,
                           cca::node<"b", count, cca::timed<2>>,
                           cca::node<"r", look_at_two, Strategy>,
                           cca::wire<"a.y", "r.x", cca::latest>,
                           cca::wire<"b.y", "r.z", cca::latest>> {};

// The same, with sources whose clocks are known only at run time.
struct at_1_4_7 {
  auto process(cca::beat now) -> cca::maybe<"y", value> {
    if (now.index() % 3 != 1) return {};
    return static_cast<double>(now.index());
  }
};
template <class Strategy>
struct of_two_unknown : cca::graph<ms1,
                                   cca::node<"a", at_1_4_7>,
                                   cca::node<"b", sometimes<2>>,
                                   cca::node<"r", look_at_two, Strategy>,
                                   cca::wire<"a.y", "r.x">,
                                   cca::wire<"b.y", "r.z">> {};

template <class Strategy>
void check(const beats& expected, int count = 9) {
  CHECK(beats_of(after<of_two<Strategy>>(count).template get<"r">().x) == expected);
  CHECK(beats_of(after<of_two_unknown<Strategy>>(count).template get<"r">().x) == expected);
}

struct clock_reader {
  std::vector<std::int64_t> indices, times;
  std::vector<double> dts;
  void process(cca::beat now) {
    indices.push_back(now.index());
    times.push_back(now.time());
    dts.push_back(now.dt());
  }
};

// Strategies that a user could write. (A local class cannot have a template.)
struct odd_and_fresh {
  template <class Inputs>
  static bool fires(cca::beat now, const Inputs& in) {
    return now.index() % 2 == 1 && in.template get<"x">().fresh();
  }
};

struct not_too_often {
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& in) {
    return in.any_fresh() && in.beats_since_fired() >= 2;
  }
};

struct when_x_is_fresh {
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& in) {
    return in.template fresh<"x">();
  }
};

struct z_above_x {
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& in) {
    return in.template get<"z">()[axis{}] > in.template get<"x">()[axis{}];
  }
};

struct x_is_old {
  template <class Inputs>
  bool fires(cca::beat now, const Inputs& in) const {
    const auto x = in.template get<"x">();
    return x.origin() != cca::never && now.time() - x.origin() >= 2 * ms;
  }
};

struct above_two {
  template <class Inputs>
  static bool fires(cca::beat now, const Inputs& in) {
    return now.index() > 5 || in.template get<"x">()[axis{}] > 2;
  }
};

}  // namespace

TEST_SUITE("semantics by hand: when a component fires") {
  TEST_CASE("timed<N, Phase>: (k - Phase) mod N = 0") {
    CHECK(fired<cca::timed<1>>(4) == beats{0, 1, 2, 3});
    CHECK(fired<cca::timed<3>>(8) == beats{0, 3, 6});
    CHECK(fired<cca::timed<3, 2>>(9) == beats{2, 5, 8});
    CHECK(fired<cca::timed<3, 7>>(9) == beats{1, 4, 7});
    CHECK(fired<cca::timed<3, -1>>(9) == beats{2, 5, 8});
    check<cca::timed<4, 3>>({3, 7});
  }

  TEST_CASE("full_speed: always - inactive: never - without inputs timed<1>") {
    CHECK(fired<cca::full_speed>(3) == beats{0, 1, 2});
    CHECK(fired<cca::inactive>(5).empty());
    struct g : cca::graph<ms1, cca::node<"c", clock_reader>> {};
    CHECK(after<g>(3).get<"c">().indices == beats{0, 1, 2});
    check<cca::full_speed>({0, 1, 2, 3, 4, 5, 6, 7, 8});
    check<cca::inactive>({});
  }

  TEST_CASE("restless, the default with inputs: any input is fresh") {
    check<cca::restless>({0, 1, 2, 4, 6, 7, 8});
    struct g : cca::graph<ms1, cca::node<"s", count, cca::timed<3, 1>>, cca::node<"r", look>,
                          cca::wire<"s.y", "r.x">> {};
    CHECK(beats_of(after<g>(9).get<"r">().log) == beats{1, 4, 7});
    struct d : cca::graph<ms1, cca::node<"s", count, cca::timed<3, 1>>, cca::node<"r", look>,
                          cca::wire<"s.y", "r.x", cca::delayed<2>>> {};
    CHECK(after<d>(9).get<"r">().log == seen_inputs{{3, 1, ms, true}, {6, 4, 4 * ms, true}});
  }

  TEST_CASE("moderate: every input is fresh") {
    // x in 1, 4, 7; z in 0, 2, 4, ...: both since the last firing in 1 (z of 0), 4, 7 (z of 6).
    check<cca::moderate>({1, 4, 7});
  }

  TEST_CASE("moderate: an input that is not wired counts nowhere") {
    struct reader {
      beats log;
      void process(cca::in<"x", value>, cca::optional_in<"z", value>, cca::beat now) {
        log.push_back(now.index());
      }
    };
    struct g : cca::graph<ms1, cca::node<"s", count, cca::timed<2>>, cca::node<"r", reader, cca::moderate>,
                          cca::wire<"s.y", "r.x">> {};
    CHECK(after<g>(5).get<"r">().log == beats{0, 2, 4});
  }

  TEST_CASE("timeout<N>: N beats since it last fired, since beat 0 if never") {
    CHECK(fired<cca::timeout<3>>(10) == beats{3, 6, 9});
    CHECK(fired<cca::any_of<cca::timed<5>, cca::timeout<2>>>(11) == beats{0, 2, 4, 5, 7, 9, 10});
    check<cca::any_of<cca::moderate, cca::timeout<2>>>({1, 3, 4, 6},
                                                       8);  // 6 takes z of 6, so that x of 7 finds none
    struct g : cca::graph<ms1, cca::node<"s", count, cca::timed<20, 6>>,
                          cca::node<"r", look, cca::any_of<cca::moderate, cca::timeout<4>>>,
                          cca::wire<"s.y", "r.x", cca::latest>> {};
    CHECK(after<g>(15).get<"r">().log ==
          seen_inputs{
              {4, 0, never, false}, {6, 6, 6 * ms, true}, {10, 6, 6 * ms, false}, {14, 6, 6 * ms, false}});
  }

  TEST_CASE("port_triggered: any named input is fresh") {
    check<cca::port_triggered<"x">>({1, 4, 7});
    check<cca::port_triggered<"z">>({0, 2, 4, 6, 8});
    check<cca::port_triggered<"x", "z">>({0, 1, 2, 4, 6, 7, 8});
  }

  TEST_CASE("any_of, all_of") {
    check<cca::any_of<cca::timed<4, 3>, cca::port_triggered<"x">>>({1, 3, 4, 7});
    check<cca::all_of<cca::timed<2>, cca::restless>>({0, 2, 4, 6, 8});
    check<cca::all_of<cca::timed<4, 3>, cca::port_triggered<"x">>>({3, 7});  // x of 1 is still fresh in 3
    check<cca::all_of<cca::port_triggered<"x">, cca::port_triggered<"z">>>({1, 4, 7});
    CHECK(fired<cca::all_of<cca::timed<2>, cca::timed<3>>>(13) == beats{0, 6, 12});
    CHECK(fired<cca::any_of<cca::timed<4>, cca::timed<6, 1>>>(13) == beats{0, 1, 4, 7, 8, 12});
    CHECK(fired<cca::all_of<cca::timed<2>, cca::timeout<3>>>(13) == beats{4, 8, 12});
  }

  TEST_CASE("a strategy of the user's own sees the beat, and of every input freshness, origin and value") {
    check<odd_and_fresh>({1, 5, 7});  // x of 4 waits for 5
    check<not_too_often>({2, 4, 6, 8});
    check<when_x_is_fresh>({1, 4, 7});
    check<z_above_x>({2, 3, 6, 8});
    check<x_is_old>({3, 6});
  }

  TEST_CASE("a strategy of the user's own sees of a queue what a firing would") {
    struct g : cca::graph<ms1, cca::node<"s", count>, cca::node<"r", look, above_two>,
                          cca::wire<"s.y", "r.x", cca::queue<2, cca::drop_newest>>> {};
    CHECK(after<g>(8).get<"r">().log == seen_inputs{{6, 0, 0, true}, {7, 1, ms, true}});
  }
}

TEST_SUITE("semantics by hand: coordinated") {
  // x comes straight from the source, z by a relay that fires in every second beat.
  struct two_ways
      : cca::graph<ms1, cca::node<"s", count>, cca::node<"m", relay, cca::timed<2, 1>>,
                   cca::node<"r", look_at_two, cca::coordinated>, cca::wire<"s.y", "m.x", cca::latest>,
                   cca::wire<"s.y", "r.x", cca::latest>, cca::wire<"m.y", "r.z", cca::latest>> {};

  TEST_CASE("all of one time of origin, and later than what it saw before") {
    const auto c = after<two_ways>(6);
    CHECK(c.get<"r">().x == seen_inputs{{1, 1, ms, true}, {3, 3, 3 * ms, true}, {5, 5, 5 * ms, true}});
    CHECK(c.get<"r">().z == c.get<"r">().x);
  }

  TEST_CASE("no initial value, and only once for one origin") {
    struct g : cca::graph<ms1, cca::node<"s", count, cca::timed<4, 2>>, cca::node<"m", relay>,
                          cca::node<"r", look_at_two, cca::coordinated>, cca::wire<"s.y", "m.x">,
                          cca::wire<"s.y", "r.x", cca::latest>, cca::wire<"m.y", "r.z", cca::latest>> {};
    CHECK(beats_of(after<g>(12).get<"r">().x) == beats{2, 6, 10});
  }

  TEST_CASE(
      "later than the oldest that it saw when it last fired: under any_of it may have fired on what was not "
      "coordinated") {
    // timed<2>, each second beat: in beat 2 it sees x of 2 and z of 0. In beat 3, z of 3 and x of 3 come: 3 >
    // 0. In beat 4, x of 4, z of 3. In 5 both of 5.
    struct g : cca::graph<ms1, cca::node<"s", count>, cca::node<"m", relay, cca::timed<3>>,
                          cca::node<"r", look_at_two, cca::any_of<cca::coordinated, cca::timed<6, 2>>>,
                          cca::wire<"s.y", "m.x", cca::latest>, cca::wire<"s.y", "r.x", cca::latest>,
                          cca::wire<"m.y", "r.z", cca::latest>> {};
    const auto c = after<g>(10);
    CHECK(c.get<"r">().x == seen_inputs{{0, 0, 0, true},
                                        {2, 2, 2 * ms, true},
                                        {3, 3, 3 * ms, true},
                                        {6, 6, 6 * ms, true},
                                        {8, 8, 8 * ms, true},
                                        {9, 9, 9 * ms, true}});
    CHECK(c.get<"r">().z == seen_inputs{{0, 0, 0, true},
                                        {2, 0, 0, false},
                                        {3, 3, 3 * ms, true},
                                        {6, 6, 6 * ms, true},
                                        {8, 6, 6 * ms, false},
                                        {9, 9, 9 * ms, true}});
  }

  TEST_CASE("a queue shows its oldest waiting sample") {
    // z is late by two beats; x waits for it in a queue.
    struct slow_relay {
      double past[2] = {};
      auto process(cca::in<"x", value> x, cca::beat now) -> cca::maybe<"y", value> {
        const auto i = now.index() % 2;
        const double two_back = past[i];
        past[i] = x[axis{}];
        if (now.index() < 2) return {};
        return cca::maybe<"y", value>(two_back).with_origin(x.origin() - 2 * ms);
      }
    };
    struct g : cca::graph<ms1, cca::node<"s", count>, cca::node<"m", slow_relay>,
                          cca::node<"r", look_at_two, cca::coordinated>, cca::wire<"s.y", "m.x">,
                          cca::wire<"s.y", "r.x", cca::queue<4, cca::drop_oldest>>,
                          cca::wire<"m.y", "r.z", cca::latest>> {};
    const auto c = after<g>(6);
    CHECK(c.get<"r">().x ==
          seen_inputs{{2, 0, 0, true}, {3, 1, ms, true}, {4, 2, 2 * ms, true}, {5, 3, 3 * ms, true}});
    CHECK(c.get<"r">().z == c.get<"r">().x);
  }
}
