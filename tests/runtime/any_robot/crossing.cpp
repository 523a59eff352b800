// Two hinges that cross at right angles, without a mass between them: one universal joint of the engine. The
// same angles, stops, servos and dynamics as two hinges have.
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/robot/body_pose.hpp>
#include <cca/sim/robot.hpp>

#include "accelerations.hpp"

using namespace world_test;

namespace {

namespace sim = cca::sim;
namespace robots = cca::robots;

struct room {};
struct tip_frame {};

template <cca::fixed_string Name>
struct bounded : cca::dimension<Name> {
  static constexpr auto limits =
      cca::limits{cca::angle{-0.7, 1.3}, cca::velocity{-20, 20}, cca::torque{-50, 50}};
};
struct aside : bounded<"aside"> {};
struct ahead : bounded<"ahead"> {};
struct bent : bounded<"bent"> {};

// A hip whose axes lie askew, and a knee.
struct leg_chain : cca::serial_chain<room, tip_frame, cca::axes<aside, ahead, bent>> {
  static constexpr std::array joints{
      cca::revolute({-1, 0, 0}, cca::at(0.1, 0.2, 0.3) * cca::turned_about({0.3, -0.4, 0.5}, 0.7)),
      cca::revolute({0, 0.6, 0.8}, cca::turned_about({1, 0, 0}, 0.4)),
      cca::revolute(cca::along_y, cca::at(0.02, -0.01, -0.3))};
  static constexpr auto tip = cca::at(0, 0, -0.2);
  static constexpr std::array links{cca::link_inertia{},
                                    cca::link_inertia{1.5, {0, 0.01, -0.15}, {0.02, 0.03, 0.01, 0.001}},
                                    cca::link_inertia{0.7, {0, 0, -0.1}, {0.01, 0.01, 0.002}}};
};
template <bool Floats>
struct leg {
  struct body : cca::body<room, cca::part<"leg", leg_chain>> {
    static constexpr cca::link_inertia base{4, {0.01, 0, 0.02}, {0.1, 0.12, 0.15}};
  };
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr bool floats = Floats;
  static constexpr robots::joint_drive drive{.motor = {50, 40}, .friction = 0.05};
  static constexpr std::array<robots::joint_drive, 3> drives{drive, drive, drive};
};

sim::robot_world_settings weightless() {
  sim::robot_world_settings s;
  s.engine.gravity = 0;
  return s;
}

template <class R>
void check_places() {
  sim::robot_world w(sim::model_of<R>(), {}, weightless());
  laws::source random{std::mt19937_64{5}};
  for (int round = 0; round < 50; ++round) {
    std::vector<double> q, dq;
    for (int i = 0; i < 3; ++i) q.push_back(random(-0.7, 1.3)), dq.push_back(random(-3, 3));
    w.place(q, dq);
    const cca::body_pose<typename R::body> pose(Eigen::Vector3d(q[0], q[1], q[2]));
    const cca::rigid tip = pose.template tip<"leg">();
    CHECK(w.end("leg").where.at.isApprox(tip.at, 1e-9));
    w.advance(std::array<sim::joint_law, 3>{});
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(w.joints()[i].angle == doctest::Approx(q[i] + 1e-3 * dq[i]).epsilon(0.02));
      CHECK(w.joints()[i].velocity == doctest::Approx(dq[i]).epsilon(0.1));
    }
  }
}

template <class R>
void check_stops() {
  for (const std::size_t joint : {0, 1})
    for (const double way : {-1.0, 1.0}) {
      CAPTURE(joint);
      CAPTURE(way);
      sim::robot_world w(sim::model_of<R>(), {}, weightless());
      std::array<sim::joint_law, 3> laws{};
      for (auto& l : laws) l = {.stiffness = 20, .damping = 1};
      laws[joint] = {.torque = 2 * way};
      double farthest = 0;
      for (int k = 0; k < 1500; ++k) {
        w.advance(laws);
        farthest = std::max(farthest, way * w.joints()[joint].angle);
      }
      CHECK(w.joints()[joint].angle == doctest::Approx(way < 0 ? -0.7 : 1.3).epsilon(0.02));
      CHECK(farthest < (way < 0 ? 0.7 : 1.3) + 0.05);
      CHECK(!w.trouble());
    }
}

// So stiff that the engine holds them: as constraints.
template <class R>
void check_servos() {
  sim::robot_world w(sim::model_of<R>(), {}, weightless());
  const std::array<double, 3> goal{-0.4, 0.9, 0.3};
  std::array<sim::joint_law, 3> laws{};
  for (std::size_t i = 0; i < 3; ++i) laws[i] = {.position = goal[i], .stiffness = 1e5, .damping = 500};
  for (int k = 0; k < 3000; ++k) w.advance(laws);
  CHECK(!w.trouble());
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(w.joints()[i].angle == doctest::Approx(goal[i]).epsilon(1e-3));
    CHECK(std::abs(w.joints()[i].velocity) < 1e-2);
  }
}

}  // namespace

TEST_SUITE("joints that cross") {
  TEST_CASE("angles and speeds are those at which the robot was put down, and its tip is where they say") {
    check_places<leg<false>>();
    check_places<leg<true>>();
  }

  TEST_CASE("it accelerates as its dynamics say, on a base that is fixed and on one that floats") {
    CHECK(worst_error<leg<false>>(3, nothing<leg<false>>) < 1e-8);
    CHECK(worst_error<leg<true>>(4, nothing<leg<true>>) < 1e-8);
  }

  TEST_CASE("each axis has its own stops, on both sides") {
    check_stops<leg<false>>();
    check_stops<leg<true>>();
  }

  TEST_CASE("servos of any stiffness hold both axes") {
    check_servos<leg<false>>();
    check_servos<leg<true>>();
  }

  TEST_CASE("a copy goes on with the same bits") {
    sim::robot_world first(sim::model_of<leg<true>>(), {}, weightless());
    const std::array<sim::joint_law, 3> laws{{{.torque = 0.3}, {.torque = -0.2}, {.torque = 0.1}}};
    for (int k = 0; k < 200; ++k) first.advance(laws);
    sim::robot_world second(first);
    for (int k = 0; k < 200; ++k) first.advance(laws), second.advance(laws);
    CHECK(first.hash() == second.hash());
  }

  TEST_CASE("what has no mass carries nothing") {
    sim::robot_model m = sim::model_of<leg<false>>();
    m.shapes.push_back({.link = 0, .form = robots::sphere(0.01)});
    CHECK_THROWS_WITH_AS(sim::robot_world{m}, doctest::Contains("link 0 has no mass, so it can't carry"),
                         std::invalid_argument);
    m = sim::model_of<leg<false>>();
    m.links[1].at = {0, 0, -0.01};  // the axes don't cross
    CHECK_THROWS_WITH_AS(sim::robot_world{m}, doctest::Contains("link 0 needs a mass above 0"),
                         std::invalid_argument);
  }
}
