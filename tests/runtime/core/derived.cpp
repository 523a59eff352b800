// Values derived from samples: each as if its component computed it itself, and only once where they are the
// same.
#include <doctest/doctest.h>

#include <cca/motor.hpp>

#include "counting.hpp"
#include "derived.hpp"

using namespace derived_test;
using core_test::started;

namespace {

template <class Graph>
struct times {
  double of_lengths = 0, of_areas = 0;  // a beat
  explicit times(cca::controller<Graph>& c, int beats = 12) {
    lengths = areas = 0;
    for (int k = 0; k < beats; ++k) c.step();
    of_lengths = lengths / static_cast<double>(beats), of_areas = areas / static_cast<double>(beats);
  }
};

// Three readers of one output, and one of another.
struct shared : cca::graph<cca::rate<1000>,
                           cca::node<"source", source>,
                           cca::node<"a", length_reader>,
                           cca::node<"b", area_reader>,
                           cca::node<"c", area_reader>,
                           cca::node<"d", area_reader>,
                           cca::wire<"source.y", "a.x">,
                           cca::wire<"source.y", "b.x">,
                           cca::wire<"source.y", "c.x">,
                           cca::wire<"a.y", "d.x">> {};

// The same of an output that is also read a beat later: its sample outlives the beat.
struct stored : cca::graph<cca::rate<1000>,
                           cca::node<"source", source>,
                           cca::node<"a", length_reader>,
                           cca::node<"b", area_reader>,
                           cca::node<"late", area_reader>,
                           cca::wire<"source.y", "a.x">,
                           cca::wire<"source.y", "b.x">,
                           cca::wire<"source.y", "late.x", cca::delayed<1>>> {};

// Equal parts, each with readers of its own samples.
struct leg : cca::graph<cca::node<"source", source>,
                        cca::node<"a", length_reader>,
                        cca::node<"b", length_reader>,
                        cca::wire<"source.y", "a.x">,
                        cca::wire<"source.y", "b.x">> {};
struct legs : cca::graph<cca::rate<1000>, cca::node<"l0", leg>, cca::node<"l1", leg>, cca::node<"l2", leg>> {
};

// A sensor that is slower than those who read it.
struct slower : cca::graph<cca::rate<1000>,
                           cca::node<"source", source, cca::timed<4>>,
                           cca::node<"a", length_reader, cca::full_speed>,
                           cca::node<"b", area_reader, cca::timed<2>>,
                           cca::wire<"source.y", "a.x", cca::latest>,
                           cca::wire<"source.y", "b.x", cca::latest>> {};

// A reader that is asked for in one of four beats only, and one that never fires.
struct seldom : cca::graph<cca::rate<1000>,
                           cca::node<"source", source>,
                           cca::node<"a", area_reader, cca::timed<4>>,
                           cca::node<"b", length_reader, cca::stoppable<>>,
                           cca::node<"c", area_reader, cca::inactive>,
                           cca::wire<"source.y", "a.x", cca::latest>,
                           cca::wire<"source.y", "b.x">,
                           cca::wire<"source.y", "c.x", cca::latest>> {};

// Two parts of a beat.
struct in_parts : shared {};

}  // namespace

template <>
constexpr int cca::detail::calls_in_part<in_parts> = 2;

TEST_SUITE("derived") {
  TEST_CASE("readers of one sample share what is derived from it") {
    auto c = started<shared>();
    const times now(c);
    CHECK_EQ(now.of_lengths, 2);
    CHECK_EQ(now.of_areas, 2);
  }
  TEST_CASE("also of a sample that outlives the beat, but not with who reads it later") {
    auto c = started<stored>();
    const times now(c);
    CHECK_EQ(now.of_lengths, doctest::Approx(2 - 1.0 / 12));  // `late` does not fire in the first beat
    CHECK_EQ(now.of_areas, doctest::Approx(2 - 1.0 / 12));
    CHECK_EQ(c.get<"late">().wrong, 0);
  }
  TEST_CASE("also of a sample that came in an earlier beat") {
    auto c = started<slower>();
    const times now(c);
    CHECK_EQ(now.of_lengths, 1);
    CHECK_EQ(now.of_areas, 0.5);
    CHECK_EQ(c.get<"b">().wrong, 0);
  }
  TEST_CASE("equal components share nothing of different samples") {
    auto c = started<legs>();
    c.get<"l1.source">().seed = 7;
    c.get<"l2.source">().seed = -30;
    const times now(c);
    CHECK_EQ(now.of_lengths, 3);
    for (const auto* one : {&c.get<"l0.a">(), &c.get<"l0.b">(), &c.get<"l1.a">(), &c.get<"l1.b">(),
                            &c.get<"l2.a">(), &c.get<"l2.b">()})
      CHECK_EQ(one->wrong, 0);
  }
  TEST_CASE("nothing is derived while no component asks") {
    auto c = started<seldom>();
    const times now(c);
    CHECK_EQ(now.of_lengths, 1);
    CHECK_EQ(now.of_areas, 0.25);
    c.stop<"b">();
    const times then(c);
    CHECK_EQ(then.of_lengths, 0.25);
    CHECK_EQ(c.get<"a">().wrong, 0);
  }
  TEST_CASE("in a beat of several parts each part derives its own") {
    auto c = started<in_parts>();
    const times now(c);  // source, a | b, c | d
    CHECK_EQ(now.of_lengths, 3);
    CHECK_EQ(now.of_areas, 2);
    for (const auto* one : {&c.get<"b">(), &c.get<"c">(), &c.get<"d">()}) CHECK_EQ(one->wrong, 0);
  }
  TEST_CASE("whatever the wire") {
    auto c = started<ways>();
    for (int k = 0; k < 24; ++k) c.step();
    expect_right(c, 24);
  }
  TEST_CASE("a component that is called by hand computes it") {
    length_reader by_hand;
    const cca::in<"x", pair_of> x(pair_of::vector_type(3, -4), 0, true);
    lengths = areas = 0;
    by_hand.process(x, {});
    CHECK_EQ(by_hand.wrong, 0);
    area_reader other;
    other.process({}, cca::optional_in<"x", pair_of>(pair_of::vector_type(3, -4), 0, true));
    CHECK_EQ(other.wrong, 0);
    const cca::derived<length_of, "x"> length;
    CHECK_EQ(length.anew(cca::sample<pair_of>(pair_of::vector_type(6, 8), 0)), 10);
    // A copy keeps the shared value. A value that is not shared it computes itself.
    const double shared = 17;
    const cca::derived<length_of, "x"> of_beat(&shared), alone(x);
    const auto copy_of_beat = of_beat, copy = alone;
    CHECK_EQ(&copy_of_beat.of(x), &shared);
    CHECK_NE(&copy.of(x), &alone.of(x));
    CHECK_EQ(copy.of(x), 5);
  }
}
