// Joints that follow others, springs and cables: the world and the library's dynamics agree, and what is
// ideal keeps its energy.
#include <algorithm>
#include <array>
#include <cstddef>

#include <doctest/doctest.h>

#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robots/description.hpp>

#include "accelerations.hpp"

namespace laws {
std::size_t allocations();
}

namespace robots = cca::robots;
namespace sim = cca::sim;
using namespace world_test;

namespace {

constexpr double agreed = 1e-6;  // relative

template <cca::fixed_string Name>
struct joint_axis : cca::dimension<Name> {
  static constexpr auto limits =
      cca::limits{cca::angle{-1.5, 1.5}, cca::velocity{-50, 50}, cca::torque{-50, 50}};
};

// A leg under a trunk: the lower segment stays parallel to the upper one, a cable bends the knee.
struct trunk : cca::frame<"trunk"> {};
struct toe : cca::frame<"toe"> {};
struct hip : joint_axis<"hip"> {};
struct knee : joint_axis<"knee"> {};

// [pantograph]
struct leg_chain : cca::serial_chain<trunk, toe, cca::axes<hip, knee>> {
  static constexpr std::array joints{cca::revolute({0, 1, 0.1}, cca::at(0.1, 0.05, 0)),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1)),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1))
                                         .driven_by("knee", -1)};  // parallel to the upper segment
  // [pantograph end]
  static constexpr auto tip = cca::at(0, 0, -0.08);
  static constexpr std::array links{
      cca::link_inertia{0.15, {0.001, 0, -0.05}, {2e-4, 2e-4, 3e-5, 0, 1e-6, 0}},
      cca::link_inertia{0.12, {0, 0.002, -0.04}, {1.5e-4, 1.4e-4, 2e-5, 0, 0, 1e-6}},
      cca::link_inertia{0.07, {0, 0, -0.03}, {6e-5, 6e-5, 1e-5, 0, 0, 0}}};
};
struct leg_body : cca::body<trunk, cca::part<"leg", leg_chain, cca::driven_by<"hip", "knee">>> {
  static constexpr cca::link_inertia base{2.0, {0, 0, 0.02}, {4e-3, 2e-2, 2e-2, 0, 1e-4, 0}};
};
struct leg {
  using body = leg_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr bool floats = true;
  static constexpr std::array<robots::joint_drive, 2> drives{{{.motor = {20, 50}}, {.motor = {20, 50}}}};
};
// [cable]
struct strung_leg : leg {
  static constexpr std::array line_springs{
      robots::cable(
          robots::point_on("leg", 0, {0.03, 0, 0}), robots::point_at_tip("leg", {0.02, 0, 0}), 800, 0.26, 4),
      robots::line_spring{.from = robots::point_on_base({0.2, 0, 0.01}),
                          .to = robots::point_on("leg", 1, {-0.01, 0, -0.02}),
                          .stiffness = 300,
                          .rest = 0.2}};
};
// [cable end]
struct leg_on_a_stand : strung_leg {
  static constexpr bool floats = false;
};

// A wrist with two fingers, of which the second follows the first, and a wheel that their rack turns.
struct forearm : cca::frame<"forearm"> {};
struct palm : cca::frame<"palm"> {};
struct left_tip : cca::frame<"left"> {};
struct right_tip : cca::frame<"right"> {};
struct wheel_rim : cca::frame<"rim"> {};
struct wrist : joint_axis<"wrist"> {};
struct finger : joint_axis<"finger"> {};

struct wrist_chain : cca::serial_chain<forearm, palm, cca::axes<wrist>> {
  static constexpr std::array joints{cca::revolute(cca::along_x, cca::at(0, 0, 0.1))};
  static constexpr auto tip = cca::at(0, 0, 0.05);
  static constexpr std::array links{cca::link_inertia{0.7, {0, 0, 0.02}, {2e-3, 2e-3, 1e-3, 0, 0, 0}}};
};
// [follows]
struct left_chain : cca::serial_chain<palm, left_tip, cca::axes<finger>> {
  static constexpr std::array joints{cca::prismatic(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0.01, 0.04);
  static constexpr std::array links{cca::link_inertia{0.1, {0, 0, 0.02}, {2e-5, 2e-5, 1e-5, 0, 0, 0}}};
};
struct right_chain : cca::serial_chain<palm, right_tip, cca::axes<>> {  // half as far, the other way
  static constexpr std::array joints{cca::prismatic(cca::along_y).driven_by("finger", -0.5, -0.02)};
  static constexpr auto tip = cca::at(0, -0.01, 0.04);
  static constexpr std::array links{cca::link_inertia{0.15, {0, 0, 0.02}, {2e-5, 2e-5, 1e-5, 0, 0, 0}}};
};
// [follows end]
struct wheel_chain : cca::serial_chain<palm, wheel_rim, cca::axes<>> {
  static constexpr std::array joints{
      cca::revolute({1, 2, 2}, cca::at(0.03, 0, 0)).driven_by("finger", 20, 0.3)};
  static constexpr auto tip = cca::at(0, 0, 0);
  static constexpr std::array links{cca::link_inertia{0.05, {0.003, 0, 0}, {2e-5, 2e-5, 3e-5, 0, 0, 0}}};
};
struct gripper_body : cca::body<forearm,
                                cca::part<"wheel", wheel_chain>,
                                cca::part<"right", right_chain>,
                                cca::part<"wrist", wrist_chain, cca::driven_by<"wrist">>,
                                cca::part<"left", left_chain, cca::driven_by<"finger">>> {
  static constexpr cca::link_inertia base{1.0, {0, 0, 0}, {4e-3, 4e-3, 4e-3, 0, 0, 0}};
};
struct gripper {
  using body = gripper_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  using sensors = robots::sensors<robots::force_sensor<"right", "right">>;
  static constexpr std::array<robots::joint_drive, 2> drives{
      {{.motor = {20, 50}, .friction = 0.1}, {.motor = {20, 50}, .friction = 2}}};
  static constexpr std::array shapes{robots::at_tip("right", robots::sphere(0.01))};
};
struct floating_gripper : gripper {
  static constexpr bool floats = true;
};

// Each coordinate moves its only joint through a gear: the leader has a ratio too.
struct geared_chain : cca::serial_chain<trunk, toe, cca::axes<hip, knee>> {
  static constexpr std::array joints{
      cca::revolute({0, 1, 0.1}, cca::at(0.1, 0.05, 0)).driven_by("hip", -0.5, 0.2),
      cca::prismatic({0.1, 0, 1}, cca::at(0, 0, -0.1)).driven_by("knee", 0.2, -0.05)};
  static constexpr auto tip = cca::at(0, 0, -0.08);
  static constexpr std::array links{
      cca::link_inertia{0.15, {0.001, 0, -0.05}, {2e-4, 2e-4, 3e-5, 0, 1e-6, 0}},
      cca::link_inertia{0.12, {0, 0.002, -0.04}, {1.5e-4, 1.4e-4, 2e-5, 0, 0, 1e-6}}};
};
struct geared : leg {
  struct body : cca::body<trunk, cca::part<"leg", geared_chain, cca::driven_by<"hip", "knee">>> {};
  static constexpr bool floats = false;
};

// Of strung_leg, along the base's axes: the two ends of its cable and of its spring.
struct ends {
  Eigen::Vector3d cable_from, cable_to, spring_from, spring_to;
};
ends ends_of(const Eigen::Vector2d& q) {
  const pose_of<leg> now(q);
  const auto in = [&](std::size_t link, double x, double z) -> Eigen::Vector3d {
    const cca::rigid& f = now.links()[link].frame;
    return f.at + f.turn * Eigen::Vector3d(x, 0, z);
  };
  return {in(0, 0.03, 0), in(2, 0.02, -0.08), {0.2, 0, 0.01}, in(1, -0.01, -0.02)};
}
double cable_length(const Eigen::Vector2d& q) { return (ends_of(q).cable_to - ends_of(q).cable_from).norm(); }
double spring_length(const Eigen::Vector2d& q) {
  return (ends_of(q).spring_to - ends_of(q).spring_from).norm();
}

// The generalised forces of both, from differences of their lengths. They move with the base, so they do
// nothing to it as a whole.
vector strings(const motion& s) {
  const Eigen::Vector2d q = s.q, dq = s.dq;
  const auto slope = [&q](auto length) {
    Eigen::Vector2d g;
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d d = 1e-5 * Eigen::Vector2d::Unit(k);
      g[k] = (8 * (length(q + d) - length(q - d)) - (length(q + 2 * d) - length(q - 2 * d))) / 12e-5;
    }
    return g;
  };
  const Eigen::Vector2d cable = slope(cable_length), spring = slope(spring_length);
  const double stretch = cable_length(q) - 0.26;
  const double tension = stretch > 0 ? std::max(0.0, 800 * stretch + 4 * cable.dot(dq)) : 0;
  vector all = vector::Zero(8);
  all.head<2>() = -tension * cable - 300 * (spring_length(q) - 0.2) * spring;
  return all;
}

template <class R>
sim::robot_world world_of(int steps, sim::scene around = {}) {
  sim::robot_world_settings s;
  s.steps_per_beat = steps;
  return sim::robot_world(sim::model_of<R>(), std::move(around), s);
}

}  // namespace

TEST_SUITE("coupled joints") {
  TEST_CASE("the pantograph of a floating leg accelerates as its dynamics say") {
    CHECK(worst_error<leg>(21, nothing<leg>) < agreed);
  }
  TEST_CASE("joints that follow those of other parts do, on a fixed and a floating base") {
    CHECK(worst_error<gripper>(22, nothing<gripper>) < agreed);
    CHECK(worst_error<floating_gripper>(23, nothing<floating_gripper>) < agreed);
  }

  TEST_CASE("a coordinate that moves its only joint through a gear does") {
    CHECK(worst_error<geared>(26, nothing<geared>) < agreed);
  }

  TEST_CASE("followers stay where they belong, to rounding") {
    sim::robot_world w = world_of<gripper>(2);
    const std::array<sim::joint_law, 2> laws{sim::joint_law{.torque = 0.5}, sim::joint_law{.torque = 1}};
    const auto before = w.end(3).where.at;
    for (int i = 0; i < 300; ++i) w.advance(laws);
    const double moved = w.joints()[1].angle;
    CHECK(moved > 0.01);
    const Eigen::Vector3d left = w.end(3).where.at, right = w.end(1).where.at, palm = w.end(2).where.at;
    CHECK((left - before).norm() > 0.01);
    // Along the fingers' line: each its way from the palm.
    const Eigen::Vector3d along = w.end(2).where.turn.col(1);
    CHECK((left - palm).dot(along) == doctest::Approx(moved + 0.01).epsilon(1e-12));
    CHECK((right - palm).dot(along) == doctest::Approx(-0.5 * moved - 0.02 - 0.01).epsilon(1e-12));
  }

  TEST_CASE("gears take no energy: what drifts shrinks with the step") {
    std::array<double, 2> drift{};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<double> q{0.7, 0.6}, still{0, 0};
      sim::robot_model free = without_losses(sim::model_of<leg_on_a_stand>());
      free.line_springs.clear();
      sim::robot_world_settings s;
      s.steps_per_beat = k == 0 ? 4 : 16;
      sim::robot_world w(free, {}, s);
      w.place(q, still);
      const double before = w.energy();
      for (int i = 0; i < 500; ++i) {
        w.advance({});
        drift[k] = std::max(drift[k], std::abs(w.energy() - before));
      }
    }
    MESSAGE("largest change of energy, J: ", drift[0], ", with steps of a quarter: ", drift[1]);
    CHECK(drift[0] < 5e-3);
    CHECK(drift[1] < 0.4 * drift[0]);
  }

  TEST_CASE("a follower that presses on a wall feels the motor through the gear") {
    sim::scene wall;
    wall.add(sim::fixed_box{{0.2, 0.02, 0.4}, cca::at(0, -0.08, 0.2)});  // its face is at y = -0.07
    sim::robot_world w = world_of<gripper>(2, wall);
    std::array<sim::joint_law, 2> laws{sim::joint_law{.stiffness = 50, .damping = 1},
                                       sim::joint_law{.torque = 3}};
    for (int i = 0; i < 2000; ++i) w.advance(laws);
    CHECK(std::abs(w.joints()[1].velocity) < 1e-3);
    CHECK(w.load(0)[4] == doctest::Approx(3 / 0.5).epsilon(0.02));  // half the way, twice the force
  }

  TEST_CASE("a copy goes on with the same bits, and a beat allocates nothing") {
    sim::robot_world w = world_of<strung_leg>(2);
    const std::array<sim::joint_law, 2> laws{sim::joint_law{.torque = 0.4}, sim::joint_law{.torque = -0.3}};
    for (int i = 0; i < 50; ++i) w.advance(laws);
    sim::robot_world copy = w;
    const auto before = laws::allocations();
    for (int i = 0; i < 50; ++i) w.advance(laws);
    CHECK(laws::allocations() == before);
    for (int i = 0; i < 50; ++i) copy.advance(laws);
    CHECK(copy.hash() == w.hash());
  }

  TEST_CASE("a coordinate needs a joint that it moves") {
    sim::robot_model m = sim::model_of<gripper>();
    for (auto& l : m.links)
      if (l.coordinate == 1) l.ratio = 0;
    CHECK_THROWS_AS(sim::robot_world{m}, std::invalid_argument);
    for (auto& l : m.links) l.coordinate = 0;
    CHECK_THROWS_AS(sim::robot_world{m}, std::invalid_argument);
  }
}

TEST_SUITE("springs and cables") {
  TEST_CASE("a leg with both accelerates as its dynamics and their lengths say") {
    CHECK(worst_error<leg_on_a_stand>(24, strings) < agreed);
    CHECK(worst_error<strung_leg>(25, strings) < agreed);
  }

  TEST_CASE("a cable never pushes, and pulls where it is taut") {
    sim::robot_world w = world_of<leg_on_a_stand>(4);
    double least = 1, most = 0;
    int slack = 0, wrong = 0;
    for (int i = 0; i < 3000; ++i) {
      const double torque = i % 600 < 300 ? 4 : -4;
      w.advance(std::array{sim::joint_law{.torque = torque / 4}, sim::joint_law{.torque = torque}});
      const double force = w.tension(0), length = cable_length({w.joints()[0].angle, w.joints()[1].angle});
      least = std::min(least, force), most = std::max(most, force);
      slack += length < 0.26;
      wrong += length < 0.26 && force != 0;
    }
    CHECK(least == 0);
    CHECK(most > 1);
    CHECK(slack > 100);
    CHECK(slack < 2900);
    CHECK(wrong == 0);
  }

  TEST_CASE("springs keep their energy: what drifts shrinks with the step") {
    std::array<double, 2> drift{};
    double swing = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      sim::robot_model m = without_losses(sim::model_of<leg_on_a_stand>());
      m.line_springs[0].damping = 0;
      sim::robot_world_settings s;
      s.steps_per_beat = k == 0 ? 8 : 32;
      sim::robot_world w(m, {}, s);
      const std::vector<double> q{0.4, 0.3}, still{0, 0};
      w.place(q, still);
      const double before = w.energy() + w.spring_energy(), stored = w.spring_energy();
      for (int i = 0; i < 500; ++i) {
        w.advance({});
        drift[k] = std::max(drift[k], std::abs(w.energy() + w.spring_energy() - before));
        swing = std::max(swing, std::abs(w.spring_energy() - stored));
      }
    }
    MESSAGE("largest change of energy, J: ", drift[0], ", with steps of a quarter: ", drift[1],
            "; the springs' own: ", swing);
    CHECK(swing > 0.05);
    CHECK(drift[1] < 0.4 * drift[0]);
    CHECK(drift[1] < 0.1 * swing);
  }
}
