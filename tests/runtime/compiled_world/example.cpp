// The example of docs/physics.md.
#include <doctest/doctest.h>

#include <array>

// [arm]
#include <cca/robots/arm/description.hpp>
#include <cca/sim/compiled/compiled_world.hpp>

namespace arm = cca::robots::arm;

// How far the tip of an arm sinks in half a second while its servos hold it.
double sinking() {
  cca::sim::scene room;
  room.floor = 0;
  cca::sim::compiled_world<arm::description> world(room);

  std::array<cca::sim::joint_law, 7> laws;  // what each drive does: here it holds its joint
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const cca::robots::joint_drive& d = arm::description::drives[i];
    laws[i] = {.position = arm::description::start[i], .stiffness = d.stiffness, .damping = d.damping};
  }
  const double before = world.end("arm").where.at.z();
  for (int beat = 0; beat < 500; ++beat) world.advance(laws);
  return before - world.end("arm").where.at.z();
}
// [arm end]

TEST_SUITE("compiled world: example") {
  TEST_CASE("an arm sinks until its servos carry it") {
    CHECK(sinking() > 0.01);
    CHECK(sinking() < 0.03);
  }
}
