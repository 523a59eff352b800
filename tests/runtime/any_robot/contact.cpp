// Contact of described robots: tables, floors, walls and balls, and what a force sensor reads of it.
#include <doctest/doctest.h>

#include <cca/robots/arm/description.hpp>
#include <cca/robot/body_dynamics.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

namespace arm = cca::robots::arm;
namespace sim = cca::sim;

namespace {

using pose = cca::body_pose<arm::body>;
constexpr double radius = arm::description::tool_radius;
const pose::vector_type start = pose::vector_type::Map(arm::description::start.data());

pose::vector_type angles(const sim::robot_world& w) {
  pose::vector_type q;
  for (int i = 0; i < 7; ++i) q[i] = w.joints()[static_cast<std::size_t>(i)].angle;
  return q;
}

// Compensates gravity, damps, and presses the flange with `force` along the world's axes.
void press(sim::robot_world& w, const Eigen::Vector3d& force) {
  const pose now(angles(w));
  const pose::vector_type torques =
      cca::gravity_torques(now) + now.jacobian<"arm">().bottomRows<3>().transpose() * force;
  std::vector<sim::joint_law> laws(7);
  for (std::size_t i = 0; i < 7; ++i)
    laws[i] = {.torque = torques[static_cast<Eigen::Index>(i)], .damping = 4};
  w.advance(laws);
}

Eigen::Vector3d force_in_world(const sim::robot_world& w) {
  return w.end(0).where.turn * Eigen::Vector3d::Map(w.load(0).data() + 3);
}

// A table below the tool, which looks down.
sim::scene with_table(double gap) {
  const Eigen::Vector3d tip = pose(start).tip<"arm">().at;
  sim::scene s;
  s.add(sim::fixed_box{{0.4, 0.6, 0.04}, cca::at(tip[0], 0, tip[2] - 2 * radius - gap - 0.02)});
  return s;
}

struct arm_without_a_stop : arm::description {
  static constexpr auto drives = [] {
    auto all = arm::description::drives;
    all[0].stops = false;
    return all;
  }();
};
const double limit_of_first = sim::model_of<arm::description>().stops[0].high;

}  // namespace

TEST_SUITE("contact") {
  TEST_CASE("the force sensor reads how the tool presses on a table") {
    sim::robot_world w(sim::model_of<arm::description>(), with_table(0.002));
    for (int k = 0; k < 10; ++k) press(w, {0, 0, -10});
    CHECK(force_in_world(w).norm() == 0);  // not there yet
    for (int k = 0; k < 3000; ++k) press(w, {0, 0, -10});
    MESSAGE("force: ", force_in_world(w).transpose());
    CHECK(force_in_world(w)[2] == doctest::Approx(10).epsilon(0.01));
    CHECK(force_in_world(w).head<2>().norm() < 0.5);
    // It acts on the sphere's lowest point, straight below the flange: no torque about it but from tilt.
    const Eigen::Vector3d torque = Eigen::Vector3d::Map(w.load(0).data());
    const Eigen::Vector3d arm_in_flange =
        w.end(0).where.turn.transpose() *
        (w.end(0).where.turn * Eigen::Vector3d(0, 0, radius) - Eigen::Vector3d(0, 0, radius));
    const Eigen::Vector3d force = Eigen::Vector3d::Map(w.load(0).data() + 3);
    CHECK((torque - cca::detail::cross(arm_in_flange, force)).norm() < 0.01);
  }

  TEST_CASE("a table that moves away lets go - one that comes up pushes the arm") {
    sim::robot_world w(sim::model_of<arm::description>(), with_table(0));
    for (int k = 0; k < 1000; ++k) press(w, {0, 0, -5});
    REQUIRE(force_in_world(w)[2] == doctest::Approx(5).epsilon(0.05));
    const double height = w.end(0).where.at[2];
    cca::placement table = w.around().boxes[0].where;
    table.translation[2] += 0.02;
    w.move(0, table);
    for (int k = 0; k < 2000; ++k) press(w, {0, 0, -5});
    CHECK(w.end(0).where.at[2] - height == doctest::Approx(0.02).epsilon(0.05));
    table.translation[2] -= 0.5;
    w.move(0, table);
    press(w, {0, 0, -5});
    CHECK(force_in_world(w).norm() == 0);
  }

  TEST_CASE("friction carries up to its coefficient, and slides beyond") {
    for (const double share : {0.5, 1.3}) {
      sim::scene s = with_table(0);
      s.contact.friction = 0.6;
      sim::robot_world w(sim::model_of<arm::description>(), s);
      for (int k = 0; k < 1000; ++k) press(w, {0, 0, -10});
      const Eigen::Vector3d before = w.end(0).where.at;
      for (int k = 0; k < 500; ++k) press(w, {0, share * 6, -10});
      const double way = w.end(0).where.at[1] - before[1];
      MESSAGE("pulled with ", share, " of the friction: ", 1000 * way, " mm, ",
              force_in_world(w).transpose());
      CHECK((way > 0.02) == (share > 1));
      CHECK(std::abs(force_in_world(w)[1]) <= 6.3);
    }
  }

  TEST_CASE("a ball falls on the floor, is pushed by the arm, and feels it") {
    sim::scene s;
    s.floor = 0;
    s.add(sim::ball{.radius = 0.05, .mass = 0.2, .position = {1, 1, 0.3}});
    const Eigen::Vector3d tip = pose(start).tip<"arm">().at;
    s.add(sim::ball{.radius = 0.05, .mass = 0.2, .position = {tip[0], 0, tip[2] - 2 * radius - 0.0501}});
    sim::robot_world w(sim::model_of<arm::description>(), s);
    double load = 0;
    for (int k = 0; k < 2000; ++k) {
      press(w, {0, 0, k < 100 ? -60.0 : 0.0});
      load = std::max(load, force_in_world(w)[2]);
    }
    CHECK(w.ball_position(0)[2] == doctest::Approx(0.05).epsilon(0.02));
    CHECK(w.ball_velocity(0).norm() < 1e-3);
    CHECK(load > 1);
    CHECK(w.ball_position(1)[2] < 0.06);
  }

  TEST_CASE("a pull at the flange moves it, and is no contact") {
    sim::robot_world w(sim::model_of<arm::description>());
    w.pull(0, {0, 8, 0});
    for (int k = 0; k < 2000; ++k) press(w, {0, 0, 0});
    CHECK(w.end(0).where.at[1] > 0.1);
    CHECK(w.load(0) == std::array<double, 6>{});  // a pull is no contact
  }

  TEST_CASE("a stop ends the way of a joint, also beyond half a turn") {
    for (const std::size_t joint : {0U, 5U}) {
      sim::robot_world w(sim::model_of<arm::description>());
      for (int k = 0; k < 4000; ++k) {
        const pose::vector_type torques = cca::gravity_torques(pose(angles(w)));
        std::vector<sim::joint_law> laws(7);
        for (std::size_t i = 0; i < 7; ++i)
          laws[i] = {.torque = torques[static_cast<Eigen::Index>(i)] + (i == joint ? 10 : 0), .damping = 8};
        w.advance(laws);
        REQUIRE(w.joints()[joint].angle < w.model().stops[joint].high + 0.01);
      }
      CHECK(w.joints()[joint].angle == doctest::Approx(w.model().stops[joint].high).epsilon(0.001));
    }
  }

  TEST_CASE("limits that bound targets only end no way: the joint that says so goes on, the others stop") {
    sim::robot_world w(sim::model_of<arm_without_a_stop>());
    for (int k = 0; k < 4000; ++k) {
      const pose::vector_type torques = cca::gravity_torques(pose(angles(w)));
      std::vector<sim::joint_law> laws(7);
      for (std::size_t i = 0; i < 7; ++i)
        laws[i] = {.torque = torques[static_cast<Eigen::Index>(i)] + (i == 0 || i == 5 ? 10 : 0),
                   .damping = 8};
      w.advance(laws);
    }
    CHECK(w.joints()[0].angle > limit_of_first + 0.3);
    CHECK(w.joints()[5].angle == doctest::Approx(w.model().stops[5].high).epsilon(0.001));
    CHECK(!w.trouble());
  }

  TEST_CASE("a pull as strong as a push with torques leaves the arm at rest") {
    sim::robot_world w(sim::model_of<arm::description>());
    w.pull(0, {3, -4, 6});
    for (int k = 0; k < 2000; ++k) press(w, {-3, 4, -6});
    CHECK((angles(w) - start).cwiseAbs().maxCoeff() < 1e-6);
  }

  TEST_CASE("it falls without a command and without friction, and loses little energy before a stop") {
    sim::robot_model m = sim::model_of<arm::description>();
    for (auto& d : m.drives) d.friction = 0;
    m.stops.assign(7, {});
    const std::vector<sim::joint_law> none(7);
    double lost[2];
    for (const int steps : {2, 8}) {
      sim::robot_world_settings s;
      s.steps_per_beat = steps;
      sim::robot_world w(m, {}, s);
      const double before = w.energy();
      for (int k = 0; k < 300; ++k) w.advance(none);
      lost[steps == 8] = before - w.energy();
    }
    MESSAGE("energy lost in 0.3 s: ", lost[0], " J, with steps a quarter as long ", lost[1], " J");
    CHECK(std::abs(lost[0]) < 0.1);
    CHECK(lost[1] == doctest::Approx(lost[0] / 4).epsilon(0.1));  // the error is linear in the step
  }

  TEST_CASE("saved, restored and copied worlds go on bit for bit, in contact too") {
    sim::scene s = with_table(0);
    s.floor = -1;
    s.add(sim::ball{.radius = 0.05, .mass = 0.2, .position = {0.3, 0.5, 0}});
    sim::robot_world a(sim::model_of<arm::description>(), s);
    for (int k = 0; k < 200; ++k) press(a, {1, 0, -10});
    cca::placement table = s.boxes[0].where;
    table.translation[2] += 0.001;
    a.move(0, table);
    a.pull(0, {0, 1, 0});
    const sim::robot_state saved = a.save();
    sim::robot_world b = a;
    sim::robot_world c(sim::model_of<arm::description>(), s);
    c.restore(saved);
    for (sim::robot_world* w : {&a, &b, &c})
      for (int k = 0; k < 300; ++k) press(*w, {1, 0, -10});
    CHECK(a.hash() == b.hash());
    CHECK(a.hash() == c.hash());
    CHECK(a.hash() != saved.hash());
  }
}
