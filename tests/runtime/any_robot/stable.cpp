// Simulated robots don't fly apart: any damping, spring, servo, cable, motor, mass and rate; and a world that
// can't be right any more ends in a fault that names the body, never in an abort of the engine.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <ode/ode.h>

#include <cca/cca.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/sim/engine/engine.hpp>
#include <cca/sim/robot.hpp>
#include <cca/sim/robot/forces/gyroscopic.hpp>

#include "../../laws/stable_robot_laws.hpp"
#include "lost_engine.hpp"

namespace arm = cca::robots::arm;
namespace robots = cca::robots;
namespace sim = cca::sim;

namespace {

// A hand of 0.1 kg on a wrist with a damping of 1 N m s/rad, as public descriptions have it.
struct base : cca::frame<"base"> {};
struct hand_frame : cca::frame<"hand"> {};
struct wrist : cca::dimension<"wrist"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::velocity{-3, 3}, cca::torque{-30, 30}};
};
constexpr cca::link_inertia light{0.1, {0.03, 0, 0}, {9e-5, 9e-5, 9e-5, 0, 0, 0}};
struct hand_chain : cca::serial_chain<base, hand_frame, cca::axes<wrist>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.06, 0, 0);
  static constexpr std::array links{light};
};
struct light_hand {
  using body = cca::body<base, cca::part<"hand", hand_chain>>;
  using rate = cca::rate<100>;
  using commands = robots::commands<robots::position_command>;
  using sensors = robots::sensors<robots::force_sensor<"load", "hand">, robots::gyroscope<"turning", "hand">>;
  static constexpr std::array drives{
      robots::joint_drive{.motor = {30, 3}, .stiffness = 100, .damping = 1, .friction = 1}};
};
struct to_half {
  auto process(cca::beat) -> cca::out<"position", robots::angles<light_hand>> { return 0.5; }
};
struct moved : cca::graph<cca::node<"goal", to_half, cca::timed<1>>,
                          cca::node<"limits", cca::limiter<robots::angles<light_hand>>>,
                          cca::node<"robot", sim::robot<light_hand>>,
                          cca::wire<"goal.position", "limits.command">,
                          cca::wire<"limits.safe", "robot.position">> {};
struct left_alone : cca::graph<cca::node<"robot", sim::robot<light_hand>>> {};

constexpr std::array rates{50.0, 100.0, 250.0, 1000.0};

sim::robot_model hand_at(double hz, const robots::joint_drive& drive) {
  sim::robot_model m = sim::model_of<light_hand>();
  m.beat = 1 / hz;
  m.drives[0] = drive;
  return m;
}

// Links of 10 g, and 100 kg at their end.
sim::robot_model heavy_end(double hz, double friction) {
  sim::robot_model m;
  m.beat = 1 / hz;
  for (int i = 0; i < 4; ++i) {
    cca::joint j = cca::revolute(i % 2 ? cca::along_x : cca::along_y, cca::at(i ? 0.1 : 0, 0, 0));
    m.links.push_back(cca::detail::body_link_of(j, i, i - 1));
    m.links.back().inertia = i < 3 ? cca::link_inertia{0.01, {0.05, 0, 0}, {1e-6, 1e-5, 1e-5, 0, 0, 0}}
                                   : cca::link_inertia{100, {0.2, 0, 0}, {1, 1, 1, 0, 0, 0}};
    m.drives.push_back({.motor = {300, 5}, .friction = friction});
    m.stops.push_back({-1.5, 1.5});
    m.start.push_back(0);
  }
  return m;
}

sim::robot_model free_body(const cca::link_inertia& of) {
  sim::robot_model m;
  m.base = of;
  m.floats = true;
  return m;
}

}  // namespace

TEST_SUITE("nothing flies apart") {
  TEST_CASE("random robots with any numbers are finite, within their stops, and come to rest") {
    double beyond = 0, speed = 0, chatter = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
      for (const double hz : rates) {
        laws::source random{std::mt19937_64{seed}};
        const auto robot = laws::random_stiff_robot(random, hz);
        const laws::rest seen = laws::comes_to_rest(robot.model, robot.drives);
        CAPTURE(seed);
        CAPTURE(hz);
        CHECK(seen.trouble.empty());
        CHECK(seen.beyond_stop < 0.02);
        CHECK(seen.speed < 0.15);
        CHECK(seen.chatter < 0.02);
        beyond = std::max(beyond, seen.beyond_stop), speed = std::max(speed, seen.speed);
        chatter = std::max(chatter, seen.chatter);
      }
    MESSAGE("worst: ", beyond, " beyond a stop, ", speed, " at the end, changing by ", chatter);
  }

  TEST_CASE("a hand of 0.1 kg with a damping of 1 N m s/rad rests where its servo and its weight have it") {
    for (const double hz : rates)
      for (const double stiffness : {1.0, 100.0, 1e6}) {
        const auto m = hand_at(hz, {.motor = {30, 3}, .friction = 1});
        const sim::joint_law law{.position = 0.5, .stiffness = stiffness, .damping = 0.01 * stiffness};
        sim::robot_world w(m);
        double fastest = 0;
        for (int k = 0; k < 20 * hz; ++k) {
          w.advance(std::span(&law, 1));
          fastest = std::max(fastest, std::abs(w.joint("wrist").velocity));
        }
        CHECK(w.trouble_text() == "");
        CHECK(fastest < 3.001);  // the end of its motor's line
        const double q = w.joint("wrist").angle, weight = 0.1 * 9.81 * 0.03 * std::cos(q);
        CHECK(stiffness * (0.5 - q) == doctest::Approx(-weight).epsilon(1e-3));
        CHECK(w.joint("wrist").torque == doctest::Approx(-weight).epsilon(1e-3));
      }
  }

  TEST_CASE("the same hand in a graph") {
    cca::controller<moved> c;
    c.load();
    c.start();
    for (int k = 0; k < 1000; ++k) REQUIRE(c.step());
    CHECK(c.get<"robot.simulator">().world().joint("wrist").angle == doctest::Approx(0.5).epsilon(1e-2));
  }

  TEST_CASE("springs in joints, cables that are wound and lines of any stiffness rest where they balance") {
    for (const double hz : rates) {
      sim::robot_world sprung(hand_at(hz, {.friction = 0.01, .spring = 1e5, .spring_rest = 0.4}));
      const auto cabled = hand_at(hz, {.motor = {30, 3}, .friction = 0.01, .cable = {1e5, 1e3}});
      sim::robot_world wound(cabled);
      sim::robot_model m = hand_at(hz, {.friction = 0.05});
      m.line_springs.push_back({{-1, cca::at(0.06, 0, 0.1)}, {0, cca::at(0.06, 0, 0)}, 1e6, 0.05, 1e3, true});
      sim::robot_world hung(m);
      const sim::joint_law wind{.position = -0.3, .stiffness = 1};
      for (int k = 0; k < 10 * hz; ++k) {
        sprung.advance({});
        wound.advance(std::span(&wind, 1));
        hung.advance({});
      }
      CHECK(sprung.joint("wrist").angle == doctest::Approx(0.4).epsilon(1e-5));
      CHECK(sprung.joint("wrist").velocity == doctest::Approx(0).epsilon(1e-6));
      // Its weight pulls to larger angles: no cable holds it back, so it hangs down.
      CHECK(wound.joint("wrist").angle == doctest::Approx(std::numbers::pi / 2).epsilon(1e-2));
      // The line, which is too short, pulls the tip to where it is nearest; taut, it is as stiff across.
      CHECK(hung.joint("wrist").angle == doctest::Approx(-std::atan2(0.1, 0.06)).epsilon(1e-4));
      CHECK(std::abs(hung.joint("wrist").velocity) < 1e-6);
      CHECK(hung.tension(0) > 6000);
      for (const auto* w : {&sprung, &wound, &hung}) CHECK(w->trouble_text() == "");
    }
  }

  TEST_CASE("100 kg on links of 10 g stay within their stops, held or not") {
    for (const double hz : rates)
      for (const double stiffness : {0.0, 50.0, 1e5})
        for (const double friction : {1.0, 1000.0}) {
          const std::vector<sim::joint_law> hold(4, {.stiffness = stiffness, .damping = stiffness / 10});
          const laws::rest seen = laws::comes_to_rest(heavy_end(hz, friction), hold);
          CAPTURE(hz);
          CAPTURE(stiffness);
          CAPTURE(friction);
          CHECK(seen.trouble.empty());
          CHECK(seen.beyond_stop < 0.02);
        }
  }

  TEST_CASE("a copy goes on with the same bits") {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      laws::source random{std::mt19937_64{seed}};
      const auto robot = laws::random_stiff_robot(random, seed % 2 ? 250 : 1000);
      sim::robot_world a(robot.model);
      for (int k = 0; k < 50; ++k) a.advance(robot.drives);
      sim::robot_world b(a);
      for (int k = 0; k < 200; ++k) a.advance(robot.drives), b.advance(robot.drives);
      CAPTURE(seed);
      CHECK(a.hash() == b.hash());
    }
  }

  TEST_CASE("a posture in which a joint moves least inertia: a slim rod that stands upright on its axis") {
    for (const double friction : {0.02, 0.3, 0.5})
      for (const double hz : {100.0, 1000.0}) {
        sim::robot_model model;
        model.beat = 1 / hz;
        model.links.push_back(
            cca::detail::body_link_of(cca::revolute(cca::along_z, cca::at(0, 0, 0)), 0, -1));
        model.links.back().inertia = {0.2, {0, 0, 0.1}, {1e-3, 1e-3, 2e-5, 0, 0, 0}};
        model.links.push_back(
            cca::detail::body_link_of(cca::revolute(cca::along_y, cca::at(0, 0, 0.2)), 1, 0));
        model.links.back().inertia = {2, {0.3, 0, 0}, {2e-5, 2e-2, 2e-2, 0, 0, 0}};
        model.drives.assign(2, {.friction = friction});
        model.stops = {{-3, 3}, {-1.6, 1.6}};
        model.start = {0, 0};
        sim::robot_world w(model);
        w.place(std::array{0.0, -cca::pi / 2}, std::array{0.5, 0.0});
        double fastest = 0;
        for (int k = 0; k < hz / 4 && !w.trouble(); ++k) {
          w.advance({});
          fastest = std::max(fastest, std::abs(w.joints()[0].velocity));
        }
        CAPTURE(friction);
        CAPTURE(hz);
        CHECK(w.trouble_text() == "");
        CHECK(fastest < 1);
      }
  }

  TEST_CASE("numbers that no joint can have are refused, with the joint and the number") {
    CHECK_THROWS_WITH_AS(sim::robot_world(hand_at(100, {.friction = -1})),
                         doctest::Contains("the friction of joint `wrist` is -1"), std::invalid_argument);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(sim::robot_world(hand_at(100, {.spring = nan})),
                         doctest::Contains("the spring of joint `wrist`"), std::invalid_argument);
    sim::robot_world w(hand_at(100, {}));
    CHECK_THROWS_AS(w.place(std::array{nan}, std::array{0.0}), std::invalid_argument);
  }
}

TEST_SUITE("a world that can't be right") {
  TEST_CASE("ends in a fault that names the body, and stands still") {
    cca::controller<left_alone> c;
    c.load();
    sim::robot_world w(sim::model_of<light_hand>());
    w.place(std::array{0.0}, std::array{1e4});
    c.get<"robot.simulator">().put_down(std::move(w));
    c.start();
    c.step();
    REQUIRE(c.state() == cca::state::faulted);
    CHECK(std::string(c.fault().reason()).find("link 0, which `wrist` moves") != std::string::npos);
    const auto& world = c.get<"robot.simulator">().world();
    CHECK(world.trouble_text() ==
          "link 0, which `wrist` moves: its turning of 1e+04 is beyond 628.3 rad/s, half a turn in a physics "
          "step");
    const double angle = world.joint("wrist").angle;
    c.step();
    CHECK(world.joint("wrist").angle == angle);
  }

  TEST_CASE("is noticed by speed, energy and stops, and put right by a new place") {
    sim::robot_world w(free_body({1, {}, {1, 1, 1, 0, 0, 0}}));
    sim::moving_frame fast;
    fast.velocity = {2000, 0, 0};
    w.place({}, {}, fast);
    CHECK(w.trouble_text() == "the base: its speed of 2000 is beyond 1000 m/s");
    w.place({}, {}, {});
    CHECK(!w.trouble());
    sim::robot_world_settings strict;
    strict.plausible.energy = 10;
    sim::robot_world slow(free_body({1, {}, {1, 1, 1, 0, 0, 0}}), {}, strict);
    for (int k = 0; k < 1000; ++k) slow.advance({});
    CHECK(slow.trouble().what == sim::implausible::energy);
    CHECK(slow.trouble().value == doctest::Approx(10).epsilon(0.01));
    sim::robot_world beyond(hand_at(100, {}));
    beyond.place(std::array{2.8}, std::array{0.0});
    beyond.advance({});
    CHECK(beyond.trouble().what == sim::implausible::stop);
  }

  TEST_CASE("an assertion of the engine ends the step, not the process") {
    [[maybe_unused]] lost_engine its_memory;
    sim::engine e({});
    const dBodyID b = dBodyCreate(e.id());
    CHECK(e.step(0.001));
    dBodySetAngularVel(b, std::numeric_limits<double>::quiet_NaN(), 0, 0);
    CHECK(!e.step(0.001));
    CHECK(!e.step(0.001));
  }
}

TEST_SUITE("free bodies") {
  TEST_CASE("a disc at 500 rad/s keeps its nutation, its energy and its momentum") {
    const cca::link_inertia disc{1, {}, {0.005, 0.005, 0.01, 0, 0, 0}};
    sim::robot_world w(free_body(disc));
    sim::moving_frame start;
    start.angular_velocity = {0.5, 0, 500};
    w.place({}, {}, start);
    const Eigen::Vector3d inertia(0.005, 0.005, 0.01);
    const auto local = [&] {
      return (w.frame(-1).where.turn.transpose() * w.frame(-1).angular_velocity).eval();
    };
    const Eigen::Vector3d momentum = inertia.cwiseProduct(local());
    double farthest = 0;
    for (int k = 0; k < 5000; ++k) {
      w.advance({});
      const Eigen::Vector3d now = w.frame(-1).where.turn * inertia.cwiseProduct(local());
      farthest = std::max(farthest, (now - momentum).norm() / momentum.norm());
    }
    CHECK(local().head<2>().norm() == doctest::Approx(0.5).epsilon(1e-6));
    CHECK(local()[2] == doctest::Approx(500).epsilon(1e-9));
    MESSAGE("the momentum turned by at most ", farthest);
    CHECK(farthest < 1e-3);
  }

  TEST_CASE("a body of three different inertias turns over again and again") {
    sim::robot_world w(free_body({1, {}, {1, 2, 3, 0, 0, 0}}));
    sim::moving_frame start;
    start.angular_velocity = {0.01, 10, 0};  // about its middle axis
    w.place({}, {}, start);
    int turned = 0;
    double side = 1, most = 0, least = 1e9;
    for (int k = 0; k < 20000; ++k) {
      w.advance({});
      const Eigen::Vector3d v = w.frame(-1).where.turn.transpose() * w.frame(-1).angular_velocity;
      const double energy = 0.5 * (v[0] * v[0] + 2 * v[1] * v[1] + 3 * v[2] * v[2]);
      most = std::max(most, energy), least = std::min(least, energy);
      if (std::abs(v[1]) > 9 && v[1] * side < 0) side = -side, ++turned;
    }
    CHECK(turned >= 5);
    CHECK(most - least < 1e-6 * most);
  }
}

TEST_SUITE("names") {
  TEST_CASE("parts, joints and sensors are found by name, and a wrong name is answered with the right ones") {
    sim::robot_world w(sim::model_of<arm::description>());
    CHECK(w.end("arm").where.at == w.end(0).where.at);
    CHECK(w.joint(arm::a4::label.view()).angle == w.joints()[3].angle);
    CHECK(&w.load("flange_load") == &w.load(0));
    w.pull("arm", {0, 8, 0});
    w.advance({});
    CHECK(w.end("arm").velocity[1] > 0);
    CHECK_THROWS_WITH_AS(w.end("amr"), "cca::sim: this robot has no part `amr`; it has `arm`",
                         std::out_of_range);
    sim::robot_world hand(sim::model_of<light_hand>());
    CHECK(&hand.inertial("turning") == &hand.inertial(0));
    CHECK_THROWS_AS(hand.inertial("load"), std::out_of_range);
  }
}
