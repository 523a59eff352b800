// The picture of the trot on the simulator's page, with the robot as one node.
#include <string_view>

#include <doctest/doctest.h>

#include "../../../examples/trot/architecture.hpp"
#include "../../../examples/trot/idle_robot.hpp"
#include "../picture.hpp"

namespace {

struct idle : trot::architecture<trot::idle_robot> {};

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0["throttle<br/><i>100 Hz</i>"]
  n1["posture<br/><i>100 Hz</i>"]
  n2["cpg<br/><i>1000 Hz</i>"]
  n3["gait<br/><i>1000 Hz</i>"]
  n4["limits<br/><i>1000 Hz</i>"]
  n5[("robot<br/><i>1000 Hz</i>")]
  n5 -- "orientation<br/>trunk_orientation, 1000 Hz" --> n1
  n0 -- "amplitude<br/>wanted_amplitude, 100 Hz" --> n2
  n2 -- "phase<br/>gait_phase, 1000 Hz" --> n3
  n2 -- "amplitude<br/>gait_amplitude, 1000 Hz" --> n3
  n1 -- "turn<br/>turning, 100 Hz" --> n3
  n1 -- "lean<br/>leaning, 100 Hz" --> n3
  n3 -- "angles → command<br/>leg_angles, 1000 Hz" --> n4
  n5 -- "angles → measured<br/>leg_angles, 1000 Hz" --> n4
  n4 -- "safe → command<br/>leg_angles, 1000 Hz" --> n5
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of the trot") { test::check_picture<idle>(picture); }
