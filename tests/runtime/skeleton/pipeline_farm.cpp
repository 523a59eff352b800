// Pipelines and farms give the same as their stages and workers called by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <string_view>

#include "../picture.hpp"
#include "by_hand.hpp"

namespace {

using namespace skeleton_test;

struct trunk : cca::frame<"trunk"> {};
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct reading : cca::space<cca::number, cca::axes<cca::x>> {};

// [pipeline]
struct offset {
  auto process(cca::in<"raw", reading> x) -> cca::out<"value", reading> { return x[cca::x{}] - 0.5; }
};
struct without_spikes {
  auto process(cca::in<"x", reading> x) -> cca::maybe<"clean", reading> {
    if (std::abs(x[cca::x{}]) > 10) return {};  // publishes nothing, so the next stage does not fire
    return cca::sample<reading>(x);
  }
};
struct smooth {
  double y = 0;
  auto process(cca::in<"x", reading> x) -> cca::out<"y", reading> { return y += 0.25 * (x[cca::x{}] - y); }
};

struct conditioned : cca::graph<cca::rate<1000>,
                                cca::node<"sensor", by_hand<reading>>,
                                cca::node<"signal", cca::pipeline<offset, without_spikes, smooth>>,
                                cca::node<"log", listener<reading>>,
                                cca::wire<"sensor.y", "signal.input">,
                                cca::wire<"signal.output", "log.x">> {};
// [pipeline end]

struct in_three_beats
    : cca::graph<cca::rate<1000>,
                 cca::node<"sensor", by_hand<reading>>,
                 cca::node<"signal", cca::pipeline_over<cca::delayed<1>, offset, smooth, offset>>,
                 cca::node<"log", listener<reading>>,
                 cca::wire<"sensor.y", "signal.input">,
                 cca::wire<"signal.output", "log.x">> {};

// [farm]
struct paw : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::z>> {};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};

struct leg_ik {  // for a leg of two links of 0.2 m
  auto process(cca::in<"paw", paw> p) -> cca::out<"angles", leg_angles> {
    const double length = std::hypot(p[cca::x{}], p[cca::z{}]), bend = std::acos(std::fmin(length / 0.4, 1));
    return Eigen::Vector2d(std::atan2(p[cca::x{}], -p[cca::z{}]) + bend, -2 * bend);
  }
};

struct four_paws
    : cca::graph<cca::rate<1000>,
                 cca::node<"gait", by_hand<cca::array_of<paw, 4>>>,
                 cca::node<"ik", cca::farm<leg_ik, cca::array_of<paw, 4>, cca::array_of<leg_angles, 4>>>,
                 cca::node<"robot", listener<cca::array_of<leg_angles, 4>>>,
                 cca::wire<"gait.y", "ik.input">,
                 cca::wire<"ik.output", "robot.x">> {};
// [farm end]

struct lf_hip : cca::dimension<"lf_hip"> {};
struct lf_knee : cca::dimension<"lf_knee"> {};
struct rf_hip : cca::dimension<"rf_hip"> {};
struct rf_knee : cca::dimension<"rf_knee"> {};
struct all_angles : cca::space<cca::joint_angles, cca::axes<lf_hip, lf_knee, rf_hip, rf_knee>> {};
struct half_speed {
  double part = 0;
  auto process(cca::in<"in", leg_angles> x, cca::beat now) -> cca::out<"out", leg_angles> {
    part += now.dt();
    return (part * x.vector()).eval();
  }
};
struct with_own_axes
    : cca::graph<cca::rate<1000>,
                 cca::node<"a", by_hand<all_angles>>,
                 cca::node<"farm", cca::farm<cca::pipeline<half_speed, half_speed>, all_angles, all_angles>>,
                 cca::node<"b", listener<all_angles>>,
                 cca::wire<"a.y", "farm.input">,
                 cca::wire<"farm.output", "b.x">> {};

struct of_orientations {
  auto process(cca::in<"in", cca::space<cca::orientation<trunk>, cca::axes<cca::x, cca::y, cca::z>>> x)
      -> cca::out<"out", reading> {
    return x.yaw();
  }
};
using three_orientations =
    cca::array_of<cca::space<cca::orientation<trunk>, cca::axes<cca::x, cca::y, cca::z>>, 3>;
struct of_three
    : cca::graph<cca::rate<1000>,
                 cca::node<"a", by_hand<three_orientations>>,
                 cca::node<"farm", cca::farm<of_orientations, three_orientations, cca::array_of<reading, 3>>>,
                 cca::node<"b", listener<cca::array_of<reading, 3>>>,
                 cca::wire<"a.y", "farm.input">,
                 cca::wire<"farm.output", "b.x">> {};

constexpr std::string_view picture_of_pipeline = R"(// [pipeline picture]
flowchart LR
  n0["sensor<br/><i>1000 Hz</i>"]
  n4["log<br/><i>restless</i>"]
  subgraph g1["signal"]
    n1["stage0<br/><i>port_triggered</i>"]
    n2["stage1<br/><i>port_triggered</i>"]
    n3["stage2<br/><i>port_triggered</i>"]
  end
  n0 -- "y → raw<br/>reading" --> n1
  n1 -- "value → x<br/>reading" --> n2
  n2 -- "clean → x<br/>reading" --> n3
  n3 -- "y → x<br/>reading" --> n4
)";  // [pipeline picture end]

constexpr std::string_view picture_of_farm = R"(// [farm picture]
flowchart LR
  n0["gait<br/><i>1000 Hz</i>"]
  n7["robot<br/><i>restless</i>"]
  subgraph g1["ik"]
    n1["split<br/><i>restless</i>"]
    n2["worker0<br/><i>port_triggered</i>"]
    n3["worker1<br/><i>port_triggered</i>"]
    n4["worker2<br/><i>port_triggered</i>"]
    n5["worker3<br/><i>port_triggered</i>"]
    n6["join<br/><i>moderate</i>"]
  end
  n0 -- "y → input<br/>array_of&lt;paw, 4&gt;" --> n1
  n1 -- "part0 → paw<br/>paw" --> n2
  n1 -- "part1 → paw<br/>paw" --> n3
  n1 -- "part2 → paw<br/>paw" --> n4
  n1 -- "part3 → paw<br/>paw" --> n5
  n2 -- "angles → part0<br/>leg_angles" --> n6
  n3 -- "angles → part1<br/>leg_angles" --> n6
  n4 -- "angles → part2<br/>leg_angles" --> n6
  n5 -- "angles → part3<br/>leg_angles" --> n6
  n6 -- "output → x<br/>array_of&lt;leg_angles, 4&gt;" --> n7
)";  // [farm picture end]

}  // namespace

TEST_SUITE("pipeline") {
  TEST_CASE("the picture") {
    test::check_picture<conditioned>(picture_of_pipeline);
    test::check_picture<four_paws>(picture_of_farm);
  }

  TEST_CASE("a sample passes all stages in one beat") {
    auto c = started<conditioned>();
    smooth last;
    std::size_t clean = 0;
    for (int k = 0; k < 50; ++k) {
      const double raw = k % 7 == 3 ? 100 : std::sin(k);
      c.get<"sensor">().now = number<reading>(raw);
      c.step();
      if (k % 7 != 3) ++clean, last.y += 0.25 * (raw - 0.5 - last.y);
      REQUIRE_EQ(c.get<"log">().all.size(), clean);
      CHECK_EQ(c.get<"log">().last[cca::x{}], last.y);
      CHECK_EQ(c.get<"signal.stage2">().y, last.y);
      if (k % 7 != 3) CHECK_EQ(c.get<"log">().last.origin(), k * c.period());
    }
  }

  TEST_CASE("or one stage per beat") {
    auto c = started<in_three_beats>();
    for (int k = 0; k < 20; ++k) {
      c.get<"sensor">().now = number<reading>(k);
      c.step();
      REQUIRE_EQ(c.get<"log">().all.size(), k < 2 ? 0 : k - 1);
      if (k >= 2) CHECK_EQ(c.get<"log">().last.origin(), (k - 2) * c.period());
    }
  }
}

TEST_SUITE("farm") {
  TEST_CASE("each worker gets its part") {
    auto c = started<four_paws>();
    Eigen::Matrix<double, 8, 1> paws;
    paws << 0.01, -0.3, 0.02, -0.32, -0.05, -0.35, 0.1, -0.25;
    c.get<"gait">().now = cca::sample<cca::array_of<paw, 4>>(paws);
    c.step();
    const auto& angles = c.get<"robot">().last;
    REQUIRE_EQ(c.get<"robot">().all.size(), 1);
    for (int leg = 0; leg < 4; ++leg) {
      leg_ik alone;
      const auto p = alone.process(cca::in<"paw", paw>(paws.segment<2>(2 * leg), 0, true)).vector();
      CHECK_EQ(angles.vector().segment<2>(2 * leg), p);
    }
    CHECK_EQ(angles.part<2>().vector(), angles.vector().segment<2>(4));
    CHECK_EQ(angles[cca::element<knee, 3>{}], angles.vector()[7]);
    CHECK_EQ(angles.origin(), 0);
  }

  TEST_CASE("with axes of its own, and with pipelines as workers") {
    auto c = started<with_own_axes>();
    c.get<"a">().now = cca::sample<all_angles>(Eigen::Vector4d(1, 2, 3, 4));
    for (int k = 1; k < 9; ++k) {
      c.step();
      CHECK((c.get<"b">().last.vector() - 1e-6 * k * k * Eigen::Vector4d(1, 2, 3, 4)).norm() < 1e-12);
    }
    CHECK_EQ(c.get<"farm">().get<"worker1">().get<"stage1">().part, doctest::Approx(0.008));
  }

  TEST_CASE("an array of a space without numbers per axis") {
    auto c = started<of_three>();
    CHECK_EQ(c.get<"a">().now.vector(), cca::sample<three_orientations>().vector());
    for (int i = 0; i < 3; ++i)
      CHECK_EQ(c.get<"a">().now.part<1>().vector()[3], 1);  // the zero of each element
    Eigen::Matrix<double, 12, 1> v;
    for (int i = 0; i < 3; ++i)
      v.segment<4>(4 * i) =
          cca::sample<cca::space<cca::orientation<trunk>, cca::axes<cca::x, cca::y, cca::z>>>::about(
              {0, 0, 1}, 0.25 * i)
              .vector();
    const cca::sample<three_orientations> turned(v);
    c.get<"a">().now = turned;
    c.step();
    for (int i = 0; i < 3; ++i) CHECK(c.get<"b">().last.vector()[i] == doctest::Approx(0.25 * i));
    CHECK(cca::sample<three_orientations>().interpolated(turned, 0.5).part<2>().yaw() ==
          doctest::Approx(0.25));
  }
}
