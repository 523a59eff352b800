// A robot of one's own, described and simulated: a trolley on a rail with a hook that swings below it.
#include <cstddef>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robots/description.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>
#include <cca/sim/robot.hpp>

namespace laws {
std::size_t allocations();
}

namespace {

// [axes]
struct rail : cca::dimension<"rail"> {  // a prismatic joint: m, m/s, N
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}, cca::velocity{-0.5, 0.5}};
};
struct swing : cca::dimension<"swing"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::velocity{-9, 9}};
};
// [axes end]

// [body]
struct room : cca::frame<"room"> {};
struct hook : cca::frame<"hook"> {};

struct crane_chain : cca::serial_chain<room, hook, cca::axes<rail, swing>> {
  static constexpr std::array joints{cca::prismatic(cca::along_x, cca::at(0, 0, 1)),
                                     cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0, -0.5);
  static constexpr std::array links{// mass; centre; xx, yy, zz, xy, xz, yz
                                    cca::link_inertia{4, {0, 0, 0}, {0.02, 0.02, 0.02, 0, 0, 0}},
                                    cca::link_inertia{1, {0, 0, -0.4}, {0.01, 0.01, 0.001, 0, 0, 0}}};
};
struct crane_body : cca::body<room, cca::part<"crane", crane_chain, cca::driven_by<"rail", "swing">>> {};
// [body end]

// [description]
namespace robots = cca::robots;

struct crane {
  using body = crane_body;
  using rate = cca::rate<500>;
  using commands = robots::commands<robots::position_command>;
  using sensors = robots::sensors<robots::force_sensor<"load", "crane">>;
  static constexpr std::array drives{
      robots::joint_drive{.motor = {80, 2}, .stiffness = 2000, .damping = 200, .friction = 5},
      robots::joint_drive{.friction = 0.3}};  // no motor
  static constexpr std::array shapes{robots::at_tip("crane", robots::sphere(0.04))};
};
// [description end]

struct goal {
  cca::robots::angles<crane>::vector_type place{0.3, 0};
  auto process(cca::beat) -> cca::out<"place", cca::robots::angles<crane>> { return place; }
};

// [graph]
struct transport : cca::graph<cca::node<"goal", goal>,
                              cca::node<"limits", cca::limiter<cca::robots::angles<crane>>>,
                              cca::node<"crane", cca::sim::robot<crane>>,
                              cca::wire<"goal.place", "limits.command">,
                              cca::wire<"crane.angles", "limits.measured">,  // it begins where the trolley is
                              cca::wire<"limits.safe", "crane.position">> {};
// [graph end]

static_assert(cca::well_formed<transport>);
static_assert(cca::embodied<crane_body, cca::sim::robot<crane>>);

cca::controller<transport> started(bool with_wall) {
  cca::controller<transport> controller;
  if (with_wall) {
    // [world]
    cca::sim::scene room_with_wall;
    room_with_wall.floor = 0;
    room_with_wall.add(cca::sim::fixed_box{{0.1, 1, 1}, cca::at(0.3, 0, 0.5)});
    controller.get<"crane.simulator">().put_down(
        cca::sim::robot_world(cca::sim::model_of<crane>(), room_with_wall));
    // [world end]
  }
  controller.load();
  controller.start();
  return controller;
}

}  // namespace

TEST_SUITE("own robot") {
  TEST_CASE("the trolley drives to its goal no faster than its limit, and the hook comes to rest") {
    auto c = started(false);
    double fastest = 0, widest = 0;
    for (int k = 0; k < 10000; ++k) {
      REQUIRE(c.step());
      const auto& joints = c.get<"crane.simulator">().world().joints();
      fastest = std::max(fastest, joints[0].velocity);
      widest = std::max(widest, std::abs(joints[1].angle));
    }
    const auto& joints = c.get<"crane.simulator">().world().joints();
    CHECK(fastest < 0.6);
    CHECK(widest > 0.1);  // it has no motor
    CHECK(joints[0].angle == doctest::Approx(0.3).epsilon(0.001));
    CHECK(std::abs(joints[1].angle) < 1e-3);
    CHECK(joints[1].torque == 0);
    CHECK(c.get<"limits">().interventions() > 0);
  }

  TEST_CASE("the hook leans against a wall, and the force sensor reads how hard") {
    auto c = started(true);
    for (int k = 0; k < 5000; ++k) REQUIRE(c.step());
    const auto& w = c.get<"crane.simulator">().world();
    const double angle = w.joints()[1].angle;
    CHECK(w.end(0).where.at[0] == doctest::Approx(0.25 - 0.04).epsilon(0.01));
    // Moments about the joint of the hook: of its weight, 0.4 m below it, and of what the sensor feels.
    const cca::rigid end = w.end(0).where;
    const Eigen::Vector3d torque = end.turn * Eigen::Vector3d::Map(w.load(0).data()),
                          force = end.turn * Eigen::Vector3d::Map(w.load(0).data() + 3),
                          arm = end.at - Eigen::Vector3d(w.joints()[0].angle, 0, 1);
    CHECK((torque + cca::detail::cross(arm, force))[1] ==
          doctest::Approx(9.81 * 0.4 * std::sin(angle)).epsilon(0.01));
    CHECK(force[0] < -1);
  }

  TEST_CASE("a beat allocates nothing after the first ones") {
    auto c = started(true);
    for (int k = 0; k < 2500; ++k) REQUIRE(c.step());
    const auto before = laws::allocations();
    for (int k = 0; k < 500; ++k) c.step();
    CHECK(laws::allocations() == before);
    CHECK(c.get<"crane.simulator">().world().load(0) != std::array<double, 6>{});
  }
}
