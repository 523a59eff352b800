// An arm of seven joints, as a body and as a KDL::Chain; lengths and inertias are chosen.
#pragma once

#include <array>
#include <string>

#include <kdl/chain.hpp>

#include <cca/mapping/serial_chain.hpp>
#include <cca/robot/body.hpp>

namespace bench {

struct arm_base : cca::frame<"arm base"> {};
struct flange : cca::frame<"flange"> {};
template <cca::fixed_string Name>
struct arm_joint : cca::dimension<Name> {};
using arm_axes = cca::axes<arm_joint<"a1">,
                           arm_joint<"a2">,
                           arm_joint<"a3">,
                           arm_joint<"a4">,
                           arm_joint<"a5">,
                           arm_joint<"a6">,
                           arm_joint<"a7">>;

struct arm_chain : cca::serial_chain<arm_base, flange, arm_axes> {
  static constexpr std::array joints{
      cca::revolute(cca::along_z, cca::at(0, 0, 0.11)), cca::revolute(cca::along_y, cca::at(0, 0, 0.2)),
      cca::revolute(cca::along_z, cca::at(0, 0, 0.2)),  cca::revolute(cca::along_y, cca::at(0, 0, 0.2)),
      cca::revolute(cca::along_z, cca::at(0, 0, 0.2)),  cca::revolute(cca::along_y, cca::at(0, 0, 0.19)),
      cca::revolute(cca::along_z, cca::at(0, 0, 0.08))};
  static constexpr auto tip = cca::at(0, 0, 0.05);
  static constexpr std::array links{
      cca::link_inertia{2.7, {0, -0.03, 0.12}, {0.016, 0.015, 0.006, 0, 0, 1e-3}},
      cca::link_inertia{2.7, {0, 0.05, 0.07}, {0.016, 0.007, 0.014, 0, 0, 1e-3}},
      cca::link_inertia{2.7, {0, 0.03, 0.12}, {0.016, 0.015, 0.006, 0, 0, -1e-3}},
      cca::link_inertia{2.7, {0, -0.05, 0.07}, {0.016, 0.007, 0.014, 0, 0, -1e-3}},
      cca::link_inertia{1.7, {0, -0.02, 0.1}, {0.01, 0.009, 0.003, 0, 0, 1e-3}},
      cca::link_inertia{1.6, {0, 0.01, 0.01}, {0.003, 0.003, 0.003, 0, 0, 0}},
      cca::link_inertia{0.3, {0, 0, 0.02}, {1e-3, 1e-3, 1e-3, 0, 0, 0}}};
};
struct arm : cca::body<arm_base, cca::part<"arm", arm_chain>> {};

inline KDL::Chain kdl_arm() {
  KDL::Chain chain;
  const auto vector = [](const std::array<double, 3>& v) { return KDL::Vector(v[0], v[1], v[2]); };
  for (std::size_t i = 0; i < arm_chain::joints.size(); ++i) {
    const cca::joint& j = arm_chain::joints[i];
    const cca::link_inertia& of = arm_chain::links[i];
    const auto& m = of.about_centre;
    const KDL::Frame where(vector(j.where.translation));
    const std::string name = std::to_string(i);
    chain.addSegment(
        KDL::Segment(name, KDL::Joint(name, where.p, vector(j.axis), KDL::Joint::RotAxis), where,
                     KDL::RigidBodyInertia(of.mass, vector(of.centre),
                                           KDL::RotationalInertia(m[0], m[1], m[2], m[3], m[4], m[5]))));
  }
  return chain;
}

}  // namespace bench
