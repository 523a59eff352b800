// The Oncilla as a described robot with a port over all joints: its legs stand in the engine as the closed
// form has them, and the trot of the examples walks with it on flat ground, slopes and steps, as with the
// ports of the real robot.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/robots/oncilla/description.hpp>
#include <cca/sim/robot.hpp>

#include "accelerations.hpp"
#include "described_oncilla.hpp"

namespace laws {
std::size_t allocations();
}

using namespace world_test;

using namespace described_oncilla_test;

namespace {

constexpr double gravity = sim::engine_settings{}.gravity;

struct described_trot : trot_of<sim::robot<described>> {};

cca::controller<described_trot> ready(const sim::terrain& ground, std::uint64_t seed, double seconds) {
  cca::controller<described_trot> controller;
  controller.load();
  const auto disturbance = sim::disturbance::from_seed(seed, seconds);
  controller.get<"robot.body.simulator">().put_down(
      put_down(trot::put_down(controller.get<"gait">().p, disturbance),
               on(ground.with_friction(disturbance.friction))));
  return controller;
}

walk walked(const sim::terrain& ground, std::uint64_t seed, double seconds) {
  auto controller = ready(ground, seed, seconds);
  controller.start();
  return walked_in(controller.get<"robot.body.simulator">().world(), seconds,
                   [&] { REQUIRE(controller.step()); });
}

}  // namespace

TEST_SUITE("oncilla as a described robot") {
  TEST_CASE("it weighs what the robot weighs, and its feet are where the closed form has them") {
    const sim::robot_model m = sim::model_of<described>();
    double mass = m.base.mass;
    for (const auto& l : m.links) mass += l.inertia.mass;
    CHECK(mass == doctest::Approx(numbers.mass()));

    sim::initial_posture posture;
    for (std::size_t leg = 0; leg < 4; ++leg)
      posture.legs[leg] = {0.3 * static_cast<double>(leg) - 0.4, 0.8 + 0.4 * static_cast<double>(leg), 0.1};
    const sim::robot_world w = put_down(posture, {});
    const Eigen::Vector3d trunk = w.frame(-1).where.at;
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const auto foot = sim::foot_position(numbers, {posture.legs[leg].hip, posture.legs[leg].knee});
      const auto hip = oncilla::leg_geometry(leg).hip.translation;
      const double side = oncilla::side_of(leg);
      CHECK(w.end(leg).where.at.isApprox(
          trunk + Eigen::Vector3d(hip[0] + foot.x, hip[1] - side * foot.z * std::sin(0.1),
                                  hip[2] + foot.z * std::cos(0.1)),
          1e-9));
      CHECK(w.tension(leg) ==
            doctest::Approx(numbers.spring_rate * sim::diagonal_stretch(numbers, posture.legs[leg].knee)));
    }
  }

  TEST_CASE("it stands: the feet carry its weight, the accelerometer reads gravity") {
    const sim::initial_posture posture = sim::standing_posture();
    cca::controller<described_trot> controller;
    controller.load();
    auto throttle = controller.get<"throttle">().p;
    throttle.start = 100;
    controller.set<"throttle">(throttle);
    auto& simulator = controller.get<"robot.body.simulator">();
    simulator.put_down(put_down(posture, on(sim::terrain::flat())));
    controller.start();
    for (int k = 0; k < 2000; ++k) REQUIRE(controller.step());
    const sim::robot_world& w = simulator.world();
    double load = 0;
    Eigen::Vector3d felt = Eigen::Vector3d::Zero();
    for (int k = 0; k < 2000; ++k) {
      REQUIRE(controller.step());
      for (std::size_t leg = 0; leg < 4; ++leg)
        load += (w.end(leg).where.turn * Eigen::Vector3d::Map(w.load(leg).data() + 3))[2] / 2000;
      felt += Eigen::Vector3d::Map(w.inertial(0).specific_force.data()) / 2000;
      const Eigen::Matrix3d upper = w.frame(1).where.turn, lower = w.frame(3).where.turn;
      CHECK((upper - lower).norm() < 1e-6);  // the pantograph
    }
    CHECK(load == doctest::Approx(numbers.mass() * gravity).epsilon(0.01));
    CHECK(felt[2] == doctest::Approx(gravity).epsilon(0.01));
    CHECK(felt.head<2>().norm() < 0.5);
    CHECK(Eigen::Vector4d::Map(w.inertial(0).orientation.data()).norm() == doctest::Approx(1));
  }

  TEST_CASE("without contact it accelerates as its dynamics say, pantographs and all") {
    sim::robot_model m = sim::model_of<described>();
    m.line_springs.clear();
    CHECK(worst_error<described>(27, nothing<described>, m) < 1e-6);
  }

  TEST_CASE("a copy in the middle of a trot goes on with the same bits, and a beat allocates nothing") {
    auto first = ready(sim::terrain::steps(0.006, 0.2, 1, 0.3), 5, 4);
    first.start();
    for (int k = 0; k < 2000; ++k) REQUIRE(first.step());
    auto second = first;
    const auto before = laws::allocations();
    for (int k = 0; k < 500; ++k) first.step();
    CHECK(laws::allocations() == before);
    for (int k = 0; k < 500; ++k) second.step();
    CHECK(first.get<"robot.body.simulator">().world().hash() ==
          second.get<"robot.body.simulator">().world().hash());
  }

  TEST_CASE("the trot walks with it as with cca::sim::oncilla, whose ports it was made for") {
    double here = 0, there = 0;
    constexpr int seeds = 4;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const walk w = walked(sim::terrain::flat(), seed, 8);
      MESSAGE("seed ", seed, ": ", w.speed, " m/s, slip ", w.slip, ", aside ", w.aside,
              std::string(w.fell ? ", fell" : ""));
      CHECK(!w.fell);
      CHECK(w.slip < 0.15);
      here += w.speed / seeds;

      trot::trotting controller;
      controller.load();
      const trot::recording run =
          trot::roll_out(controller, sim::terrain::flat(), sim::disturbance::from_seed(seed, 8), 8, [] {});
      REQUIRE(run.moments.size() == 8000);
      there += (run.moments.back().position[0] - run.moments[2000].position[0]) / 6 / seeds;
    }
    MESSAGE("mean speed, m/s: ", here, ", of cca::sim::oncilla: ", there);
    CHECK(here == doctest::Approx(there).epsilon(0.05));
  }

  TEST_CASE("on slopes and steps") {
    for (const auto& ground : {sim::terrain::slope(oncilla::degrees(6)),
                               sim::terrain::slope(oncilla::degrees(-6)), sim::terrain::steps(0.006)}) {
      const walk w = walked(ground, 4, 10);
      MESSAGE(ground.name(), ": ", w.speed, " m/s, slip ", w.slip, std::string(w.fell ? ", fell" : ""));
      CHECK(!w.fell);
      CHECK(w.speed > 0.4);
    }
  }
}
