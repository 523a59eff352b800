// The picture of the Combination of Skills, as its page shows it.
#include <string_view>

#include <doctest/doctest.h>

#include "../../../examples/combination_of_skills/architecture.hpp"
#include "../../../examples/combination_of_skills/idle_robot.hpp"
#include "../picture.hpp"

namespace {

struct idle : skills::architecture<skills::idle_robot> {};

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0[("robot<br/><i>1000 Hz</i>")]
  n1[("camera<br/><i>1000 Hz</i>")]
  n2["sequencer<br/><i>100 Hz</i>"]
  n3["orders<br/><i>100 Hz</i>"]
  n9["hip_reaching<br/><i>1000 Hz</i>"]
  n10["knee_reaching<br/><i>1000 Hz</i>"]
  n11["cpg<br/><i>stoppable&lt;timed&lt;1&gt;&gt;</i>"]
  n15["goal<br/><i>restless</i>"]
  n16["gait<br/><i>port_triggered</i>"]
  n17["limits<br/><i>1000 Hz</i>"]
  n18["abduction_limits<br/><i>1000 Hz</i>"]
  n19["stiffness_limits<br/><i>1000 Hz</i>"]
  n20["measured<br/><i>1000 Hz</i>"]
  n21["heading<br/><i>stoppable&lt;timed&lt;10&gt;&gt;</i>"]
  n22["steering<br/><i>port_triggered</i>"]
  n23["balance<br/><i>port_triggered</i>"]
  n24["paw<br/><i>1000 Hz</i>"]
  n25["aim<br/><i>stoppable&lt;timed&lt;1&gt;&gt;</i>"]
  n26["ball<br/><i>1000 Hz</i>"]
  n28["steady<br/><i>port_triggered</i>"]
  n29["trunk<br/><i>1000 Hz</i>"]
  subgraph g1["inverse_kinematics"]
    n4["left_front<br/><i>100 Hz</i>"]
    n5["right_front<br/><i>100 Hz</i>"]
    n6["left_hind<br/><i>100 Hz</i>"]
    n7["right_hind<br/><i>100 Hz</i>"]
    n8["by_kind<br/><i>100 Hz</i>"]
  end
  subgraph g2["dmp"]
    n12["module<br/><i>timed&lt;1&gt;</i>"]
    n13["criterion<br/><i>timed&lt;1&gt;</i>"]
    n14["status<br/><i>timed&lt;1&gt;</i>"]
  end
  subgraph g3["reaching"]
    n27["status<br/><i>timed&lt;1&gt;</i>"]
  end
  n17 -- "safe → command<br/>leg_angles, 1000 Hz" --> n0
  n18 -- "safe → abduction<br/>abduction_angles, 1000 Hz" --> n0
  n19 -- "safe → stiffness<br/>hip_stiffnesses, 1000 Hz" --> n0
  n2 -- "step<br/>step_port, 100 Hz" --> n3
  n1 -- "ball<br/>point_in_trunk" --> n3
  n25 -- "aim<br/>point_in_trunk" --> n3
  n24 -- "side<br/>side_port, 1000 Hz" --> n3
  n3 -- "left_front → position<br/>point_in_trunk, 100 Hz" --> n4
  n3 -- "right_front → position<br/>point_in_trunk, 100 Hz" --> n5
  n3 -- "left_hind → position<br/>point_in_trunk, 100 Hz" --> n6
  n3 -- "right_hind → position<br/>point_in_trunk, 100 Hz" --> n7
  n4 -- "angles → left_front<br/>left_front_joints, 100 Hz" --> n8
  n5 -- "angles → right_front<br/>right_front_joints, 100 Hz" --> n8
  n6 -- "angles → left_hind<br/>left_hind_joints, 100 Hz" --> n8
  n7 -- "angles → right_hind<br/>right_hind_joints, 100 Hz" --> n8
  n8 -- "hips → target<br/>hip_angles, 100 Hz" --> n9
  n20 -- "hips → start<br/>hip_angles, 1000 Hz" --> n9
  n8 -- "knees → target<br/>knee_angles, 100 Hz" --> n10
  n20 -- "knees → start<br/>knee_angles, 1000 Hz" --> n10
  n3 -- "amplitude<br/>over&lt;amplitude, stride&gt;, 100 Hz" --> n11
  n11 -- "phase<br/>over&lt;phase, stride&gt;" --> n12
  n11 -- "amplitude<br/>over&lt;amplitude, stride&gt;" --> n12
  n28 -- "angles → reference<br/>leg_angles" --> n12
  n12 -- "command → target<br/>leg_angles" --> n13
  n0 -- "angles → feedback<br/>leg_angles, 1000 Hz" --> n13
  n12 -- "ode<br/>ode_status_port" --> n14
  n12 -- "module<br/>module_status_port" --> n14
  n13 -- "state → criterion<br/>criterion_port" --> n14
  n9 -- "position → hips<br/>hip_angles" --> n15
  n10 -- "position → knees<br/>knee_angles" --> n15
  n12 -- "command → walking<br/>leg_angles" --> n16
  n28 -- "angles → standing<br/>leg_angles" --> n16
  n23 -- "angles → command<br/>leg_angles" --> n17
  n0 -- "angles → measured<br/>leg_angles, 1000 Hz" --> n17
  n28 -- "abducted → command<br/>abduction_angles" --> n18
  n0 -- "abducted → measured<br/>abduction_angles, 1000 Hz" --> n18
  n3 -- "stiffness → command<br/>wanted_stiffness, 100 Hz" --> n19
  n0 -- "angles<br/>leg_angles, 1000 Hz" --> n20
  n0 -- "abducted<br/>abduction_angles, 1000 Hz" --> n20
  n0 -- "orientation<br/>trunk_orientation, 1000 Hz" --> n21
  n1 -- "ball<br/>point_in_trunk" --> n21
  n24 -- "side<br/>side_port, 1000 Hz" --> n21
  n11 -- "amplitude<br/>over&lt;amplitude, stride&gt;" --> n21
  n28 -- "angles → goal<br/>leg_angles" --> n22
  n21 -- "turn<br/>turning" --> n22
  n16 -- "angles → command<br/>leg_angles" --> n22
  n0 -- "angular_velocity<br/>trunk_angular_velocity, 1000 Hz" --> n23
  n3 -- "supports<br/>supports, 100 Hz" --> n23
  n22 -- "angles → command<br/>leg_angles" --> n23
  n1 -- "ball<br/>point_in_trunk" --> n24
  n0 -- "angles<br/>leg_angles, 1000 Hz" --> n24
  n0 -- "abducted<br/>abduction_angles, 1000 Hz" --> n24
  n0 -- "contacts<br/>foot_contacts, 1000 Hz" --> n24
  n1 -- "ball<br/>point_in_trunk" --> n25
  n24 -- "paw<br/>point_in_trunk, 1000 Hz" --> n25
  n1 -- "ball<br/>point_in_trunk" --> n26
  n1 -- "ball → target<br/>point_in_trunk" --> n27
  n24 -- "paw → feedback<br/>point_in_trunk, 1000 Hz" --> n27
  n15 -- "legs<br/>leg_angles" --> n28
  n15 -- "abduction<br/>abduction_angles" --> n28
  n1 -- "ball<br/>point_in_trunk" --> n28
  n24 -- "paw<br/>point_in_trunk, 1000 Hz" --> n28
  n25 -- "aim<br/>point_in_trunk" --> n28
  n24 -- "side<br/>side_port, 1000 Hz" --> n28
  n2 -- "step<br/>step_port, 100 Hz" --> n28
  n0 -- "angular_velocity<br/>trunk_angular_velocity, 1000 Hz" --> n29
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of the Combination of Skills") { test::check_picture<idle>(picture); }
