// The world and the library's dynamics agree: accelerations of random robots in random states, without
// contact.
//
// The engine integrates velocities of bodies, with joints as constraints on them. A step holds the
// constraints of its beginning, so the acceleration that the turning of the joints causes shows in the step
// after it: the difference of the speeds after two steps of h from a consistent state is the acceleration up
// to an error that is linear in h. Two extrapolations, with h, h/2 and h/4, remove its first two orders.
// Measured on the arm, relative: 5e-5 for h = 1e-5 s as it is, 2e-8 extrapolated once, 1e-11 twice.
#include <doctest/doctest.h>

#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/sim/robot/robot_world.hpp>

#include "../body/random_links.hpp"

namespace arm = cca::robots::arm;
namespace cd = cca::detail;
namespace sim = cca::sim;

namespace {

constexpr double agreed = 1e-8;  // relative; the bound that a robot's world has to keep is 1e-6
constexpr double h = 1e-5;       // s

using vector = Eigen::VectorXd;

struct motion {
  vector q, dq, torques;
  sim::moving_frame base;
};

// Nothing acts but the torques.
sim::robot_model without_losses(sim::robot_model m) {
  for (auto& d : m.drives) d = {.motor = {1e9, 1e9}};
  m.stops.assign(m.drives.size(), {});
  return m;
}

// Of the coordinates, then of the base: angular, linear, in the world.
vector accelerations_in_steps(sim::robot_model m, const motion& s, double step) {
  m.beat = step;
  sim::robot_world_settings exact;
  exact.steps_per_beat = 1;
  exact.engine.erp = exact.engine.cfm = 0;
  for (std::size_t k = 0; k < 3; ++k)
    exact.mount.translation[k] = s.base.where.at[static_cast<Eigen::Index>(k)];
  const Eigen::Vector4d turn = cd::quaternion_of(s.base.where.turn);
  exact.mount.rotation = {turn[0], turn[1], turn[2], turn[3]};
  sim::robot_world w(m, {}, exact);
  const auto n = static_cast<std::size_t>(s.q.size());
  w.place({s.q.data(), n}, {s.dq.data(), n}, s.base);
  std::vector<sim::joint_law> laws(n);
  for (std::size_t i = 0; i < n; ++i) laws[i].torque = s.torques[static_cast<Eigen::Index>(i)];
  const auto speeds = [&] {
    w.advance(laws);
    vector v(s.q.size() + 6);
    for (std::size_t i = 0; i < n; ++i) v[static_cast<Eigen::Index>(i)] = w.joints()[i].velocity;
    v.tail<6>() << w.frame(-1).angular_velocity, w.frame(-1).velocity;
    return v;
  };
  const vector first = speeds();
  for (std::size_t i = 0; i < n; ++i)
    CHECK(std::abs(w.joints()[i].angle - s.q[static_cast<Eigen::Index>(i)]) < 100 * step);
  return (speeds() - first) / step;
}

vector accelerations(const sim::robot_model& m, const motion& s) {
  const vector a = accelerations_in_steps(m, s, h), b = accelerations_in_steps(m, s, h / 2),
               c = accelerations_in_steps(m, s, h / 4);
  return (4 * (2 * c - b) - (2 * b - a)) / 3;
}

vector random_vector(laws::source& random, Eigen::Index size, double limit) {
  vector v(size);
  for (double& x : v) x = random(-limit, limit);
  return v;
}

sim::moving_frame random_base(laws::source& random) {
  return {cca::rigid{} * body_test::random_placement(random), random.vector(1), random.vector(1)};
}

double error(const vector& found, const vector& wanted) {
  return (found - wanted).norm() / (1 + wanted.norm());
}

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
    sim::robot_model coupled = robot.model;
    coupled.links[1].coordinate = 0;
    CHECK_THROWS_AS(sim::robot_world{coupled}, std::invalid_argument);
    sim::robot_model weightless = robot.model;
    weightless.links[1].inertia.mass = 0;
    CHECK_THROWS_AS(sim::robot_world{weightless}, std::invalid_argument);
    sim::robot_model flat = robot.model;
    flat.links[1].inertia.about_centre = {1, 1, 0, 0, 0, 0};
    CHECK_THROWS_AS(sim::robot_world{flat}, std::invalid_argument);
  }
}
