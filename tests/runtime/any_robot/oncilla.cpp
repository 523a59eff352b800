// The Oncilla as a described robot with a port over all joints. tests/runtime/sim has what the robot does,
// whichever ports it has; robot_on_drives/oncilla.cpp has the trot with these.
#include <cstdint>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/sim/robot.hpp>

#include "accelerations.hpp"
#include "described_oncilla.hpp"

namespace laws {
std::size_t allocations();
}

using namespace world_test;

using namespace described_oncilla_test;

namespace {

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

}  // namespace

TEST_SUITE("oncilla as a described robot") {
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
}
