// The equations of a compiled world are those of the library: accelerations, energy, ends, of random states.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <type_traits>

#include <cca/robot/dynamics/forward_dynamics.hpp>

#include "../body/bodies.hpp"
#include "../body/recorded_bodies.hpp"
#include "robots.hpp"

using namespace compiled_test;

namespace {

// The largest relative error of the accelerations, of 100 random states with random torques.
template <class R>
double worst_acceleration() {
  constexpr auto n = static_cast<int>(coordinates<R>);
  using vector = Eigen::Matrix<double, n, 1>;
  constexpr std::size_t base = R::floats ? 6 : 0;
  laws::source random{std::mt19937_64{31}};
  double worst = 0;
  for (int round = 0; round < 100; ++round) {
    sim::detail::tree_motion<double, n, R::floats> m;
    m.q = random_numbers<R>(random, 3), m.dq = random_numbers<R>(random, 3);
    m.attitude.q = random_place(random).rotation;
    const Eigen::Vector3d turning = random.vector(3);
    if (R::floats) m.angular_velocity = {turning[0], turning[1], turning[2]};
    const numbers<R> torques = random_numbers<R>(random, 5);

    const sim::detail::built_robot<R> built;
    sim::detail::tree_step<R, double> step(0, built);
    step.begin(m, 9.81);
    auto found = step.now.forces;
    for (std::size_t c = 0; c < torques.size(); ++c)
      found[static_cast<std::size_t>(step.now.rows.row[base + c])] += torques[c];
    sim::detail::limb_solution<R, double>::factor_and_solve(step.now.mass, found);

    const cca::body_pose<typename R::body> pose(vector::Map(m.q.data()));
    const vector dq = vector::Map(m.dq.data()), t = vector::Map(torques.data());
    Eigen::Matrix<double, static_cast<int>(base) + n, 1> wanted;
    Eigen::Matrix3d turn;
    for (int k = 0; k < 3; ++k)
      for (int r = 0; r < 3; ++r)
        turn(r, k) = step.base.axes[static_cast<std::size_t>(k)][static_cast<std::size_t>(r)];
    cca::base_motion b;
    b.gravity = turn.transpose() * Eigen::Vector3d(0, 0, -9.81);
    if constexpr (R::floats) {
      b.angular_velocity = turn.transpose() * turning;
      const auto a = cca::floating_forward_dynamics(pose, dq, t, b);
      wanted << a.base.angular_acceleration, a.base.acceleration, a.accelerations;
    } else {
      wanted = cca::forward_dynamics(pose, dq, t, b);
    }
    double error = 0;
    for (std::size_t v = 0; v < base + torques.size(); ++v)
      error = std::max(error, std::abs(found[static_cast<std::size_t>(step.now.rows.row[v])] -
                                       wanted[static_cast<Eigen::Index>(v)]));
    worst = std::max(worst, error / wanted.norm());
  }
  return worst;
}

}  // namespace

TEST_SUITE("compiled world: dynamics") {
  TEST_CASE_TEMPLATE("accelerations are those of the library", R, limp_arm, flying_oncilla,
                     alone<body_test::arm, true>, alone<body_test::hound, true>,
                     alone<body_test::star_of_arms, true>, alone<body_test::star_of_arms, false>,
                     alone<body_test::random_tree_body, true>, alone<body_test::humanoid, true>) {
    const double worst = worst_acceleration<R>();
    MESSAGE("largest relative error: ", worst);
    CHECK(worst < 1e-9);
  }

  TEST_CASE("energy and ends are those of the library") {
    laws::source random{std::mt19937_64{32}};
    double worst = 0;
    for (int round = 0; round < 50; ++round) {
      using R = flying_oncilla;
      sim::compiled_world<R> w;
      const auto place = random_place(random);
      const Eigen::Vector3d turning = random.vector(2), velocity = random.vector(2);
      w.place(random_numbers<R>(random, 1), random_numbers<R>(random, 2), place,
              {turning[0], turning[1], turning[2]}, {velocity[0], velocity[1], velocity[2]});
      const auto pose = pose_of(w);
      const cca::rigid base = cca::rigid{} * place;
      Eigen::Matrix<double, 22, 1> v;
      v << base.turn.transpose() * turning, base.turn.transpose() * velocity, speeds_of(w);
      const Eigen::Vector3d centre = base.turn * pose.centre_of_mass() + base.at;
      const double wanted =
          0.5 * v.dot(cca::floating_mass_matrix(pose) * v) + 9.81 * robots::oncilla::body.mass() * centre[2];
      worst = std::max(worst, std::abs(w.energy() - wanted));
      const auto found = w.centre_of_mass();
      worst = std::max(worst, (Eigen::Vector3d(found[0], found[1], found[2]) - centre).norm());
      const cca::rigid end = pose.tip<"right_hind_leg">();
      const sim::moving_frame seen = w.end("right_hind_leg");
      worst = std::max(worst, (seen.where.at - (base.turn * end.at + base.at)).norm());
      worst = std::max(worst, (seen.where.turn - base.turn * end.turn).norm());
      const Eigen::Matrix<double, 6, 1> relative = pose.jacobian<"right_hind_leg">() * speeds_of(w);
      const Eigen::Vector3d moves =
          velocity + turning.cross(base.turn * end.at) + base.turn * relative.tail<3>();
      worst = std::max(worst, (seen.velocity - moves).norm());
      worst = std::max(worst, (seen.angular_velocity - turning - base.turn * relative.head<3>()).norm());
    }
    MESSAGE("largest error: ", worst);
    CHECK(worst < 1e-12);
  }

  TEST_CASE("a world is a plain value") {
    static_assert(std::is_trivially_copyable_v<sim::compiled_world<limp_arm>>);
    static_assert(std::is_trivially_copyable_v<sim::compiled_world<flying_oncilla>>);
  }
}
