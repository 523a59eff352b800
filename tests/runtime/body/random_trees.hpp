// Random trees of joints, as the library's array of links and as a KDL::Tree.
#pragma once

#include <string>

#include <kdl/frames.hpp>
#include <kdl/jntarray.hpp>
#include <kdl/tree.hpp>

#include <cca/robot/body_dynamics.hpp>

#include "random_links.hpp"

namespace body_test {

inline KDL::Vector kdl(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
inline KDL::Vector kdl(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
inline Eigen::Vector3d eigen(const KDL::Vector& v) { return {v[0], v[1], v[2]}; }
inline Eigen::Matrix3d eigen(const KDL::Rotation& r) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = r(i, j);
  return m;
}
inline KDL::Frame kdl(const cca::placement& p) {
  return {KDL::Rotation::Quaternion(p.rotation[0], p.rotation[1], p.rotation[2], p.rotation[3]),
          kdl(p.translation)};
}

// In KDL the joint of a segment, with its axis, is placed in the segment before; the tip of the segment at
// angle zero is the frame of our link.
inline KDL::Segment segment(const std::string& name, const cca::joint& j, const cca::link_inertia& inertia) {
  const KDL::Frame where = kdl(j.where);
  const auto kind = j.kind == cca::joint_kind::revolute ? KDL::Joint::RotAxis : KDL::Joint::TransAxis;
  const auto& i = inertia.about_centre;
  return KDL::Segment(name, KDL::Joint(name, where.p, where.M * kdl(j.axis), kind), where,
                      KDL::RigidBodyInertia(inertia.mass, kdl(inertia.centre),
                                            KDL::RotationalInertia(i[0], i[1], i[2], i[3], i[4], i[5])));
}

template <std::size_t Count>
struct random_tree {
  std::array<cca::detail::body_link, Count> links;
  KDL::Tree tree{"base"};

  // A chain, or a tree: each link is attached to any link before it or to the base.
  random_tree(laws::source& random, bool chain) {
    KDL::Tree built("base");
    for (std::size_t i = 0; i < Count; ++i) {
      const int parent = random_parent(random, i, chain);
      const cca::joint j = random_joint(random);
      links[i] = cca::detail::body_link_of(j, static_cast<int>(i), parent);
      links[i].inertia = random_inertia(random);
      built.addSegment(segment(std::to_string(i), j, links[i].inertia),
                       parent < 0 ? "base" : std::to_string(parent));
    }
    tree = built;  // a copy numbers its joints again, depth first, like the copies in KDL's solvers
  }

  // KDL's number of the joint of a link.
  int number(std::size_t i) const {
    return static_cast<int>(GetTreeElementQNr(tree.getSegment(std::to_string(i))->second));
  }

  template <class Vector>
  KDL::JntArray joints(const Vector& q) const {
    KDL::JntArray a(static_cast<unsigned>(Count));
    for (std::size_t i = 0; i < Count; ++i)
      a(static_cast<unsigned>(number(i))) = q[static_cast<Eigen::Index>(i)];
    return a;
  }
};

}  // namespace body_test
