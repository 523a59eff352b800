// The world and the library's dynamics agree: accelerations of random robots in random states, without
// contact.
#include <doctest/doctest.h>

#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robots/arm/description.hpp>

#include "../body/random_links.hpp"
#include "accelerations.hpp"

namespace arm = cca::robots::arm;
namespace cd = cca::detail;
namespace sim = cca::sim;

using namespace world_test;

namespace {

constexpr double agreed = 1e-8;  // relative; the bound that a robot's world has to keep is 1e-6

template <std::size_t Count>
struct random_robot {
  std::array<cd::body_link, Count> links;
  sim::robot_model model;

  random_robot(laws::source& random, bool chain, bool floats) {
    for (std::size_t i = 0; i < Count; ++i) {
      const int parent = body_test::random_parent(random, i, chain);
      cca::joint j = body_test::random_joint(random);
      j.ratio = random(0, 1) < 0.7 ? 1 : random(0.5, 2);
      j.rest = random(-1, 1);
      links[i] = cd::body_link_of(j, static_cast<int>(i), parent);
      links[i].inertia = body_test::random_inertia(random);
    }
    model.links.assign(links.begin(), links.end());
    model.base = body_test::random_inertia(random);
    model.floats = floats;
    model.drives.resize(Count);
    model.start.assign(Count, 0);
    model = without_losses(model);
  }

  vector wanted(const motion& s) const {
    constexpr int n = static_cast<int>(Count);
    const Eigen::Matrix<double, n, 1> q = s.q, dq = s.dq, torques = s.torques;
    std::array<cd::placed_link, Count> placed;
    cd::place_links(links, q, placed);
    cca::base_motion base;
    const Eigen::Matrix3d& turn = s.base.where.turn;
    base.gravity = turn.transpose() * base.gravity;
    const cd::vector6 none = cd::vector6::Zero();
    vector a = vector::Zero(n + 6);
    if (!model.floats) {
      a.head<n>() = cd::articulated_body<false, n>(links, placed, {}, dq, torques, base, none).accelerations;
      return a;
    }
    base.angular_velocity = turn.transpose() * s.base.angular_velocity;
    const auto found = cd::articulated_body<true, n>(links, placed, model.base, dq, torques, base, none);
    a << found.accelerations, turn * found.base.angular_acceleration, turn * found.base.acceleration;
    return a;
  }
};

}  // namespace

TEST_SUITE("dynamics") {
  TEST_CASE("the arm in the world accelerates as its dynamics say") {
    laws::source random{std::mt19937_64{171}};
    const sim::robot_model m = without_losses(sim::model_of<arm::description>());
    using pose = cca::body_pose<arm::body>;
    double worst = 0;
    for (int round = 0; round < 100; ++round) {
      motion s{random_vector(random, 7, 2.5), random_vector(random, 7, 2), random_vector(random, 7, 20), {}};
      const pose::vector_type q = s.q, dq = s.dq, torques = s.torques;
      const vector found = accelerations(m, s).head<7>(),
                   wanted = cca::forward_dynamics(pose(q), dq, torques);
      worst = std::max(worst, error(found, wanted));
    }
    MESSAGE("largest relative error: ", worst);
    CHECK(worst < agreed);
  }

  TEST_CASE_TEMPLATE("random robots with revolute and prismatic joints, chains and trees, do too", Count,
                     std::integral_constant<std::size_t, 1>, std::integral_constant<std::size_t, 3>,
                     std::integral_constant<std::size_t, 6>) {
    constexpr auto n = static_cast<Eigen::Index>(Count::value);
    laws::source random{std::mt19937_64{172}};
    double worst_fixed = 0, worst_floating = 0;
    for (int round = 0; round < 60; ++round) {
      const bool floats = round % 4 > 1;
      const random_robot<Count::value> robot(random, round % 2 == 0, floats);
      motion s{random_vector(random, n, 1), random_vector(random, n, 1), random_vector(random, n, 20),
               random_base(random)};
      double& worst = floats ? worst_floating : worst_fixed;
      worst = std::max(worst, error(accelerations(robot.model, s), robot.wanted(s)));
    }
    MESSAGE("largest relative error with ", Count::value, " joints: fixed ", worst_fixed, ", floating ",
            worst_floating);
    CHECK(worst_fixed < agreed);
    CHECK(worst_floating < agreed);
  }

  TEST_CASE("what the engine can't represent is refused") {
    laws::source random{std::mt19937_64{173}};
    random_robot<2> robot(random, true, false);
    sim::robot_model weightless = robot.model;
    weightless.links[1].inertia.mass = 0;
    CHECK_THROWS_AS(sim::robot_world{weightless}, std::invalid_argument);
    sim::robot_model flat = robot.model;
    flat.links[1].inertia.about_centre = {1, 1, 0, 0, 0, 0};
    CHECK_THROWS_AS(sim::robot_world{flat}, std::invalid_argument);
  }
}
