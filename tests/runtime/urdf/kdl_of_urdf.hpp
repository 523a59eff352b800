// A URDF file as a tree of the Orocos Kinematics and Dynamics Library: each link a segment, fixed joints as
// they are. It shares no code with cca-urdf.
#pragma once

#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include <kdl/tree.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>

#include <tinyxml2.h>

namespace urdf_test {

inline KDL::Vector numbers(const tinyxml2::XMLElement* e,
                           const char* attribute,
                           const KDL::Vector& otherwise) {
  if (!e || !e->Attribute(attribute)) return otherwise;
  std::istringstream text(e->Attribute(attribute));
  double x = 0, y = 0, z = 0;
  if (!(text >> x >> y >> z)) throw std::runtime_error("three numbers are expected");
  return {x, y, z};
}

inline KDL::Frame frame(const tinyxml2::XMLElement* e) {
  const KDL::Vector rpy = numbers(e, "rpy", {});
  return {KDL::Rotation::RPY(rpy.x(), rpy.y(), rpy.z()), numbers(e, "xyz", {})};
}

class kdl_robot {
public:
  explicit kdl_robot(const std::string& file) {
    tinyxml2::XMLDocument document;
    if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) throw std::runtime_error(file);
    const auto* robot = document.RootElement();
    std::map<std::string, std::string> held_by;  // link, joint
    for (const auto* j = robot->FirstChildElement("joint"); j; j = j->NextSiblingElement("joint"))
      held_by[j->FirstChildElement("child")->Attribute("link")] = j->Attribute("name");
    std::string root;
    for (const auto* l = robot->FirstChildElement("link"); l; l = l->NextSiblingElement("link"))
      if (!held_by.contains(l->Attribute("name"))) root = l->Attribute("name");
    KDL::Tree built(root);
    for (bool grows = true; grows;) {
      grows = false;
      for (const auto* j = robot->FirstChildElement("joint"); j; j = j->NextSiblingElement("joint")) {
        const std::string parent = j->FirstChildElement("parent")->Attribute("link"),
                          child = j->FirstChildElement("child")->Attribute("link");
        if (built.getSegments().contains(child) || !built.getSegments().contains(parent)) continue;
        grows |= built.addSegment(
            KDL::Segment(child, joint(*j), frame(j->FirstChildElement("origin")), inertia(*robot, child)),
            parent);
        if (std::string(j->Attribute("type")) == "fixed") continue;
        const std::string name = j->Attribute("name");
        segment_of_[name] = child;
        if (const auto* m = j->FirstChildElement("mimic"))
          follows_[name] = {m->Attribute("joint"), m->DoubleAttribute("multiplier", 1),
                            m->DoubleAttribute("offset")};
      }
    }
    tree_ = built;  // a copy numbers its joints again
  }

  std::size_t joints() const { return tree_.getNrOfJoints() - follows_.size(); }

  // Over the named joints, in their order; the base is fixed. A joint that follows one of them adds its
  // torque, by the principle of virtual work.
  template <class Names, class Vector>
  Vector torques(const Names& names, const Vector& q, const Vector& dq, const Vector& ddq) const {
    KDL::TreeIdSolver_RNE solver(tree_, KDL::Vector(0, 0, -9.81));
    KDL::JntArray torques(tree_.getNrOfJoints());
    if (solver.CartToJnt(ordered(names, q, 1), ordered(names, dq, 0), ordered(names, ddq, 0), {}, torques) <
        0)
      throw std::runtime_error("KDL");
    Vector t = 0 * q;
    for (const auto& [joint, segment] : segment_of_) {
      const gear g = gear_of(joint);
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == g.leader) t[static_cast<int>(i)] += g.ratio * torques(number(joint));
    }
    return t;
  }

private:
  static KDL::Joint joint(const tinyxml2::XMLElement& e) {
    const std::string type = e.Attribute("type"), name = e.Attribute("name");
    if (type == "fixed") return KDL::Joint(name, KDL::Joint::None);
    const KDL::Frame at = frame(e.FirstChildElement("origin"));
    const KDL::Vector axis = numbers(e.FirstChildElement("axis"), "xyz", {1, 0, 0});
    return KDL::Joint(name, at.p, at.M * axis,
                      type == "prismatic" ? KDL::Joint::TransAxis : KDL::Joint::RotAxis);
  }

  static KDL::RigidBodyInertia inertia(const tinyxml2::XMLElement& robot, const std::string& link) {
    for (const auto* l = robot.FirstChildElement("link"); l; l = l->NextSiblingElement("link")) {
      const auto* e = l->FirstChildElement("inertial");
      if (link != l->Attribute("name") || !e) continue;
      const auto* i = e->FirstChildElement("inertia");
      const auto of = [i](const char* name) { return i->DoubleAttribute(name); };
      return frame(e->FirstChildElement("origin")) *
             KDL::RigidBodyInertia(
                 e->FirstChildElement("mass")->DoubleAttribute("value"), KDL::Vector::Zero(),
                 KDL::RotationalInertia(of("ixx"), of("iyy"), of("izz"), of("ixy"), of("ixz"), of("iyz")));
    }
    return KDL::RigidBodyInertia::Zero();
  }

  unsigned number(const std::string& joint) const {
    return GetTreeElementQNr(tree_.getSegment(segment_of_.at(joint))->second);
  }
  struct gear {
    std::string leader;
    double ratio = 1, offset = 0;
  };
  gear gear_of(const std::string& joint) const {
    const auto found = follows_.find(joint);
    if (found == follows_.end()) return {joint};
    const gear inner = gear_of(found->second.leader);
    return {inner.leader, found->second.ratio * inner.ratio,
            found->second.ratio * inner.offset + found->second.offset};
  }

  // `offset`: 1 for positions, 0 for their changes.
  template <class Names, class Vector>
  KDL::JntArray ordered(const Names& names, const Vector& v, double offset) const {
    KDL::JntArray a(tree_.getNrOfJoints());
    for (const auto& [joint, segment] : segment_of_) {
      const gear g = gear_of(joint);
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == g.leader) a(number(joint)) = g.ratio * v[static_cast<int>(i)] + offset * g.offset;
    }
    return a;
  }

  KDL::Tree tree_{"none"};
  std::map<std::string, std::string> segment_of_;  // of each joint that moves
  std::map<std::string, gear> follows_;
};

}  // namespace urdf_test
