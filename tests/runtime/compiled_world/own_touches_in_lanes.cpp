// A robot that touches itself, in lanes: each has the bits of a world alone.
#include <doctest/doctest.h>

#include "hugging.hpp"

using namespace compiled_test;

namespace {

void judge(const sim::scene& around, double gravity) {
  constexpr int beats = 1500;
  const hugs_in_lanes found = hugs_beside_alone<2>(around, gravity, beats);
  MESSAGE(found.touches, " beats of a lane with a touch, ", found.apart, " while the other has none, ",
          found.on_boxes, " of boxes");
  CHECK(found.differ == 0);
  CHECK(!found.stands_still);
  CHECK(found.touches > 300);
  CHECK(found.touches < 2 * beats - 100);
  CHECK(found.apart > 50);
  CHECK(found.on_boxes > 50);
}

}  // namespace

TEST_SUITE("compiled world: a robot that touches itself, in lanes") {
  TEST_CASE("each lane has the bits of a world alone, in space") { judge({}, 0); }
  TEST_CASE("each lane has the bits of a world alone, on a floor") {
    sim::scene floor;
    floor.floor = 0;
    judge(floor, 9.81);
  }
}
