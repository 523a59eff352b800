// ROS 2 without ROS 2: nodes that publish and subscribe the bytes of its own message types, over Cyclone DDS.
//
//   struct leg : cca::graph<
//       cca::node<"command", cca::ros2::subscriber<"leg_command", cca::ros2::joint_state<leg_angles>>>,
//       cca::node<"limits", cca::limiter<leg_angles>>,
//       cca::node<"robot", Robot>,
//       cca::node<"states", cca::ros2::publisher<"joint_states",
//           cca::ros2::joint_state<leg_angles, leg_velocities>>>, ...
//
// Target cca::dds. The spaces of a message decide its fields; their axes are its names, their frame its
// frame_id. Page: docs/ros2.md.
#pragma once

#include <cca/ros2/messages/float64_multi_array.hpp>
#include <cca/ros2/messages/image.hpp>
#include <cca/ros2/messages/imu.hpp>
#include <cca/ros2/messages/joint_state.hpp>
#include <cca/ros2/messages/joint_trajectory.hpp>
#include <cca/ros2/messages/pose.hpp>
#include <cca/ros2/messages/stamped.hpp>
#include <cca/ros2/messages/twist.hpp>
#include <cca/ros2/publisher.hpp>
#include <cca/ros2/subscriber.hpp>
