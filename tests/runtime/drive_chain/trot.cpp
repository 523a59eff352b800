// The trot on virtual drives: the same architecture as in the simulator, over five buses in memory.
#include <cmath>
#include <type_traits>

#include <doctest/doctest.h>

#include <cca/sim/oncilla.hpp>

#include "../../../examples/hardware_in_the_loop/in_memory.hpp"

namespace {

struct simulated : trot::architecture<cca::sim::oncilla> {};
static_assert(cca::well_formed<simulated>);
static_assert(cca::well_formed<hil::trot_on_drives>);

}  // namespace

TEST_SUITE("hardware in the loop") {
  TEST_CASE("the controller that trots in the simulator trots on drives") {
    hil::in_memory<> run;
    run.controller.load();
    run.controller.start();
    const auto& stop = run.controller.get<"robot.emergency_stop">();
    for (int k = 0; k < 5000; ++k) {
      REQUIRE(run.step());
      if (k > 20) REQUIRE_MESSAGE(stop.first_cause().rule == cca::hardware::safety_rule::none, k);
    }
    CHECK(stop.mode() == cca::hardware::motion_mode::run);
    CHECK(!run.plant.world.fallen());
    MESSAGE("distance " << run.plant.world.trunk_position()[0] << " m");
    CHECK(run.plant.world.trunk_position()[0] > 2.0);
  }
}
