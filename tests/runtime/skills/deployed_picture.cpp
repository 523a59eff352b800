// The picture of the deployed Combination of Skills, as its page shows it.
#include <string_view>

#include <doctest/doctest.h>

#include "../../../examples/deployed/architecture.hpp"
#include "../picture.hpp"

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  subgraph e0["<b>simulation</b>"]
    n43["recorder<br/><i>1000 Hz</i>"]
    n0[("robot.simulator<br/><i>1000 Hz</i>")]
  end
  subgraph e1["<b>robot</b>"]
    n14[("camera<br/><i>1000 Hz</i>")]
    n30["limits<br/><i>restless</i>"]
    n31["abduction_limits<br/><i>restless</i>"]
    n32["stiffness_limits<br/><i>1000 Hz</i>"]
    n1[("robot.left_front_hip<br/><i>1000 Hz</i>")]
    n2[("robot.right_front_hip<br/><i>1000 Hz</i>")]
    n3[("robot.left_hind_hip<br/><i>1000 Hz</i>")]
    n4[("robot.right_hind_hip<br/><i>1000 Hz</i>")]
    n5[("robot.left_front_knee<br/><i>1000 Hz</i>")]
    n6[("robot.right_front_knee<br/><i>1000 Hz</i>")]
    n7[("robot.left_hind_knee<br/><i>1000 Hz</i>")]
    n8[("robot.right_hind_knee<br/><i>1000 Hz</i>")]
    n9[("robot.trunk<br/><i>1000 Hz</i>")]
    n10["robot.splitter<br/><i>restless</i>"]
    n11["robot.angles<br/><i>moderate</i>"]
    n12["robot.velocities<br/><i>moderate</i>"]
    n13["robot.torques<br/><i>moderate</i>"]
  end
  subgraph e2["<b>mind</b>"]
    n15["sequencer<br/><i>100 Hz</i>"]
    n16["orders<br/><i>100 Hz</i>"]
    n34["heading<br/><i>stoppable&lt;timed&lt;10&gt;&gt;</i>"]
    subgraph g2["inverse_kinematics"]
      n17["left_front<br/><i>100 Hz</i>"]
      n18["right_front<br/><i>100 Hz</i>"]
      n19["left_hind<br/><i>100 Hz</i>"]
      n20["right_hind<br/><i>100 Hz</i>"]
      n21["by_kind<br/><i>100 Hz</i>"]
    end
  end
  subgraph e3["<b>reflexes</b>"]
    n22["hip_reaching<br/><i>1000 Hz</i>"]
    n23["knee_reaching<br/><i>1000 Hz</i>"]
    n24["cpg<br/><i>stoppable&lt;timed&lt;1&gt;&gt;</i>"]
    n28["goal<br/><i>restless</i>"]
    n29["gait<br/><i>port_triggered</i>"]
    n33["measured<br/><i>moderate</i>"]
    n35["steering<br/><i>port_triggered</i>"]
    n36["balance<br/><i>port_triggered</i>"]
    n37["paw<br/><i>1000 Hz</i>"]
    n38["aim<br/><i>stoppable&lt;timed&lt;1&gt;&gt;</i>"]
    n39["ball<br/><i>1000 Hz</i>"]
    n41["steady<br/><i>port_triggered</i>"]
    n42["trunk<br/><i>1000 Hz</i>"]
    subgraph g3["dmp"]
      n25["module<br/><i>timed&lt;1&gt;</i>"]
      n26["criterion<br/><i>timed&lt;1&gt;</i>"]
      n27["status<br/><i>timed&lt;1&gt;</i>"]
    end
    subgraph g4["reaching"]
      n40["status<br/><i>timed&lt;1&gt;</i>"]
    end
  end
  n1 -. "target → left_front_hip<br/>joint_angle&lt;left_front_hip&gt;<br/>memory, delayed 1" .-> n0
  n2 -. "target → right_front_hip<br/>joint_angle&lt;right_front_hip&gt;<br/>memory, delayed 1" .-> n0
  n3 -. "target → left_hind_hip<br/>joint_angle&lt;left_hind_hip&gt;<br/>memory, delayed 1" .-> n0
  n4 -. "target → right_hind_hip<br/>joint_angle&lt;right_hind_hip&gt;<br/>memory, delayed 1" .-> n0
  n5 -. "target → left_front_knee<br/>joint_angle&lt;left_front_knee&gt;<br/>memory, delayed 1" .-> n0
  n6 -. "target → right_front_knee<br/>joint_angle&lt;right_front_knee&gt;<br/>memory, delayed 1" .-> n0
  n7 -. "target → left_hind_knee<br/>joint_angle&lt;left_hind_knee&gt;<br/>memory, delayed 1" .-> n0
  n8 -. "target → right_hind_knee<br/>joint_angle&lt;right_hind_knee&gt;<br/>memory, delayed 1" .-> n0
  n31 -. "safe → abduction<br/>abduction_angles<br/>memory, delayed 1" .-> n0
  n32 -. "safe → stiffness<br/>hip_stiffnesses, 1000 Hz<br/>memory, delayed 1" .-> n0
  n15 -. "step<br/>step_port, 100 Hz<br/>memory, delayed 2" .-> n0
  n15 -. "timed_out<br/>step_flag, 100 Hz<br/>memory, delayed 2" .-> n0
  n0 -. "left_front_hip → measured<br/>measured_joint&lt;left_front_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n1
  n10 -- "left_front_hip → command<br/>sub_space&lt;leg_angles, left_front_hip&gt;" --> n1
  n0 -. "right_front_hip → measured<br/>measured_joint&lt;right_front_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n2
  n10 -- "right_front_hip → command<br/>sub_space&lt;leg_angles, right_front_hip&gt;" --> n2
  n0 -. "left_hind_hip → measured<br/>measured_joint&lt;left_hind_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n3
  n10 -- "left_hind_hip → command<br/>sub_space&lt;leg_angles, left_hind_hip&gt;" --> n3
  n0 -. "right_hind_hip → measured<br/>measured_joint&lt;right_hind_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n4
  n10 -- "right_hind_hip → command<br/>sub_space&lt;leg_angles, right_hind_hip&gt;" --> n4
  n0 -. "left_front_knee → measured<br/>measured_joint&lt;left_front_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n5
  n10 -- "left_front_knee → command<br/>sub_space&lt;leg_angles, left_front_knee&gt;" --> n5
  n0 -. "right_front_knee → measured<br/>measured_joint&lt;right_front_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n6
  n10 -- "right_front_knee → command<br/>sub_space&lt;leg_angles, right_front_knee&gt;" --> n6
  n0 -. "left_hind_knee → measured<br/>measured_joint&lt;left_hind_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n7
  n10 -- "left_hind_knee → command<br/>sub_space&lt;leg_angles, left_hind_knee&gt;" --> n7
  n0 -. "right_hind_knee → measured<br/>measured_joint&lt;right_hind_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n8
  n10 -- "right_hind_knee → command<br/>sub_space&lt;leg_angles, right_hind_knee&gt;" --> n8
  n0 -. "trunk → measured<br/>measured_trunk, 1000 Hz<br/>memory, delayed 1" .-> n9
  n30 -- "safe → command<br/>leg_angles" --> n10
  n1 -- "angle → left_front_hip<br/>joint_angle&lt;left_front_hip&gt;" --> n11
  n2 -- "angle → right_front_hip<br/>joint_angle&lt;right_front_hip&gt;" --> n11
  n3 -- "angle → left_hind_hip<br/>joint_angle&lt;left_hind_hip&gt;" --> n11
  n4 -- "angle → right_hind_hip<br/>joint_angle&lt;right_hind_hip&gt;" --> n11
  n5 -- "angle → left_front_knee<br/>joint_angle&lt;left_front_knee&gt;" --> n11
  n6 -- "angle → right_front_knee<br/>joint_angle&lt;right_front_knee&gt;" --> n11
  n7 -- "angle → left_hind_knee<br/>joint_angle&lt;left_hind_knee&gt;" --> n11
  n8 -- "angle → right_hind_knee<br/>joint_angle&lt;right_hind_knee&gt;" --> n11
  n1 -- "velocity → left_front_hip<br/>joint_velocity&lt;left_front_hip&gt;" --> n12
  n2 -- "velocity → right_front_hip<br/>joint_velocity&lt;right_front_hip&gt;" --> n12
  n3 -- "velocity → left_hind_hip<br/>joint_velocity&lt;left_hind_hip&gt;" --> n12
  n4 -- "velocity → right_hind_hip<br/>joint_velocity&lt;right_hind_hip&gt;" --> n12
  n5 -- "velocity → left_front_knee<br/>joint_velocity&lt;left_front_knee&gt;" --> n12
  n6 -- "velocity → right_front_knee<br/>joint_velocity&lt;right_front_knee&gt;" --> n12
  n7 -- "velocity → left_hind_knee<br/>joint_velocity&lt;left_hind_knee&gt;" --> n12
  n8 -- "velocity → right_hind_knee<br/>joint_velocity&lt;right_hind_knee&gt;" --> n12
  n1 -- "torque → left_front_hip<br/>joint_torque&lt;left_front_hip&gt;" --> n13
  n2 -- "torque → right_front_hip<br/>joint_torque&lt;right_front_hip&gt;" --> n13
  n3 -- "torque → left_hind_hip<br/>joint_torque&lt;left_hind_hip&gt;" --> n13
  n4 -- "torque → right_hind_hip<br/>joint_torque&lt;right_hind_hip&gt;" --> n13
  n5 -- "torque → left_front_knee<br/>joint_torque&lt;left_front_knee&gt;" --> n13
  n6 -- "torque → right_front_knee<br/>joint_torque&lt;right_front_knee&gt;" --> n13
  n7 -- "torque → left_hind_knee<br/>joint_torque&lt;left_hind_knee&gt;" --> n13
  n8 -- "torque → right_hind_knee<br/>joint_torque&lt;right_hind_knee&gt;" --> n13
  n0 -. "ball → picture<br/>point_in_trunk<br/>memory, delayed 1" .-> n14
  n15 -- "step<br/>step_port, 100 Hz" --> n16
  n14 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n16
  n38 -. "aim<br/>point_in_trunk<br/>memory, delayed 1" .-> n16
  n37 -. "side<br/>side_port, 1000 Hz<br/>memory, delayed 1" .-> n16
  n16 -- "left_front → position<br/>point_in_trunk, 100 Hz" --> n17
  n16 -- "right_front → position<br/>point_in_trunk, 100 Hz" --> n18
  n16 -- "left_hind → position<br/>point_in_trunk, 100 Hz" --> n19
  n16 -- "right_hind → position<br/>point_in_trunk, 100 Hz" --> n20
  n17 -- "angles → left_front<br/>left_front_joints, 100 Hz" --> n21
  n18 -- "angles → right_front<br/>right_front_joints, 100 Hz" --> n21
  n19 -- "angles → left_hind<br/>left_hind_joints, 100 Hz" --> n21
  n20 -- "angles → right_hind<br/>right_hind_joints, 100 Hz" --> n21
  n21 -. "hips → target<br/>hip_angles, 100 Hz<br/>memory, delayed 2" .-> n22
  n33 -- "hips → start<br/>hip_angles" --> n22
  n21 -. "knees → target<br/>knee_angles, 100 Hz<br/>memory, delayed 2" .-> n23
  n33 -- "knees → start<br/>knee_angles" --> n23
  n16 -. "amplitude<br/>over&lt;amplitude, stride&gt;, 100 Hz<br/>memory, delayed 2" .-> n24
  n24 -- "phase<br/>over&lt;phase, stride&gt;" --> n25
  n24 -- "amplitude<br/>over&lt;amplitude, stride&gt;" --> n25
  n41 -- "angles → reference<br/>leg_angles" --> n25
  n25 -- "command → target<br/>leg_angles" --> n26
  n11 -. "whole → feedback<br/>leg_angles<br/>memory, delayed 1" .-> n26
  n25 -- "ode<br/>ode_status_port" --> n27
  n25 -- "module<br/>module_status_port" --> n27
  n26 -- "state → criterion<br/>criterion_port" --> n27
  n22 -- "position → hips<br/>hip_angles" --> n28
  n23 -- "position → knees<br/>knee_angles" --> n28
  n25 -- "command → walking<br/>leg_angles" --> n29
  n41 -- "angles → standing<br/>leg_angles" --> n29
  n36 -. "angles → command<br/>leg_angles<br/>memory, delayed 1" .-> n30
  n11 -- "whole → measured<br/>leg_angles" --> n30
  n41 -. "abducted → command<br/>abduction_angles<br/>memory, delayed 1" .-> n31
  n9 -- "abducted → measured<br/>abduction_angles" --> n31
  n16 -. "stiffness → command<br/>wanted_stiffness, 100 Hz<br/>memory, delayed 2" .-> n32
  n11 -. "whole → angles<br/>leg_angles<br/>memory, delayed 1" .-> n33
  n9 -. "abducted<br/>abduction_angles<br/>memory, delayed 1" .-> n33
  n9 -. "orientation<br/>trunk_orientation<br/>memory, delayed 1" .-> n34
  n14 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n34
  n37 -. "side<br/>side_port, 1000 Hz<br/>memory, delayed 1" .-> n34
  n24 -. "amplitude<br/>over&lt;amplitude, stride&gt;<br/>memory, delayed 1" .-> n34
  n41 -- "angles → goal<br/>leg_angles" --> n35
  n34 -. "turn<br/>turning<br/>memory, delayed 2" .-> n35
  n29 -- "angles → command<br/>leg_angles" --> n35
  n9 -. "angular_velocity<br/>trunk_angular_velocity<br/>memory, delayed 1" .-> n36
  n16 -. "supports<br/>supports, 100 Hz<br/>memory, delayed 2" .-> n36
  n35 -- "angles → command<br/>leg_angles" --> n36
  n14 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n37
  n11 -. "whole → angles<br/>leg_angles<br/>memory, delayed 1" .-> n37
  n9 -. "abducted<br/>abduction_angles<br/>memory, delayed 1" .-> n37
  n9 -. "contacts<br/>foot_contacts<br/>memory, delayed 1" .-> n37
  n14 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n38
  n37 -- "paw<br/>point_in_trunk, 1000 Hz" --> n38
  n14 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n39
  n14 -. "ball → target<br/>point_in_trunk<br/>memory, delayed 1" .-> n40
  n37 -- "paw → feedback<br/>point_in_trunk, 1000 Hz" --> n40
  n28 -- "legs<br/>leg_angles" --> n41
  n28 -- "abduction<br/>abduction_angles" --> n41
  n14 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n41
  n37 -- "paw<br/>point_in_trunk, 1000 Hz" --> n41
  n38 -- "aim<br/>point_in_trunk" --> n41
  n37 -- "side<br/>side_port, 1000 Hz" --> n41
  n15 -. "step<br/>step_port, 100 Hz<br/>memory, delayed 2" .-> n41
  n9 -. "angular_velocity<br/>trunk_angular_velocity<br/>memory, delayed 1" .-> n42
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of the deployed skills") { test::check_picture<deployed::split>(picture); }
