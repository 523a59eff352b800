// EXPECT wrench_elsewhere: space\.mismatch: load_at_foot \(wrench<foot, trunk> over x, y, z\) does not fit into cca::ros2::wrench_stamped, which holds a space of cca::wrench<Frame, Frame>
// EXPECT no_stamped_twist: space\.mismatch: leg_angles \(joint_angles over hip, knee\) does not fit into cca::ros2::twist_stamped, which holds a space of cca::twist<At, In>
// EXPECT no_twist: space\.mismatch: leg_angles \(joint_angles over hip, knee\) does not fit into cca::ros2::twist, which holds a space of cca::twist<At, In>
// EXPECT no_pose: space\.mismatch: leg_angles \(joint_angles over hip, knee\) does not fit into cca::ros2::pose_stamped, which holds a space of cca::pose<Frame>
// EXPECT no_transform: space\.mismatch: leg_angles \(joint_angles over hip, knee\) does not fit into cca::ros2::transform_stamped, which holds
// EXPECT no_tree: space\.mismatch: leg_angles \(joint_angles over hip, knee\) does not fit into cca::ros2::tf, which holds
// EXPECT no_joints: space\.mismatch: hip_number \(number over hip\) does not fit into cca::ros2::joint_state, which holds joint_angles \(position\), joint_velocities \(velocity\) and joint_torques \(effort\)
// EXPECT position_twice: space\.mismatch: leg_angles \(joint_angles over hip, knee\) and other_angles \(joint_angles over hip, knee at 100 Hz\) are both the `position` of a cca::ros2::joint_state, which has it once
// EXPECT other_joints: space\.mismatch: a cca::ros2::joint_state of leg_angles \(joint_angles over hip, knee\) and hip_torque \(joint_torques over hip\) has one list of joints: give its spaces the same axes
// EXPECT no_array: space\.mismatch: leg_angles \(joint_angles over hip, knee\) does not fit into cca::ros2::joint_trajectory, which holds arrays with an element for each point
// EXPECT no_array_of_joints: space\.mismatch: way_of_numbers \(3 of leg_numbers \(number over hip, knee\)\) does not fit into cca::ros2::joint_trajectory, which holds arrays with
// EXPECT positions_twice: space\.mismatch: way \(3 of leg_angles \(joint_angles over hip, knee\)\) and way \(3 of leg_angles \(joint_angles over hip, knee\)\) are both the `positions` of a cca::ros2::joint_trajectory, which has it once
// EXPECT other_points: space\.mismatch: a cca::ros2::joint_trajectory of way \(3 of leg_angles \(joint_angles over hip, knee\)\) and short_way_velocities \(2 of leg_velocities \(joint_velocities over hip, knee\)\) has one list of joints: give its spaces the same axes and as many elements
// EXPECT no_field_of_imu: space\.mismatch: leg_angles \(joint_angles over hip, knee\) does not fit into cca::ros2::imu, which holds spaces over x, y, z
// EXPECT other_unit: space\.mismatch: load_at_foot \(wrench<foot, trunk> over x, y, z\) does not fit into cca::ros2::imu, which holds spaces over x, y, z
// EXPECT orientation_twice: space\.mismatch: attitude \(orientation<world> over x, y, z\) and other_attitude \(orientation<trunk> over x, y, z\) are both the `orientation` of a cca::ros2::imu
// EXPECT unknown_encoding: cca::ros2::image: the encoding `yuv` is unknown: take mono8, 8UC1, rgb8, bgr8, rgba8, bgra8, mono16, 16UC1 or 32FC1
// EXPECT other_pixels: space\.mismatch: picture \(colours over lens\) has 24 numbers, and a cca::ros2::image of 4 x 2 pixels with 1 channel each \(mono8\) has 8: give the space as many
// EXPECT no_topic: cca::ros2: `left leg` is no name of a topic in ROS 2
// EXPECT kept_command: cca::ros2::command_publisher: `transient_local` keeps the last command on the topic `leg/command`, and a robot that comes later would obey an old one
// EXPECT kept_samples: cca::dds::command_publisher: `transient_local` keeps the last command of leg_angles \(joint_angles over hip, knee\), and a robot that comes later would obey an old one
// EXPECT kept_samples_on_topic: cca::dds::command_publisher: `transient_local` keeps the last command of leg_angles \(joint_angles over hip, knee\) on the topic `leg/command`, and
// EXPECT no_space: cca::idl: `hip` is no space: give it a struct derived from cca::space<...>
// LINES: 25
// What the messages and publishers of ROS 2 and DDS take, and what they say of a space, a topic or an
// encoding that they can't use.
#include <cca/cca.hpp>
#include <cca/dds/idl.hpp>
#include <cca/dds/publisher.hpp>
#include <cca/ros2.hpp>
#include <cca/space/array.hpp>
#include <cca/space/record.hpp>

#include "late.hpp"

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::velocity{-9, 9}, cca::torque{-5, 5}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 0}, cca::velocity{-9, 9}, cca::torque{-5, 5}};
};
struct lens : cca::dimension<"lens"> {};
using leg = cca::axes<hip, knee>;
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct world {};
struct trunk {};
struct foot {};

struct leg_angles : cca::space<cca::joint_angles, leg> {};
struct other_angles : cca::space<cca::joint_angles, leg, cca::rate<100>> {};
struct leg_velocities : cca::space<cca::joint_velocities, leg> {};
struct leg_numbers : cca::space<cca::number, leg> {};
struct hip_number : cca::space<cca::number, cca::axes<hip>> {};
struct hip_torque : cca::space<cca::joint_torques, cca::axes<hip>> {};
struct way : cca::array_of<leg_angles, 3> {};
struct way_of_numbers : cca::array_of<leg_numbers, 3> {};
struct short_way_velocities : cca::array_of<leg_velocities, 2> {};
struct load_at_foot : cca::space<cca::wrench<foot, trunk>, xyz> {};
struct attitude : cca::space<cca::orientation<world>, xyz> {};
struct other_attitude : cca::space<cca::orientation<trunk>, xyz> {};
struct colours : cca::record<4 * 2 * 3> {};
struct picture : cca::space<colours, cca::axes<lens>> {};

namespace broken {

namespace ros2 = cca::ros2;

// Of a node that sends or receives the message, as in a graph.
template <class Message>
using sent = ros2::publisher<"topic", Message>;
template <class Message>
using received = ros2::subscriber<"topic", Message>;

template <class T>
using wrench_elsewhere = sent<ros2::wrench_stamped<late<load_at_foot, T>>>;
template <class T>
using no_stamped_twist = sent<ros2::twist_stamped<late<leg_angles, T>>>;
template <class T>
using no_twist = received<ros2::twist<late<leg_angles, T>>>;
template <class T>
using no_pose = sent<ros2::pose_stamped<late<leg_angles, T>>>;
template <class T>
using no_transform = sent<ros2::transform_stamped<late<leg_angles, T>, "trunk">>;
template <class T>
using no_tree = sent<ros2::tf<late<leg_angles, T>, "trunk">>;
// It has other axes, too: one sentence is enough.
template <class T>
using no_joints = sent<ros2::joint_state<late<leg_angles, T>, hip_number>>;
template <class T>
using position_twice = received<ros2::joint_state<late<leg_angles, T>, other_angles>>;
template <class T>
using other_joints = sent<ros2::joint_state<late<leg_angles, T>, hip_torque>>;
template <class T>
using no_array = sent<ros2::joint_trajectory<late<leg_angles, T>>>;
template <class T>
using no_array_of_joints = sent<ros2::joint_trajectory<way, late<way_of_numbers, T>>>;
template <class T>
using positions_twice = sent<ros2::joint_trajectory<way, late<way, T>>>;
template <class T>
using other_points = received<ros2::joint_trajectory<way, late<short_way_velocities, T>>>;
template <class T>
using no_field_of_imu = sent<ros2::imu<attitude, late<leg_angles, T>>>;
template <class T>
using other_unit = sent<ros2::imu<late<load_at_foot, T>>>;
template <class T>
using orientation_twice = sent<ros2::imu<attitude, late<other_attitude, T>>>;
template <class T>
using unknown_encoding = sent<ros2::image<late<picture, T>, 4, 2, "yuv">>;
template <class T>
using other_pixels = sent<ros2::image<late<picture, T>, 4, 2, "mono8">>;
template <class T>
using kept_command =
    ros2::command_publisher<"leg/command", ros2::joint_state<late<leg_angles, T>>, ros2::transient_local>;
template <class T>
using kept_samples = cca::dds::command_publisher<late<leg_angles, T>, "", cca::dds::transient_local>;
template <class T>
using kept_samples_on_topic =
    cca::dds::command_publisher<late<leg_angles, T>, "leg/command", cca::dds::transient_local>;

// What a node does when it is loaded, and a text that a program asks for.
template <class Space>
struct on_two_words : ros2::publisher<"left leg", ros2::joint_state<Space>> {
  static constexpr auto loads = &on_two_words::on_load;
};
template <class T>
using no_topic = on_two_words<late<leg_angles, T>>;
template <class Space>
struct in_a_file {
  static constexpr auto written = &cca::idl<leg_angles, Space>;
};
template <class T>
using no_space = in_a_file<late<hip, T>>;
template <class T>
using none = late<leg_angles, T>;

}  // namespace broken

#ifndef CCA_REJECT
constexpr auto size = sizeof(broken::none<world>);
#else
constexpr auto size = sizeof(broken::CCA_REJECT<world>);
#endif
