// The arbiter: which of several writers it passes on.
#include <doctest/doctest.h>

#include <string_view>

#include "../picture.hpp"
#include "by_hand.hpp"

namespace {

using namespace skeleton_test;

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};

// [arbiter]
template <class Policy>
struct two_writers : cca::graph<cca::rate<1000>,
                                cca::node<"reflex", by_hand<leg_angles>>,
                                cca::node<"gait", by_hand<leg_angles, 1>>,
                                cca::node<"legs", cca::arbiter<"angles", leg_angles, Policy>>,
                                cca::node<"robot", listener<leg_angles>>,
                                cca::wire<"reflex.y", "legs.reflex">,
                                cca::wire<"gait.y", "legs.gait">,
                                cca::wire<"legs.angles", "robot.x">> {};

struct by_rank : two_writers<cca::by_priority<"reflex", "gait">> {};  // the reflex, while it publishes
struct by_age : two_writers<cca::by_freshness<"reflex", "gait">> {};  // the writer with the latest origin
// [arbiter end]

// Three arbiters that fire in each beat, with and without new samples, and the writer each one chose.
template <class Policy>
struct three_writers : cca::graph<cca::rate<1000>,
                                  cca::node<"a", by_hand<leg_angles>>,
                                  cca::node<"b", by_hand<leg_angles, 1>>,
                                  cca::node<"c", by_hand<leg_angles, 2>>,
                                  cca::node<"legs", cca::arbiter<"y", leg_angles, Policy>, cca::timed<1>>,
                                  cca::node<"robot", listener<leg_angles>>,
                                  cca::node<"who", listener<cca::choice>>,
                                  cca::wire<"a.y", "legs.a">,
                                  cca::wire<"b.y", "legs.b">,
                                  cca::wire<"c.y", "legs.c">,
                                  cca::wire<"legs.y", "robot.x">,
                                  cca::wire<"legs.writer", "who.x">> {};

constexpr std::string_view picture_of_arbiter = R"(// [arbiter picture]
flowchart LR
  n0["reflex<br/><i>1000 Hz</i>"]
  n1["gait<br/><i>1000 Hz</i>"]
  n2["legs<br/><i>restless</i>"]
  n3["robot<br/><i>restless</i>"]
  n0 -- "y → reflex<br/>leg_angles" --> n2
  n1 -- "y → gait<br/>leg_angles" --> n2
  n2 -- "angles → x<br/>leg_angles" --> n3
)";  // [arbiter picture end]

}  // namespace

TEST_SUITE("arbiter") {
  TEST_CASE("the picture") { test::check_picture<by_rank>(picture_of_arbiter); }

  TEST_CASE("by priority") {
    auto c = started<by_rank>();
    auto& reflex = c.get<"reflex">();
    auto& gait = c.get<"gait">();
    const auto output_after_step = [&](bool reflex_publishes, bool gait_publishes) {
      reflex.publishes = reflex_publishes, gait.publishes = gait_publishes;
      reflex.now = number<leg_angles>(100 + static_cast<double>(c.beat_index()));
      gait.now = number<leg_angles>(200 + static_cast<double>(c.beat_index()));
      c.step();
      return c.get<"robot">().last[knee{}];
    };
    const auto fired = [&] { return c.get<"robot">().all.size(); };
    CHECK_EQ(output_after_step(false, false), 0);
    CHECK_EQ(fired(), 0);
    CHECK_EQ(output_after_step(true, true), 101);
    CHECK_EQ(output_after_step(false, true), 202);
    CHECK_EQ(output_after_step(true, false), 103);
    CHECK_EQ(output_after_step(false, false), 103);
    CHECK_EQ(output_after_step(true, true), 105);
    CHECK_EQ(fired(), 4);
    CHECK_EQ(c.get<"robot">().last.origin(), 5 * c.period());
  }

  TEST_CASE("a writer may pause") {
    auto c = started<by_rank>();
    c.set<"legs">({0.003});
    c.get<"reflex">().now = number<leg_angles>(1);
    c.get<"gait">().now = number<leg_angles>(2);
    c.step();
    c.get<"reflex">().publishes = false;
    for (int k = 1; k < 8; ++k) {
      c.step();
      CHECK_EQ(c.get<"robot">().last[hip{}], k <= 3 ? 1 : 2);
      CHECK_EQ(c.get<"robot">().last.origin(), k <= 3 ? 0 : k * c.period());  // that of the chosen writer
    }
  }

  TEST_CASE("by freshness") {
    auto c = started<by_age>();
    auto& reflex = c.get<"reflex">();
    auto& gait = c.get<"gait">();
    const auto ms = c.period();
    const auto output_after_step = [&](std::int64_t of_reflex, std::int64_t of_gait) {
      reflex.now = number<leg_angles>(1, of_reflex), gait.now = number<leg_angles>(2, of_gait);
      c.step();
      return c.get<"robot">().last[hip{}];
    };
    CHECK_EQ(output_after_step(-5 * ms, -3 * ms), 2);
    CHECK_EQ(c.get<"robot">().last.origin(), -3 * ms);
    CHECK_EQ(output_after_step(0, -3 * ms), 1);
    CHECK_EQ(output_after_step(2 * ms, 2 * ms), 1);  // equal origins: the first
    reflex.publishes = false;
    CHECK_EQ(output_after_step(0, 3 * ms), 2);
    CHECK_EQ(output_after_step(0, ms), 1);  // its new sample is older than its last one
  }

  TEST_CASE("the choice stays, and writer says which it is") {
    auto c = started<three_writers<cca::by_priority<"a", "b", "c">>>();
    const auto who = [&](bool a, bool b, bool w) {
      c.get<"a">().publishes = a, c.get<"b">().publishes = b, c.get<"c">().publishes = w;
      c.step();
      return c.get<"who">().last.vector()[0];
    };
    CHECK_EQ(who(false, true, true), 1);
    CHECK_EQ(who(false, false, true), 2);
    CHECK_EQ(who(false, false, false), 2);
    CHECK_EQ(c.get<"robot">().last.origin(), c.period());
    CHECK_EQ(who(true, true, true), 0);
  }

  TEST_CASE("by freshness, of three") {
    auto c = started<three_writers<cca::by_freshness<"a", "b", "c">>>();
    const auto who = [&](std::int64_t a, std::int64_t b, std::int64_t w) {
      c.get<"a">().now = number<leg_angles>(1, a), c.get<"b">().now = number<leg_angles>(2, b),
      c.get<"c">().now = number<leg_angles>(3, w);
      c.step();
      CHECK_EQ(c.get<"robot">().last[hip{}], 1 + c.get<"who">().last.vector()[0]);
      return c.get<"who">().last.vector()[0];
    };
    CHECK_EQ(who(3, 1, 2), 0);  // not only the last two count
    CHECK_EQ(who(4, 6, 5), 1);
    CHECK_EQ(who(7, 8, 9), 2);
  }

  TEST_CASE("a restart forgets the choice") {
    auto c = started<by_rank>();
    c.set<"legs">({1});
    c.get<"reflex">().now = number<leg_angles>(1);
    c.step();
    c.stop();
    c.start();
    c.get<"reflex">().publishes = false;
    c.step();
    CHECK_EQ(c.get<"robot">().last[hip{}], 0);
  }
}
