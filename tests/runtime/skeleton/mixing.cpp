// Blend and switch: mixtures of sources on a line, on a circle and between orientations.
#include <doctest/doctest.h>

#include <cmath>
#include <string_view>

#include "../picture.hpp"
#include "by_hand.hpp"

namespace {

using namespace skeleton_test;

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct cpg_amplitude : cca::space<cca::amplitude, cca::axes<cca::x>> {};

// [blend]
struct paw_command
    : cca::graph<
          cca::rate<1000>,
          cca::node<"reach", by_hand<leg_angles>>,
          cca::node<"trot", by_hand<leg_angles, 1>>,
          cca::node<"cpg", by_hand<cpg_amplitude>>,
          cca::node<"blend", cca::blend<"angles", leg_angles, cpg_amplitude, "reach", "trot">>,  // amplitude
                                                                                                 // 0: reach,
                                                                                                 // 1: trot
          cca::node<"paw", listener<leg_angles>>,
          cca::wire<"reach.y", "blend.reach">,
          cca::wire<"trot.y", "blend.trot">,
          cca::wire<"cpg.y", "blend.weight">,
          cca::wire<"blend.angles", "paw.x">> {};
// [blend end]

// [switch]
template <class Space>
struct modes : cca::graph<cca::rate<1000>,
                          cca::node<"stand", by_hand<Space>>,
                          cca::node<"trot", by_hand<Space, 1>>,
                          cca::node<"reach", by_hand<Space, 2>>,
                          cca::node<"operator", by_hand<cca::choice>>,  // 0: stand, 1: trot, 2: reach
                          cca::node<"mode", cca::switch_between<"angles", Space, "stand", "trot", "reach">>,
                          cca::node<"robot", listener<Space>>,
                          cca::wire<"stand.y", "mode.stand">,
                          cca::wire<"trot.y", "mode.trot">,
                          cca::wire<"reach.y", "mode.reach">,
                          cca::wire<"operator.y", "mode.choice">,
                          cca::wire<"mode.angles", "robot.x">> {};
// [switch end]

template <class Space>
struct modes_and_settled
    : cca::graph<cca::rate<1000>,
                 cca::node<"stand", by_hand<Space>>,
                 cca::node<"trot", by_hand<Space, 1>>,
                 cca::node<"reach", by_hand<Space, 2>>,
                 cca::node<"operator", by_hand<cca::choice>>,
                 cca::node<"mode", cca::switch_between<"angles", Space, "stand", "trot", "reach">>,
                 cca::node<"robot", listener<Space>>,
                 cca::node<"settled", listener<cca::flag>>,
                 cca::wire<"stand.y", "mode.stand">,
                 cca::wire<"trot.y", "mode.trot">,
                 cca::wire<"reach.y", "mode.reach">,
                 cca::wire<"operator.y", "mode.choice">,
                 cca::wire<"mode.angles", "robot.x">,
                 cca::wire<"mode.settled", "settled.x">> {};

struct three_weights : cca::space<cca::amplitude, cca::axes<cca::x, cca::y, cca::z>> {};
struct mixed_by_three
    : cca::graph<cca::rate<1000>,
                 cca::node<"a", by_hand<leg_angles>>,
                 cca::node<"b", by_hand<leg_angles, 1>>,
                 cca::node<"c", by_hand<leg_angles, 2>>,
                 cca::node<"w", by_hand<three_weights>>,
                 cca::node<"blend", cca::blend<"y", leg_angles, three_weights, "a", "b", "c">>,
                 cca::node<"end", listener<leg_angles>>,
                 cca::wire<"a.y", "blend.a">,
                 cca::wire<"b.y", "blend.b">,
                 cca::wire<"c.y", "blend.c">,
                 cca::wire<"w.y", "blend.weight">,
                 cca::wire<"blend.y", "end.x">> {};

struct room : cca::frame<"room"> {};
struct attitude : cca::space<cca::orientation<room>, cca::axes<cca::x, cca::y, cca::z>> {};
struct turn : cca::space<cca::phase, cca::axes<cca::x>> {};
struct mode_of_leg : cca::space<cca::status, cca::axes<cca::x>> {};

constexpr std::string_view picture_of_blend = R"(// [blend picture]
flowchart LR
  n0["reach<br/><i>1000 Hz</i>"]
  n1["trot<br/><i>1000 Hz</i>"]
  n2["cpg<br/><i>1000 Hz</i>"]
  n3["blend<br/><i>restless</i>"]
  n4["paw<br/><i>restless</i>"]
  n0 -- "y → reach<br/>leg_angles" --> n3
  n1 -- "y → trot<br/>leg_angles" --> n3
  n2 -- "y → weight<br/>cpg_amplitude" --> n3
  n3 -- "angles → x<br/>leg_angles" --> n4
)";  // [blend picture end]

constexpr std::string_view picture_of_switch = R"(// [switch picture]
flowchart LR
  n0["stand<br/><i>1000 Hz</i>"]
  n1["trot<br/><i>1000 Hz</i>"]
  n2["reach<br/><i>1000 Hz</i>"]
  n3["operator<br/><i>1000 Hz</i>"]
  n4["mode<br/><i>restless</i>"]
  n5["robot<br/><i>restless</i>"]
  n0 -- "y → stand<br/>leg_angles" --> n4
  n1 -- "y → trot<br/>leg_angles" --> n4
  n2 -- "y → reach<br/>leg_angles" --> n4
  n3 -- "y → choice<br/>choice" --> n4
  n4 -- "angles → x<br/>leg_angles" --> n5
)";  // [switch picture end]

}  // namespace

TEST_SUITE("blend") {
  TEST_CASE("the picture") {
    test::check_picture<paw_command>(picture_of_blend);
    test::check_picture<modes<leg_angles>>(picture_of_switch);
  }

  TEST_CASE("a blend by an amplitude") {
    auto c = started<paw_command>();
    const Eigen::Vector2d low(-0.5, 0.25), high(0.5, 1.25);
    c.get<"reach">().now = cca::sample<leg_angles>(low);
    c.get<"trot">().now = cca::sample<leg_angles>(high);
    const auto at = [&](double amplitude) {
      c.get<"cpg">().now = number<cpg_amplitude>(amplitude);
      c.step();
      return c.get<"paw">().last.vector();
    };
    CHECK_EQ(at(0), low);
    CHECK_EQ(at(1), high);
    CHECK_EQ(at(0.5), Eigen::Vector2d(0, 0.75));
    CHECK_EQ(at(0.25), Eigen::Vector2d(-0.25, 0.5));
    CHECK_EQ(at(-3), low);
    CHECK_EQ(at(7), high);
    CHECK_EQ(at(not_a_number), low);
    c.set<"blend">({1, 3});
    CHECK_EQ(at(1), low);
    CHECK_EQ(at(2), Eigen::Vector2d(0, 0.75));
    CHECK_THROWS_AS(c.set<"blend">({1, 1}), cca::refused);
  }

  TEST_CASE("a source with weight zero has no influence") {
    auto c = started<paw_command>();
    c.get<"trot">().now = number<leg_angles>(not_a_number);
    c.step();
    const auto old = c.beat_index() - 1;
    c.get<"trot">().publishes = false;
    c.run(cca::for_beats<9>{});
    CHECK_EQ(c.get<"paw">().last.vector(), Eigen::Vector2d(0, 0));
    CHECK_EQ(c.get<"paw">().last.origin(), 9 * c.period());
    c.get<"trot">().now = number<leg_angles>(1);
    c.get<"cpg">().now = number<cpg_amplitude>(0.5);
    c.step();
    CHECK(c.get<"paw">().last.vector().hasNaN());
    CHECK_EQ(c.get<"paw">().last.origin(), old);
    // At full weight the first source has no influence either, to the bit.
    c.get<"reach">().now = number<leg_angles>(not_a_number);
    c.get<"trot">().publishes = true;
    c.get<"cpg">().now = number<cpg_amplitude>(1);
    c.step();
    CHECK_EQ(c.get<"paw">().last.vector(), Eigen::Vector2d(1, 1));
  }

  TEST_CASE("a blend by one weight per source") {
    auto c = started<mixed_by_three>();
    c.get<"a">().now = number<leg_angles>(1);
    c.get<"b">().now = number<leg_angles>(2);
    c.get<"c">().now = number<leg_angles>(4);
    const auto at = [&](double a, double b, double w) {
      c.get<"w">().now = cca::sample<three_weights>(Eigen::Vector3d(a, b, w));
      c.step();
      return c.get<"end">().last[hip{}];
    };
    CHECK_EQ(at(0, 0, 0), 1);
    CHECK_EQ(at(1, 0, 0), 1);
    CHECK_EQ(at(0, 2, 0), 2);
    CHECK_EQ(at(0, 0, 0.1), 4);
    CHECK(at(1, 1, 2) == doctest::Approx(2.75));
    CHECK(at(3, -5, 1) == doctest::Approx(1.75));
    CHECK_EQ(at(not_a_number, 0, 1), 4);
    // The oldest origin of the sources that contribute: neither b nor the weights.
    c.get<"b">().publishes = c.get<"w">().publishes = false;
    for (int i = 0; i < 3; ++i) {
      c.step();
      CHECK_EQ(c.get<"end">().last.origin(), (c.beat_index() - 1) * c.period());
    }
  }

  TEST_CASE("on a circle and between orientations") {
    using cca::detail::mixed;
    const auto over_zero = mixed(number<turn>(6.2), number<turn>(0.2), 0.5).vector()[0];
    CHECK(cca::wrap_signed(over_zero - 0.5 * (6.2 - 2 * cca::pi + 0.2)) == doctest::Approx(0));
    const auto a = cca::sample<attitude>::about({0, 0, 1}, 0.2),
               b = cca::sample<attitude>::about({0, 0, 1}, 1.0);
    CHECK(mixed(a, b, 0.25).yaw() == doctest::Approx(0.4));
    CHECK_EQ(mixed(number<mode_of_leg>(2), number<mode_of_leg>(5), 0.49).vector()[0], 2);
    CHECK_EQ(mixed(number<mode_of_leg>(2), number<mode_of_leg>(5), 0.5).vector()[0], 5);
  }
}

TEST_SUITE("switch") {
  TEST_CASE("hands over without a bump") {
    auto c = started<modes<leg_angles>>();
    auto& choice = c.get<"operator">();
    const auto value = [&] { return c.get<"robot">().last[hip{}]; };
    double k = 0;
    const auto step = [&] {
      c.get<"stand">().now = number<leg_angles>(0.1 * std::sin(0.01 * k));
      c.get<"trot">().now = number<leg_angles>(1 + 0.1 * std::cos(0.01 * k));
      c.get<"reach">().now = number<leg_angles>(-1);
      ++k;
      c.step();
    };
    for (int i = 0; i < 100; ++i) {
      step();
      CHECK_EQ(value(), c.get<"stand">().now[hip{}]);
    }
    // Smooth, and never faster than the sources plus their distance times the slope of s(u), at most 15/8.
    double before = value(), speed_before = 0;
    choice.now = number<cca::choice>(1);
    for (int i = 0; i < 1000; ++i) {
      if (i == 700) choice.now = number<cca::choice>(2);
      if (i == 900) choice.now = number<cca::choice>(0);  // during a hand-over
      step();
      const double speed = value() - before;
      CHECK(std::abs(speed) < 0.001 + 2.2 * 15 / 8 / 500 + 1e-9);
      if (i > 0 && i != 900) CHECK(std::abs(speed - speed_before) < 2e-4);
      if (i >= 499 && i < 700) CHECK_EQ(value(), c.get<"trot">().now[hip{}]);
      before = value(), speed_before = speed;
    }
  }

  TEST_CASE("along minimum jerk, and settled says when only the chosen source contributes") {
    auto c = started<modes_and_settled<leg_angles>>();
    const auto settled = [&] { return c.get<"settled">().last.vector()[0]; };
    c.get<"operator">().now = number<cca::choice>(not_a_number);
    c.step();
    CHECK_EQ(settled(), 0);  // nothing has been chosen
    c.get<"operator">().now = number<cca::choice>(0);
    c.get<"trot">().now = number<leg_angles>(1);
    c.step();
    CHECK_EQ(settled(), 1);
    c.get<"operator">().now = number<cca::choice>(1);
    for (int k = 1; k <= 500; ++k) {
      c.step();
      const double u = k / 500.0;
      CHECK(c.get<"robot">().last[hip{}] ==
            doctest::Approx(u * u * u * (10 - 15 * u + 6 * u * u)).epsilon(1e-9));
      if (k < 500) CHECK_EQ(settled(), 0);
    }
    CHECK_EQ(settled(), 1);
    // The age of the choice does not matter.
    c.get<"operator">().publishes = false;
    c.step();
    c.step();
    CHECK_EQ(c.get<"robot">().last.origin(), (c.beat_index() - 1) * c.period());
  }

  TEST_CASE("another duration takes effect at the next hand-over") {
    auto c = started<modes_and_settled<leg_angles>>();
    const auto value = [&](double choice, int beats = 1) {
      c.get<"operator">().now = number<cca::choice>(choice);
      for (int i = 0; i < beats; ++i) c.step();
      return c.get<"robot">().last[hip{}];
    };
    c.get<"trot">().now = number<leg_angles>(1);
    c.get<"reach">().now = number<leg_angles>(5);
    value(0);
    CHECK(value(1, 250) == doctest::Approx(0.5));
    c.set<"mode">({20.0});
    CHECK(value(1) == doctest::Approx(0.5).epsilon(0.01));  // no bump during a hand-over
    CHECK_EQ(value(1, 249), 1);
    CHECK_EQ(value(1, 9), 1);  // nor after it
    CHECK_EQ(c.get<"settled">().last.vector()[0], 1);
    c.set<"mode">({0.0});
    CHECK_EQ(value(0), 0);
    CHECK_EQ(value(1), 1);
    c.set<"mode">({0.5});
    CHECK(value(2) ==
          doctest::Approx(1).epsilon(1e-5));  // from the current weights, which it reached at once
    // It stays settled, even if a long pause between firings ended the hand-over and a short one follows.
    const auto speak = [&](bool they) {
      c.get<"stand">().publishes = c.get<"trot">().publishes = c.get<"reach">().publishes =
          c.get<"operator">().publishes = they;
      c.step();
    };
    value(2, 600);
    c.set<"mode">({0.0045});
    value(0);
    for (int i = 0; i < 3; ++i) speak(false);
    for (int i = 0; i < 3; ++i) {
      speak(true);
      CHECK_EQ(c.get<"settled">().last.vector()[0], 1);
      CHECK_EQ(c.get<"robot">().last[hip{}], 0);
    }
  }

  TEST_CASE("a restart forgets the choice") {
    auto c = started<modes_and_settled<leg_angles>>();
    c.get<"trot">().now = number<leg_angles>(1);
    c.get<"operator">().now = number<cca::choice>(0);
    c.step();
    c.get<"operator">().now = number<cca::choice>(1);
    for (int k = 0; k < 100; ++k) c.step();
    CHECK_EQ(c.get<"settled">().last.vector()[0], 0);
    c.stop();
    c.start();
    c.step();  // the first choice takes effect at once, again
    CHECK_EQ(c.get<"robot">().last[hip{}], 1);
    c.get<"operator">().now = number<cca::choice>(2);
    c.run(cca::for_beats<100>{});
    c.stop();
    c.start();
    c.get<"operator">().now = number<cca::choice>(not_a_number);
    c.get<"stand">().now = number<leg_angles>(7);
    c.step();
    CHECK_EQ(c.get<"robot">().last[hip{}], 7);  // before a choice it is the first source
  }

  TEST_CASE("invalid choices") {
    auto c = started<modes<leg_angles>>();
    c.get<"stand">().now = number<leg_angles>(1);
    c.get<"trot">().now = number<leg_angles>(2);
    c.get<"reach">().publishes = false;
    const auto end = [&](double choice) {
      c.get<"operator">().now = number<cca::choice>(choice);
      c.run(cca::for_beats<600>{});
      return c.get<"robot">().last[hip{}];
    };
    for (const double none : {-1.0, 3.0, not_a_number, 1e300}) CHECK_EQ(end(none), 1);
    CHECK_EQ(end(2), 1);  // it has not published yet
    CHECK_EQ(end(1), 2);
    CHECK_EQ(end(7), 2);
    CHECK_EQ(end(2), 2);
    c.get<"reach">().publishes = true;
    CHECK_EQ(end(2), 0);
  }

  TEST_CASE("the first choice takes effect at once, and so does one without duration") {
    auto c = started<modes<leg_angles>>();
    c.get<"trot">().now = number<leg_angles>(2);
    c.get<"operator">().now = number<cca::choice>(1);
    c.step();
    CHECK_EQ(c.get<"robot">().last[hip{}], 2);
    c.set<"mode">({0.0});
    c.get<"operator">().now = number<cca::choice>(0);
    c.step();
    CHECK_EQ(c.get<"robot">().last[hip{}], 0);
  }

  TEST_CASE("the shorter way") {
    auto c = started<modes<turn>>();
    c.get<"stand">().now = number<turn>(6.2);
    c.get<"trot">().now = number<turn>(0.2);
    c.step();
    c.get<"operator">().now = number<cca::choice>(1);
    for (int i = 0; i < 600; ++i) {
      c.step();
      const double at = c.get<"robot">().last.vector()[0];
      CHECK((at >= 6.2 || at <= 0.2));
    }
    auto o = started<modes<attitude>>();
    o.get<"trot">().now = cca::sample<attitude>::about({1, 0, 0}, 1);
    o.step();
    o.get<"operator">().now = number<cca::choice>(1);
    double angle = 0;
    for (int i = 0; i < 600; ++i) {
      o.step();
      const auto at = o.get<"robot">().last;
      CHECK(at.vector().norm() == doctest::Approx(1).epsilon(1e-12));
      CHECK(at.angle() >= angle);
      angle = at.angle();
    }
    CHECK(angle == doctest::Approx(1));
  }
}
