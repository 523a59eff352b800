// Splitter and collector: a sample that is split and collected is the same, to the bit.
#include <doctest/doctest.h>

#include <cmath>
#include <string_view>

#include <cca/cca.hpp>

#include "../picture.hpp"

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct toe : cca::dimension<"toe"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee, toe>, cca::rate<1000>> {};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

// [skeletons]
struct gait {
  auto process(cca::beat now) -> cca::out<"angles", leg_angles> {
    const double t = 1e-9 * static_cast<double>(now.time());
    return leg_angles::vector_type{std::sin(t), std::cos(t) - 1, -0.0};
  }
};

struct hip_only {  // a component for one joint
  auto process(cca::in<"angle", hip_angle> a) -> cca::out<"angle", hip_angle> { return 0.5 * a[hip{}]; }
};

struct halved_hip
    : cca::graph<cca::node<"gait", gait>,
                 cca::node<"split", cca::splitter<"angles", leg_angles>>,  // ports hip, knee, toe
                 cca::node<"half", hip_only>,
                 cca::node<"whole", cca::collector<"angles", leg_angles>, cca::moderate>,  // once each axis
                                                                                           // has a new sample
                 cca::wire<"gait.angles", "split.angles">,
                 cca::wire<"split.hip", "half.angle">,
                 cca::wire<"half.angle", "whole.hip">,
                 cca::wire<"split.knee", "whole.knee">,
                 cca::wire<"split.toe", "whole.toe">,
                 cca::expose<"whole.angles", "angles">> {};
// [skeletons end]

struct noting {
  void process(cca::in<"before", leg_angles> a, cca::in<"after", leg_angles> b) {
    before = a, after = b, ++count;
  }
  cca::sample<leg_angles> before, after;
  int count = 0;
};
struct round_trip : cca::graph<cca::node<"gait", gait>,
                               cca::node<"note", noting, cca::moderate>,
                               cca::node<"split", cca::splitter<"angles", leg_angles>>,
                               cca::node<"whole", cca::collector<"angles", leg_angles>, cca::moderate>,
                               cca::wire<"gait.angles", "split.angles">,
                               cca::wire<"gait.angles", "note.before">,
                               cca::wire<"split.hip", "whole.hip">,
                               cca::wire<"split.knee", "whole.knee">,
                               cca::wire<"split.toe", "whole.toe">,
                               cca::wire<"whole.angles", "note.after">> {};

struct listening : cca::graph<cca::node<"inner", halved_hip>,
                              cca::node<"outer", gait>,
                              cca::node<"note", noting, cca::moderate>,
                              cca::wire<"outer.angles", "note.before">,
                              cca::wire<"inner.angles", "note.after">> {};

// Both keep the limits of their inputs, so a limiter before them is enough.
struct leg {
  void act(cca::in<"hip", hip_angle> h) { angle = h[hip{}]; }
  double angle = 0;
};
struct limited : cca::graph<cca::node<"gait", gait>,
                            cca::node<"limits", cca::limiter<leg_angles>>,
                            cca::node<"split", cca::splitter<"angles", leg_angles>>,
                            cca::node<"leg", leg>,
                            cca::wire<"gait.angles", "limits.command">,
                            cca::wire<"limits.safe", "split.angles">,
                            cca::wire<"split.hip", "leg.hip">> {};
struct unlimited : cca::graph<cca::node<"gait", gait>,
                              cca::node<"split", cca::splitter<"angles", leg_angles>>,
                              cca::node<"leg", leg>,
                              cca::wire<"gait.angles", "split.angles">,
                              cca::wire<"split.hip", "leg.hip">> {};
static_assert(cca::well_formed<limited>);
static_assert(cca::diagnosis<unlimited>.rule == "robot.unlimited_command");

template <class Graph>
cca::controller<Graph> started() {
  cca::controller<Graph> c;
  c.load();
  c.start();
  return c;
}

constexpr std::string_view picture_of_splitter = R"(// [splitter picture]
flowchart LR
  n0["gait<br/><i>1000 Hz</i>"]
  n1["split<br/><i>1000 Hz</i>"]
  n2["half<br/><i>1000 Hz</i>"]
  n3["whole<br/><i>1000 Hz</i>"]
  n0 -- "angles<br/>leg_angles, 1000 Hz" --> n1
  n1 -- "hip → angle<br/>sub_space&lt;leg_angles, hip&gt;, 1000 Hz" --> n2
  n2 -- "angle → hip<br/>hip_angle, 1000 Hz" --> n3
  n1 -- "knee<br/>sub_space&lt;leg_angles, knee&gt;, 1000 Hz" --> n3
  n1 -- "toe<br/>sub_space&lt;leg_angles, toe&gt;, 1000 Hz" --> n3
)";  // [splitter picture end]

}  // namespace

TEST_SUITE("splitter and collector") {
  TEST_CASE("the picture") { test::check_picture<halved_hip>(picture_of_splitter); }

  TEST_CASE("split and collected") {
    auto c = started<round_trip>();
    for (int k = 0; k < 100; ++k) {
      c.step();
      const auto& note = c.get<"note">();
      REQUIRE_EQ(note.count, k + 1);
      for (int i = 0; i < 3; ++i)
        CHECK_EQ(std::signbit(note.after.vector()[i]), std::signbit(note.before.vector()[i]));
      CHECK_EQ(note.after.vector(), note.before.vector());
      CHECK_EQ(note.after.origin(), note.before.origin());
    }
  }

  TEST_CASE("one axis takes another way") {
    auto c = started<listening>();
    c.run(cca::for_beats<300>{});
    const auto& note = c.get<"note">();
    CHECK_EQ(note.after[hip{}], 0.5 * note.before[hip{}]);
    CHECK_EQ(note.after[knee{}], note.before[knee{}]);
  }
}
