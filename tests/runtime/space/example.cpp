// The example of docs/spaces.md.
#include <doctest/doctest.h>

// [spaces]
#include <cca/space/domain.hpp>
#include <cca/space/sample.hpp>

namespace leg {

// Axes, each with a limit per quantity.
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}, cca::torque{-3.0, 3.0}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}, cca::torque{-3.0, 3.0}};
};

// Frames: any class type will do.
struct world : cca::frame<"world"> {};
struct trunk : cca::frame<"trunk"> {};

// Spaces: a domain type, its axes and, optionally, a rate.
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct trunk_pose : cca::space<cca::pose<world>, xyz> {};
struct foot_in_trunk : cca::space<cca::cartesian_position<trunk>, xyz> {};

}  // namespace leg
// [spaces end]

namespace garden {

// [quantity]
struct humidity {  // a quantity of one's own
  double lower, upper;
  static constexpr std::string_view unit = "%";
  static constexpr auto on_nan = cca::nan_policy::hold;
};
struct soil_humidity {  // and a domain type of it
  using quantity = humidity;
  static constexpr bool actuated = false;  // a sensor's
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {
    double mean() const { return static_cast<const Self&>(*this).vector().mean(); }
  };
};
struct first_bed : cca::dimension<"first_bed"> {
  static constexpr auto limits = cca::limits{humidity{0, 100}};
};
struct second_bed : cca::dimension<"second_bed"> {
  static constexpr auto limits = cca::limits{humidity{0, 100}};
};
struct beds : cca::space<soil_humidity, cca::axes<first_bed, second_bed>> {};
// [quantity end]

}  // namespace garden

TEST_SUITE("space example") {
  TEST_CASE("angles") {
    // [methods]
    const cca::sample<leg::angles> rest;                                         // the zero
    const cca::sample<leg::angles> wish(Eigen::Vector2d(1.2, -0.6), 5'000'000);  // with origin 5 ms
    const auto safe = wish.clamped();                                            // into the axes' limits
    CHECK(safe[leg::hip{}] == 0.9);
    CHECK(safe.origin() == 5'000'000);
    CHECK(rest.interpolated(safe, 0.5)[leg::knee{}] == -0.3);
    // [methods end]
  }

  TEST_CASE("a quantity of one's own") {
    const cca::sample<garden::beds> wet(Eigen::Vector2d(30, 50));
    CHECK(wet.mean() == 40);
  }

  TEST_CASE("frames") {
    // [frames]
    using attitude = decltype(cca::sample<leg::trunk_pose>().orientation());
    using place = decltype(cca::sample<leg::trunk_pose>().position());
    const auto pose = cca::sample<leg::trunk_pose>::of(place(Eigen::Vector3d(2, 0, 0.17)),
                                                       attitude::from_roll_pitch_yaw(0, 0, cca::pi / 2));
    const cca::sample<leg::foot_in_trunk> foot(Eigen::Vector3d(0.1, 0, -0.17));
    const auto seen = pose.express(foot);  // a position in the world; pose.transform(foot) would not compile
    CHECK((seen.vector() - Eigen::Vector3d(2, 0.1, 0)).norm() < 1e-12);
    // [frames end]
  }
}
