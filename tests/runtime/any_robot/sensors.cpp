// Inertial sensors of described robots, motors that wind a cable, and terrain under what moves.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/sim/robot.hpp>

namespace robots = cca::robots;
namespace sim = cca::sim;

namespace {

struct room : cca::frame<"room"> {};
struct tip : cca::frame<"tip"> {};
struct swing : cca::dimension<"swing"> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::velocity{-9, 9}, cca::torque{-5, 5}};
};

struct pole_chain : cca::serial_chain<room, tip, cca::axes<swing>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0.4, 0, 0);
  static constexpr std::array links{cca::link_inertia{0.5, {0.2, 0, 0}, {1e-3, 1e-2, 1e-2, 0, 0, 0}}};
};

// [inertial]
struct pole {
  using body = cca::body<room, cca::part<"pole", pole_chain>>;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  using sensors = robots::sensors<robots::orientation_sensor<"turned", room, "pole">,
                                  robots::force_sensor<"load", "pole">,
                                  robots::gyroscope<"turning", "pole">,
                                  robots::accelerometer<"felt", "pole">,
                                  robots::accelerometer<"of_base">>;
  static constexpr std::array<robots::joint_drive, 1> drives{{{.motor = {5, 50}}}};
};
// [inertial end]

struct torque : cca::space<cca::joint_torques, cca::axes<swing>, cca::rate<1000>> {};
struct still {
  auto process() -> cca::out<"torque", torque> { return 0.0; }
};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct turned_space : cca::space<cca::orientation<room>, xyz, cca::rate<1000>> {};
struct turning_space : cca::space<robots::angular_velocity<tip>, xyz, cca::rate<1000>> {};
template <class Frame>
struct felt_space : cca::space<robots::specific_force<Frame>, xyz, cca::rate<1000>> {};

// Keeps what it hears.
struct probe {
  Eigen::Vector4d turned;
  Eigen::Vector3d turning, felt, of_base;

  void process(cca::in<"turned", turned_space> q,
               cca::in<"turning", turning_space> w,
               cca::in<"felt", felt_space<tip>> f,
               cca::in<"of_base", felt_space<room>> b) {
    turned = q.vector(), turning = w.vector(), felt = f.vector(), of_base = b.vector();
  }
};
struct turning_pole : cca::graph<cca::rate<1000>,
                                 cca::node<"still", still, cca::timed<1>>,
                                 cca::node<"limits", cca::limiter<torque>>,
                                 cca::node<"robot", sim::robot<pole>>,
                                 cca::node<"probe", probe>,
                                 cca::wire<"still.torque", "limits.command">,
                                 cca::wire<"limits.safe", "robot.torque">,
                                 cca::wire<"robot.turned", "probe.turned">,
                                 cca::wire<"robot.turning", "probe.turning">,
                                 cca::wire<"robot.felt", "probe.felt">,
                                 cca::wire<"robot.of_base", "probe.of_base">> {};

// A joint whose motor winds a cable, against a spring.
struct wound {
  using body = cca::body<room, cca::part<"pole", pole_chain>>;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::position_command>;
  // [cable drive]
  static constexpr std::array drives{robots::joint_drive{.motor = {6, 16},
                                                         .friction = 0.1,
                                                         .spring = 4,
                                                         .spring_rest = -0.5,
                                                         .cable = {.stiffness = 80, .damping = 0.4}}};
  // [cable drive end]
};
struct position : cca::space<cca::joint_angles, cca::axes<swing>, cca::rate<1000>> {};
struct one_radian {
  auto process() -> cca::out<"position", position> { return 1.0; }
};
struct winding : cca::graph<cca::rate<1000>,
                            cca::node<"goal", one_radian, cca::timed<1>>,
                            cca::node<"limits", cca::limiter<position>>,
                            cca::node<"robot", sim::robot<wound>>,
                            cca::wire<"goal.position", "limits.command">,
                            cca::wire<"limits.safe", "robot.position">> {};

sim::joint_law to(double position) { return {.position = position, .stiffness = 80, .damping = 1}; }

void go(sim::robot_world& w, const sim::joint_law& law, int beats) {
  for (int k = 0; k < beats; ++k) w.advance(std::span(&law, 1));
}

}  // namespace

TEST_SUITE("inertial sensors") {
  TEST_CASE("on a pole that turns about the vertical they read its turning and the pull to its axis") {
    cca::controller<turning_pole> c;
    sim::robot_world w(sim::model_of<pole>());
    w.place(std::array{0.3}, std::array{2.0});
    c.get<"robot.simulator">().put_down(std::move(w));
    c.load();
    c.start();
    for (int k = 0; k < 500; ++k) REQUIRE(c.step());
    const double angle = c.get<"robot.simulator">().world().joints()[0].angle;
    CHECK(angle == doctest::Approx(0.3 + 2 * 0.5).epsilon(0.01));
    const probe& seen = c.get<"probe">();
    CHECK(seen.turning.isApprox(Eigen::Vector3d(0, 0, 2), 1e-4));
    CHECK(seen.felt[0] == doctest::Approx(-2.0 * 2.0 * 0.4).epsilon(0.01));  // towards the axis
    CHECK(std::abs(seen.felt[1]) < 0.01);
    CHECK(seen.felt[2] == doctest::Approx(9.81));
    CHECK(2 * std::atan2(seen.turned[2], seen.turned[3]) == doctest::Approx(angle).epsilon(1e-2));
    CHECK(seen.of_base.isApprox(Eigen::Vector3d(0, 0, 9.81)));  // it is fixed
  }

  TEST_CASE("in free fall an accelerometer reads nothing") {
    sim::robot_model m = sim::model_of<pole>();
    m.floats = true;
    m.base = {1, {}, {0.1, 0.1, 0.1}};
    sim::robot_world w(m);
    CHECK(w.inertial(1).specific_force[2] == doctest::Approx(9.81));  // nothing moves yet
    for (int k = 0; k < 50; ++k) w.advance({});
    CHECK(Eigen::Vector3d::Map(w.inertial(1).specific_force.data()).norm() < 1e-6);
  }
}

TEST_SUITE("a motor that winds a cable") {
  TEST_CASE("a position reaches it through the robot's port") {
    cca::controller<winding> c;
    c.load();
    c.start();
    for (int k = 0; k < 3000; ++k) REQUIRE(c.step());
    CHECK(c.get<"robot.simulator">().world().joints()[0].angle == doctest::Approx(78 / 84.0).epsilon(1e-3));
  }

  TEST_CASE("it pulls the joint against its spring, as far as the stretch of the cable lets it") {
    sim::robot_world w(sim::model_of<wound>());
    go(w, to(1), 3000);
    const double angle = w.joints()[0].angle;
    // cable 80 (1 - angle) = spring 4 (angle + 0.5)
    CHECK(angle == doctest::Approx((80 - 2) / 84.0).epsilon(1e-3));
    CHECK(w.joints()[0].torque == doctest::Approx(80 * (1 - angle)).epsilon(1e-3));
    CHECK(w.joints()[0].velocity == doctest::Approx(0).epsilon(1e-3));
  }

  TEST_CASE("it never pushes: unwound, the joint goes where the spring has it") {
    sim::robot_world w(sim::model_of<wound>());
    go(w, to(1), 2000);
    double least = 1;
    for (int k = 0; k < 4000; ++k) {
      go(w, to(-2), 1);
      least = std::min(least, w.joints()[0].torque);
    }
    CHECK(least == 0);
    CHECK(w.joints()[0].angle == doctest::Approx(-0.5).epsilon(1e-2));
    go(w, {.torque = -3}, 10);
    CHECK(w.joints()[0].torque == 0);
  }

  TEST_CASE("a torque pulls - a position that follows it winds from there, without a jerk") {
    sim::robot_world w(sim::model_of<wound>());
    go(w, {.torque = 2}, 3000);
    CHECK(w.joints()[0].torque == doctest::Approx(2));
    CHECK(w.joints()[0].angle == doctest::Approx(0).epsilon(1e-2));  // 4 (0 + 0.5)
    double most = 0;
    for (int k = 1; k <= 100; ++k) {
      go(w, to(1e-3 * k), 1);
      most = std::max(most, w.joints()[0].torque);
    }
    CHECK(most < 6);
  }

  TEST_CASE("it winds no faster than its motor can") {
    sim::robot_world w(sim::model_of<wound>());
    double fastest = 0;
    for (int k = 0; k < 500; ++k) {
      go(w, to(2.5), 1);
      fastest = std::max(fastest, w.joints()[0].velocity);
    }
    CHECK(fastest < 16);
    CHECK(w.joints()[0].angle > 0.9);  // the spring holds it there
  }
}

TEST_SUITE("terrain") {
  TEST_CASE("a ball lies on a step, and rolls down a slope") {
    sim::scene hill;
    hill.ground = sim::terrain::steps(0.05, 1, 3, 0.5);
    hill.add(sim::ball{.position = {1.0, 0, 0.2}});    // on the first step
    hill.add(sim::ball{.position = {0.0, 0.5, 0.2}});  // before it
    sim::robot_world w(sim::model_of<pole>(), hill);
    for (int k = 0; k < 2000; ++k) w.advance({});
    CHECK(w.ball_position(0)[2] == doctest::Approx(0.05 + 0.05).epsilon(0.01));
    CHECK(w.ball_position(1)[2] == doctest::Approx(0.05).epsilon(0.01));

    sim::scene slope;
    slope.ground = sim::terrain::slope(0.1, 0.5);
    slope.add(sim::ball{.position = {3, 0, 0.35}});
    sim::robot_world down(sim::model_of<pole>(), slope);
    for (int k = 0; k < 1500; ++k) down.advance({});
    const double x = down.ball_position(0)[0];
    CHECK(x < 2.8);  // it rolls back
    CHECK(down.ball_position(0)[2] ==
          doctest::Approx(std::tan(0.1) * (x - 0.5) + 0.05 / std::cos(0.1)).epsilon(0.02));
  }

  TEST_CASE("friction is the terrain's: on ice a ball slides and does not roll") {
    sim::scene ice;
    ice.ground = sim::terrain::flat().with_friction(0);
    ice.add(sim::ball{.position = {0, 0, 0.05}, .velocity = {1, 0, 0}});
    sim::robot_world w(sim::model_of<pole>(), ice);
    for (int k = 0; k < 1000; ++k) w.advance({});
    CHECK(w.ball_velocity(0)[0] == doctest::Approx(1));
  }
}
