// Domain types: what the coordinates of a space mean.
#pragma once

#include <cca/space/linear.hpp>
#include <cca/space/scalar.hpp>

namespace cca {

struct joint_angles : detail::linear_domain        { using quantity = angle;        static constexpr bool actuated = true; };
struct joint_velocities : detail::linear_domain    { using quantity = velocity;     static constexpr bool actuated = true; };
struct joint_accelerations : detail::linear_domain { using quantity = acceleration; static constexpr bool actuated = true; };
struct joint_torques : detail::linear_domain       { using quantity = torque;       static constexpr bool actuated = true; };
struct joint_stiffness : detail::linear_domain     { using quantity = stiffness;    static constexpr bool actuated = true; };

template <class Frame>
struct cartesian_position : detail::linear_domain { using quantity = length; };

struct phase : detail::linear_domain {};

}  // namespace cca
