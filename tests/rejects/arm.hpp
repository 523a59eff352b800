// The chain of an arm of two joints, and the spaces in which these are measured.
#pragma once

#include <cca/robot/body_components.hpp>

template <cca::fixed_string Name>
struct joint_axis : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::velocity{-8, 8}, cca::torque{-9, 9}};
};
struct shoulder : joint_axis<"shoulder"> {};
struct elbow : joint_axis<"elbow"> {};
struct mount : cca::frame<"mount"> {};
struct hand : cca::frame<"hand"> {};

struct chain : cca::serial_chain<mount, hand, cca::axes<shoulder, elbow>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0.3, 0, 0))};
  static constexpr auto tip = cca::at(0.3, 0, 0);
  static constexpr std::array links{cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}},
                                    cca::link_inertia{1, {0.1, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}}};
};

struct angles : cca::space<cca::joint_angles, cca::axes<shoulder, elbow>> {};
struct velocities : cca::space<cca::joint_velocities, cca::axes<shoulder, elbow>> {};
