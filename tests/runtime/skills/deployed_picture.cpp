// The picture of the deployed Combination of Skills, as its page shows it.
#include <string_view>

#include <doctest/doctest.h>

#include "../../../examples/deployed/architecture.hpp"
#include "../picture.hpp"

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  subgraph e0["<b>simulation</b>"]
    n49["recorder<br/><i>1000 Hz</i>"]
    n0[("robot.simulator<br/><i>1000 Hz</i>")]
  end
  subgraph e1["<b>robot</b>"]
    n20[("camera<br/><i>1000 Hz</i>")]
    n36["limits<br/><i>restless</i>"]
    n37["abduction_limits<br/><i>restless</i>"]
    n38["stiffness_limits<br/><i>1000 Hz</i>"]
    n1[("robot.left_front_abduction<br/><i>1000 Hz</i>")]
    n2[("robot.left_front_hip<br/><i>1000 Hz</i>")]
    n3[("robot.left_front_knee<br/><i>1000 Hz</i>")]
    n4[("robot.right_front_abduction<br/><i>1000 Hz</i>")]
    n5[("robot.right_front_hip<br/><i>1000 Hz</i>")]
    n6[("robot.right_front_knee<br/><i>1000 Hz</i>")]
    n7[("robot.left_hind_abduction<br/><i>1000 Hz</i>")]
    n8[("robot.left_hind_hip<br/><i>1000 Hz</i>")]
    n9[("robot.left_hind_knee<br/><i>1000 Hz</i>")]
    n10[("robot.right_hind_abduction<br/><i>1000 Hz</i>")]
    n11[("robot.right_hind_hip<br/><i>1000 Hz</i>")]
    n12[("robot.right_hind_knee<br/><i>1000 Hz</i>")]
    n13["robot.command<br/><i>1000 Hz</i>"]
    n14["robot.abduction<br/><i>1000 Hz</i>"]
    n15["robot.stiffness<br/><i>1000 Hz</i>"]
    n16["robot.angles<br/><i>moderate</i>"]
    n17["robot.velocities<br/><i>moderate</i>"]
    n18["robot.torques<br/><i>moderate</i>"]
    n19["robot.abducted<br/><i>moderate</i>"]
  end
  subgraph e2["<b>mind</b>"]
    n21["sequencer<br/><i>100 Hz</i>"]
    n22["orders<br/><i>100 Hz</i>"]
    n40["heading<br/><i>stoppable&lt;timed&lt;10&gt;&gt;</i>"]
    subgraph g2["inverse_kinematics"]
      n23["left_front<br/><i>100 Hz</i>"]
      n24["right_front<br/><i>100 Hz</i>"]
      n25["left_hind<br/><i>100 Hz</i>"]
      n26["right_hind<br/><i>100 Hz</i>"]
      n27["by_kind<br/><i>100 Hz</i>"]
    end
  end
  subgraph e3["<b>reflexes</b>"]
    n28["hip_reaching<br/><i>1000 Hz</i>"]
    n29["knee_reaching<br/><i>1000 Hz</i>"]
    n30["cpg<br/><i>stoppable&lt;timed&lt;1&gt;&gt;</i>"]
    n34["goal<br/><i>restless</i>"]
    n35["gait<br/><i>port_triggered</i>"]
    n39["measured<br/><i>moderate</i>"]
    n41["steering<br/><i>port_triggered</i>"]
    n42["balance<br/><i>port_triggered</i>"]
    n43["paw<br/><i>1000 Hz</i>"]
    n44["aim<br/><i>stoppable&lt;timed&lt;1&gt;&gt;</i>"]
    n45["ball<br/><i>1000 Hz</i>"]
    n47["steady<br/><i>port_triggered</i>"]
    n48["trunk<br/><i>1000 Hz</i>"]
    subgraph g3["dmp"]
      n31["module<br/><i>timed&lt;1&gt;</i>"]
      n32["criterion<br/><i>timed&lt;1&gt;</i>"]
      n33["status<br/><i>timed&lt;1&gt;</i>"]
    end
    subgraph g4["reaching"]
      n46["status<br/><i>timed&lt;1&gt;</i>"]
    end
  end
  n1 -. "wanted → left_front_abduction<br/>wanted_joint&lt;as_built, left_front_abduction&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n2 -. "wanted → left_front_hip<br/>wanted_joint&lt;as_built, left_front_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n3 -. "wanted → left_front_knee<br/>wanted_joint&lt;as_built, left_front_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n4 -. "wanted → right_front_abduction<br/>wanted_joint&lt;as_built, right_front_abduction&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n5 -. "wanted → right_front_hip<br/>wanted_joint&lt;as_built, right_front_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n6 -. "wanted → right_front_knee<br/>wanted_joint&lt;as_built, right_front_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n7 -. "wanted → left_hind_abduction<br/>wanted_joint&lt;as_built, left_hind_abduction&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n8 -. "wanted → left_hind_hip<br/>wanted_joint&lt;as_built, left_hind_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n9 -. "wanted → left_hind_knee<br/>wanted_joint&lt;as_built, left_hind_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n10 -. "wanted → right_hind_abduction<br/>wanted_joint&lt;as_built, right_hind_abduction&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n11 -. "wanted → right_hind_hip<br/>wanted_joint&lt;as_built, right_hind_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n12 -. "wanted → right_hind_knee<br/>wanted_joint&lt;as_built, right_hind_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n0
  n21 -. "step<br/>step_port, 100 Hz<br/>memory, delayed 2" .-> n0
  n21 -. "timed_out<br/>step_flag, 100 Hz<br/>memory, delayed 2" .-> n0
  n0 -. "left_front_abduction → measured<br/>measured_joint&lt;as_built, left_front_abduction&gt;, 1000 Hz<br/>memory, delayed 1" .-> n1
  n14 -- "left_front_abduction → abduction<br/>sub_space&lt;abduction_angles, left_front_abduction&gt;" --> n1
  n0 -. "left_front_hip → measured<br/>measured_joint&lt;as_built, left_front_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n2
  n13 -- "left_front_hip → command<br/>sub_space&lt;leg_angles, left_front_hip&gt;" --> n2
  n15 -- "left_front_hip → stiffness<br/>sub_space&lt;hip_stiffnesses, left_front_hip&gt;" --> n2
  n0 -. "left_front_knee → measured<br/>measured_joint&lt;as_built, left_front_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n3
  n13 -- "left_front_knee → command<br/>sub_space&lt;leg_angles, left_front_knee&gt;" --> n3
  n0 -. "right_front_abduction → measured<br/>measured_joint&lt;as_built, right_front_abduction&gt;, 1000 Hz<br/>memory, delayed 1" .-> n4
  n14 -- "right_front_abduction → abduction<br/>sub_space&lt;abduction_angles, right_front_abduction&gt;" --> n4
  n0 -. "right_front_hip → measured<br/>measured_joint&lt;as_built, right_front_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n5
  n13 -- "right_front_hip → command<br/>sub_space&lt;leg_angles, right_front_hip&gt;" --> n5
  n15 -- "right_front_hip → stiffness<br/>sub_space&lt;hip_stiffnesses, right_front_hip&gt;" --> n5
  n0 -. "right_front_knee → measured<br/>measured_joint&lt;as_built, right_front_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n6
  n13 -- "right_front_knee → command<br/>sub_space&lt;leg_angles, right_front_knee&gt;" --> n6
  n0 -. "left_hind_abduction → measured<br/>measured_joint&lt;as_built, left_hind_abduction&gt;, 1000 Hz<br/>memory, delayed 1" .-> n7
  n14 -- "left_hind_abduction → abduction<br/>sub_space&lt;abduction_angles, left_hind_abduction&gt;" --> n7
  n0 -. "left_hind_hip → measured<br/>measured_joint&lt;as_built, left_hind_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n8
  n13 -- "left_hind_hip → command<br/>sub_space&lt;leg_angles, left_hind_hip&gt;" --> n8
  n15 -- "left_hind_hip → stiffness<br/>sub_space&lt;hip_stiffnesses, left_hind_hip&gt;" --> n8
  n0 -. "left_hind_knee → measured<br/>measured_joint&lt;as_built, left_hind_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n9
  n13 -- "left_hind_knee → command<br/>sub_space&lt;leg_angles, left_hind_knee&gt;" --> n9
  n0 -. "right_hind_abduction → measured<br/>measured_joint&lt;as_built, right_hind_abduction&gt;, 1000 Hz<br/>memory, delayed 1" .-> n10
  n14 -- "right_hind_abduction → abduction<br/>sub_space&lt;abduction_angles, right_hind_abduction&gt;" --> n10
  n0 -. "right_hind_hip → measured<br/>measured_joint&lt;as_built, right_hind_hip&gt;, 1000 Hz<br/>memory, delayed 1" .-> n11
  n13 -- "right_hind_hip → command<br/>sub_space&lt;leg_angles, right_hind_hip&gt;" --> n11
  n15 -- "right_hind_hip → stiffness<br/>sub_space&lt;hip_stiffnesses, right_hind_hip&gt;" --> n11
  n0 -. "right_hind_knee → measured<br/>measured_joint&lt;as_built, right_hind_knee&gt;, 1000 Hz<br/>memory, delayed 1" .-> n12
  n13 -- "right_hind_knee → command<br/>sub_space&lt;leg_angles, right_hind_knee&gt;" --> n12
  n36 -- "safe → whole<br/>leg_angles" --> n13
  n37 -- "safe → whole<br/>abduction_angles" --> n14
  n38 -- "safe → whole<br/>hip_stiffnesses, 1000 Hz" --> n15
  n2 -- "angle → left_front_hip<br/>sub_space&lt;angles&lt;as_built&gt;, left_front_hip&gt;" --> n16
  n5 -- "angle → right_front_hip<br/>sub_space&lt;angles&lt;as_built&gt;, right_front_hip&gt;" --> n16
  n8 -- "angle → left_hind_hip<br/>sub_space&lt;angles&lt;as_built&gt;, left_hind_hip&gt;" --> n16
  n11 -- "angle → right_hind_hip<br/>sub_space&lt;angles&lt;as_built&gt;, right_hind_hip&gt;" --> n16
  n3 -- "angle → left_front_knee<br/>sub_space&lt;angles&lt;as_built&gt;, left_front_knee&gt;" --> n16
  n6 -- "angle → right_front_knee<br/>sub_space&lt;angles&lt;as_built&gt;, right_front_knee&gt;" --> n16
  n9 -- "angle → left_hind_knee<br/>sub_space&lt;angles&lt;as_built&gt;, left_hind_knee&gt;" --> n16
  n12 -- "angle → right_hind_knee<br/>sub_space&lt;angles&lt;as_built&gt;, right_hind_knee&gt;" --> n16
  n2 -- "velocity → left_front_hip<br/>sub_space&lt;velocities&lt;as_built&gt;, left_front_hip&gt;" --> n17
  n5 -- "velocity → right_front_hip<br/>sub_space&lt;velocities&lt;as_built&gt;, right_front_hip&gt;" --> n17
  n8 -- "velocity → left_hind_hip<br/>sub_space&lt;velocities&lt;as_built&gt;, left_hind_hip&gt;" --> n17
  n11 -- "velocity → right_hind_hip<br/>sub_space&lt;velocities&lt;as_built&gt;, right_hind_hip&gt;" --> n17
  n3 -- "velocity → left_front_knee<br/>sub_space&lt;velocities&lt;as_built&gt;, left_front_knee&gt;" --> n17
  n6 -- "velocity → right_front_knee<br/>sub_space&lt;velocities&lt;as_built&gt;, right_front_knee&gt;" --> n17
  n9 -- "velocity → left_hind_knee<br/>sub_space&lt;velocities&lt;as_built&gt;, left_hind_knee&gt;" --> n17
  n12 -- "velocity → right_hind_knee<br/>sub_space&lt;velocities&lt;as_built&gt;, right_hind_knee&gt;" --> n17
  n2 -- "torque → left_front_hip<br/>sub_space&lt;torques&lt;as_built&gt;, left_front_hip&gt;" --> n18
  n5 -- "torque → right_front_hip<br/>sub_space&lt;torques&lt;as_built&gt;, right_front_hip&gt;" --> n18
  n8 -- "torque → left_hind_hip<br/>sub_space&lt;torques&lt;as_built&gt;, left_hind_hip&gt;" --> n18
  n11 -- "torque → right_hind_hip<br/>sub_space&lt;torques&lt;as_built&gt;, right_hind_hip&gt;" --> n18
  n3 -- "torque → left_front_knee<br/>sub_space&lt;torques&lt;as_built&gt;, left_front_knee&gt;" --> n18
  n6 -- "torque → right_front_knee<br/>sub_space&lt;torques&lt;as_built&gt;, right_front_knee&gt;" --> n18
  n9 -- "torque → left_hind_knee<br/>sub_space&lt;torques&lt;as_built&gt;, left_hind_knee&gt;" --> n18
  n12 -- "torque → right_hind_knee<br/>sub_space&lt;torques&lt;as_built&gt;, right_hind_knee&gt;" --> n18
  n1 -- "angle → left_front_abduction<br/>sub_space&lt;angles&lt;as_built&gt;, left_front_abduction&gt;" --> n19
  n4 -- "angle → right_front_abduction<br/>sub_space&lt;angles&lt;as_built&gt;, right_front_abduction&gt;" --> n19
  n7 -- "angle → left_hind_abduction<br/>sub_space&lt;angles&lt;as_built&gt;, left_hind_abduction&gt;" --> n19
  n10 -- "angle → right_hind_abduction<br/>sub_space&lt;angles&lt;as_built&gt;, right_hind_abduction&gt;" --> n19
  n0 -. "ball → picture<br/>point_in_trunk<br/>memory, delayed 1" .-> n20
  n21 -- "step<br/>step_port, 100 Hz" --> n22
  n20 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n22
  n44 -. "aim<br/>point_in_trunk<br/>memory, delayed 1" .-> n22
  n43 -. "side<br/>side_port, 1000 Hz<br/>memory, delayed 1" .-> n22
  n22 -- "left_front → position<br/>point_in_trunk, 100 Hz" --> n23
  n22 -- "right_front → position<br/>point_in_trunk, 100 Hz" --> n24
  n22 -- "left_hind → position<br/>point_in_trunk, 100 Hz" --> n25
  n22 -- "right_hind → position<br/>point_in_trunk, 100 Hz" --> n26
  n23 -- "angles → left_front<br/>left_front_joints, 100 Hz" --> n27
  n24 -- "angles → right_front<br/>right_front_joints, 100 Hz" --> n27
  n25 -- "angles → left_hind<br/>left_hind_joints, 100 Hz" --> n27
  n26 -- "angles → right_hind<br/>right_hind_joints, 100 Hz" --> n27
  n27 -. "hips → target<br/>hip_angles, 100 Hz<br/>memory, delayed 2" .-> n28
  n39 -- "hips → start<br/>hip_angles" --> n28
  n27 -. "knees → target<br/>knee_angles, 100 Hz<br/>memory, delayed 2" .-> n29
  n39 -- "knees → start<br/>knee_angles" --> n29
  n22 -. "amplitude<br/>over&lt;amplitude, stride&gt;, 100 Hz<br/>memory, delayed 2" .-> n30
  n30 -- "phase<br/>over&lt;phase, stride&gt;" --> n31
  n30 -- "amplitude<br/>over&lt;amplitude, stride&gt;" --> n31
  n47 -- "angles → reference<br/>leg_angles" --> n31
  n31 -- "command → target<br/>leg_angles" --> n32
  n16 -. "whole → feedback<br/>leg_angles<br/>memory, delayed 1" .-> n32
  n31 -- "ode<br/>ode_status_port" --> n33
  n31 -- "module<br/>module_status_port" --> n33
  n32 -- "state → criterion<br/>criterion_port" --> n33
  n28 -- "position → hips<br/>hip_angles" --> n34
  n29 -- "position → knees<br/>knee_angles" --> n34
  n31 -- "command → walking<br/>leg_angles" --> n35
  n47 -- "angles → standing<br/>leg_angles" --> n35
  n42 -. "angles → command<br/>leg_angles<br/>memory, delayed 1" .-> n36
  n16 -- "whole → measured<br/>leg_angles" --> n36
  n47 -. "abducted → command<br/>abduction_angles<br/>memory, delayed 1" .-> n37
  n19 -- "whole → measured<br/>abduction_angles" --> n37
  n22 -. "stiffness → command<br/>wanted_stiffness, 100 Hz<br/>memory, delayed 2" .-> n38
  n16 -. "whole → angles<br/>leg_angles<br/>memory, delayed 1" .-> n39
  n19 -. "whole → abducted<br/>abduction_angles<br/>memory, delayed 1" .-> n39
  n0 -. "orientation<br/>sensed&lt;as_built, orientation_sensor&lt;fixed_string&lt;12&gt;{&quot;orientation&quot;}, world_frame&gt;&gt;, 1000 Hz<br/>memory, delayed 2" .-> n40
  n20 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n40
  n43 -. "side<br/>side_port, 1000 Hz<br/>memory, delayed 1" .-> n40
  n30 -. "amplitude<br/>over&lt;amplitude, stride&gt;<br/>memory, delayed 1" .-> n40
  n47 -- "angles → goal<br/>leg_angles" --> n41
  n40 -. "turn<br/>turning<br/>memory, delayed 2" .-> n41
  n35 -- "angles → command<br/>leg_angles" --> n41
  n0 -. "angular_velocity<br/>sensed&lt;as_built, gyroscope&lt;fixed_string&lt;17&gt;{&quot;angular_velocity&quot;}&gt;&gt;, 1000 Hz<br/>memory, delayed 2" .-> n42
  n22 -. "supports<br/>supports, 100 Hz<br/>memory, delayed 2" .-> n42
  n41 -- "angles → command<br/>leg_angles" --> n42
  n20 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n43
  n16 -. "whole → angles<br/>leg_angles<br/>memory, delayed 1" .-> n43
  n19 -. "whole → abducted<br/>abduction_angles<br/>memory, delayed 1" .-> n43
  n0 -. "contacts<br/>sensed&lt;as_built, foot_contacts&lt;fixed_string&lt;9&gt;{&quot;contacts&quot;}, axes&lt;left_front_foot, right_front_foot, left_hind_foot, right_hind_foot&gt;, fixed_string&lt;15&gt;{&quot;left_front_leg&quot;}, fixed_string&lt;16&gt;{&quot;right_front_leg&quot;}, fixed_string&lt;14&gt;{&quot;left_hind_leg&quot;}, fixed_string&lt;15&gt;{&quot;right_hind_leg&quot;}&gt;&gt;, 1000 Hz<br/>memory, delayed 2" .-> n43
  n20 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n44
  n43 -- "paw<br/>point_in_trunk, 1000 Hz" --> n44
  n20 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n45
  n20 -. "ball → target<br/>point_in_trunk<br/>memory, delayed 1" .-> n46
  n43 -- "paw → feedback<br/>point_in_trunk, 1000 Hz" --> n46
  n34 -- "legs<br/>leg_angles" --> n47
  n34 -- "abduction<br/>abduction_angles" --> n47
  n20 -. "ball<br/>point_in_trunk<br/>memory, delayed 1" .-> n47
  n43 -- "paw<br/>point_in_trunk, 1000 Hz" --> n47
  n44 -- "aim<br/>point_in_trunk" --> n47
  n43 -- "side<br/>side_port, 1000 Hz" --> n47
  n21 -. "step<br/>step_port, 100 Hz<br/>memory, delayed 2" .-> n47
  n0 -. "angular_velocity<br/>sensed&lt;as_built, gyroscope&lt;fixed_string&lt;17&gt;{&quot;angular_velocity&quot;}&gt;&gt;, 1000 Hz<br/>memory, delayed 2" .-> n48
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of the deployed skills") { test::check_picture<deployed::split>(picture); }
