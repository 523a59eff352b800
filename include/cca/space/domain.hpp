// Domain types: what the coordinates of a space mean.
#pragma once

#include <cca/space/quantity.hpp>

namespace cca {

namespace detail {

// One real coordinate an axis, zero at rest.
struct linear_domain {
  using quantity = value;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }

  template <class Self>
  struct methods {};
};

}  // namespace detail

struct joint_angles : detail::linear_domain        { using quantity = angle;        static constexpr bool actuated = true; };
struct joint_velocities : detail::linear_domain    { using quantity = velocity;     static constexpr bool actuated = true; };
struct joint_accelerations : detail::linear_domain { using quantity = acceleration; static constexpr bool actuated = true; };
struct joint_torques : detail::linear_domain       { using quantity = torque;       static constexpr bool actuated = true; };
struct joint_stiffness : detail::linear_domain     { using quantity = stiffness;    static constexpr bool actuated = true; };

template <class Frame>
struct cartesian_position : detail::linear_domain { using quantity = length; };

struct amplitude : detail::linear_domain {};
struct frequency : detail::linear_domain {};
struct number : detail::linear_domain {};
struct status : detail::linear_domain {};
struct phase : detail::linear_domain {};

}  // namespace cca
