// The trot on drives in two environments: the bits of its single loop, and it trots as well as without the
// delays.
#include <cstdint>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "../../../examples/hardware_in_the_loop/two_environments.hpp"

namespace {

using in_one_loop = hil::in_memory<hil::two_environments<hil::memory_end>>;

// The motion of the whole robot in every tenth beat.
template <class Run>
std::vector<std::uint64_t> worlds_of(Run& run, std::int64_t beats) {
  std::vector<std::uint64_t> worlds;
  run.controller.load();
  run.controller.start();
  run.run(beats, [&](const auto& c) {
    if (c.beat_index() % 10 == 0) worlds.push_back(run.plant.world.hash());
  });
  return worlds;
}

}  // namespace

TEST_SUITE("the trot on drives in two environments") {
  TEST_CASE("it has the bits of its single loop, and trots") {
    hil::two_in_memory two;
    in_one_loop one;
    const auto worlds = worlds_of(two, 5000);
    CHECK_EQ(worlds.size(), 500u);
    CHECK(worlds == worlds_of(one, 5000));
    CHECK_EQ(std::string(two.controller.fault().reason()), "");
    CHECK(two.controller.get<"robot.emergency_stop">().mode() == cca::hardware::motion_mode::run);
    CHECK(!two.plant.world.fallen());
    MESSAGE("distance " << two.plant.world.trunk_position()[0] << " m");
    CHECK(two.plant.world.trunk_position()[0] > 2.0);
    CHECK(two.shut_down().complete());
    CHECK(one.shut_down().complete());
  }
}
