// Spaces for each message, with the nodes that publish and subscribe them.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <tuple>

#include <cca/cca.hpp>
#include <cca/ros2.hpp>
#include <cca/space/array.hpp>
#include <cca/space/record.hpp>

namespace ros2_test {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::velocity{-9, 9}, cca::torque{-5, 5}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 0}, cca::velocity{-9, 9}, cca::torque{-5, 5}};
};
using leg = cca::axes<hip, knee>;
struct leg_angles : cca::space<cca::joint_angles, leg> {};
struct leg_velocities : cca::space<cca::joint_velocities, leg> {};
struct leg_torques : cca::space<cca::joint_torques, leg> {};

using trunk = cca::frame<"trunk">;
using world = cca::frame<"world">;
using xyz = cca::axes<cca::x, cca::y, cca::z>;

struct acceleration_along {
  double lower, upper;
  static constexpr std::string_view unit = "m/s^2";
  static constexpr auto on_nan = cca::nan_policy::zero;
};
template <class Frame>
struct angular_velocity : cca::detail::linear_domain {
  using quantity = cca::velocity;
  template <class Self>
  struct methods : cca::detail::additive<Self> {};
};
template <class Frame>
struct linear_acceleration : cca::detail::linear_domain {
  using quantity = acceleration_along;
  template <class Self>
  struct methods : cca::detail::additive<Self> {};
};
struct attitude : cca::space<cca::orientation<world>, xyz> {};
struct turning : cca::space<angular_velocity<trunk>, xyz> {};
struct accelerated : cca::space<linear_acceleration<trunk>, xyz> {};
struct load : cca::space<cca::wrench<trunk, trunk>, xyz> {};
struct motion : cca::space<cca::twist<trunk, world>, xyz> {};
struct numbers : cca::space<cca::number, leg> {};

struct place : cca::space<cca::pose<world>, xyz> {};
constexpr int points = 3;
struct way : cca::array_of<leg_angles, points> {};
struct way_velocities : cca::array_of<leg_velocities, points> {};
struct lens : cca::dimension<"lens"> {};
struct colours : cca::record<4 * 2 * 3> {};
struct depths : cca::record<4 * 2> {};
struct picture : cca::space<colours, cca::axes<lens>> {};
struct depth : cca::space<depths, cca::axes<lens>> {};

using joints = cca::ros2::joint_state<leg_angles, leg_velocities, leg_torques>;
using inertial = cca::ros2::imu<attitude, turning, accelerated>;
using loads = cca::ros2::wrench_stamped<load>;
using motions = cca::ros2::twist_stamped<motion>;
using array = cca::ros2::float64_multi_array<numbers>;
using places = cca::ros2::pose_stamped<place>;
using commands = cca::ros2::twist<motion>;
using transforms = cca::ros2::transform_stamped<place, "trunk">;
using tree = cca::ros2::tf<place, "trunk">;
using ways = cca::ros2::joint_trajectory<way, way_velocities>;
using pictures = cca::ros2::image<picture, 4, 2, "rgb8">;
using depth_pictures = cca::ros2::image<depth, 4, 2, "32FC1">;

// A domain that no other test of this machine is likely to use now. Its ports are below those that the kernel
// gives to others.
inline std::string domain() {
  static const std::string number = std::to_string(1 + ::getpid() % 98);
  return number;
}
inline void use_own_domain() { ::setenv("ROS_DOMAIN_ID", domain().c_str(), 1); }

// Calls f each millisecond until it is true. False: it never was.
template <class F>
bool within_seconds(int seconds, F f) {
  for (int i = 0; i < 1000 * seconds; ++i) {
    if (f()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

template <class Part>
using numbers_of = Eigen::Matrix<double, Part::size, 1>;

}  // namespace ros2_test
