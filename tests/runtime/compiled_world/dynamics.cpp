// The equations of a compiled world are those of the library: accelerations, energy, ends, of random states.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <type_traits>

#include "../body/bodies.hpp"
#include "../body/recorded_bodies.hpp"
#include "accelerations.hpp"

using namespace compiled_test;

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
