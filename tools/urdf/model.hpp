// What a URDF file says, as far as the tool understands it. Units: m, rad, kg, kg m^2, N m (prismatic: N).
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "inertia.hpp"

namespace cca_urdf {

// `xyz` and `rpy` of an <origin>: turned about x, then y, then z of the frame in which it stands.
struct origin {
  std::array<double, 3> xyz{}, rpy{};

  Eigen::Isometry3d placed() const {
    using turn = Eigen::AngleAxisd;
    return Eigen::Translation3d(xyz[0], xyz[1], xyz[2]) * turn(rpy[2], Eigen::Vector3d::UnitZ()) *
           turn(rpy[1], Eigen::Vector3d::UnitY()) * turn(rpy[0], Eigen::Vector3d::UnitX());
  }
  bool is_identity() const { return xyz == std::array<double, 3>{} && rpy == xyz; }

  static origin of(const Eigen::Isometry3d& placed) {
    const Eigen::Vector3d at = placed.translation(), turned = placed.linear().eulerAngles(2, 1, 0);
    return {{at[0], at[1], at[2]}, {turned[2], turned[1], turned[0]}};
  }
};

enum class form_kind { box, sphere, capsule, cylinder };

struct collision {
  int line = 0;
  form_kind kind = form_kind::sphere;
  std::array<double, 3> size{};  // a box's edges; a radius; a radius and a length (capsule: between centres)
  origin where{};
};

struct inertial {
  int line = 0;
  origin where{};
  mass_of_link own{};  // in the frame of `where`
};

struct link {
  std::string name;
  int line = 0;
  std::optional<inertial> inertia;
  std::vector<collision> collisions;
};

enum class joint_type { fixed, revolute, continuous, prismatic, floating };

struct joint_limit {
  std::optional<double> lower, upper;
  double effort = 0, velocity = 0;  // 0: no motor; no limit
};

// The joint moves by `multiplier` times another one, plus `offset`.
struct mimic_of {
  int line = 0;
  std::string joint;
  double multiplier = 1, offset = 0;
  bool has_own_limit = false;  // which nobody uses
};

struct joint {
  std::string name;
  int line = 0;
  joint_type type = joint_type::fixed;
  std::string parent, child;
  origin where{};
  std::array<double, 3> axis{1, 0, 0};
  std::optional<joint_limit> limit;  // none: it follows another joint
  double damping = 0;
  std::optional<mimic_of> mimic;

  bool moves() const { return type != joint_type::fixed && type != joint_type::floating; }
  // How far it has moved its child at a coordinate.
  Eigen::Isometry3d moved(double by) const {
    const Eigen::Vector3d along = Eigen::Vector3d(axis[0], axis[1], axis[2]).normalized();
    if (type == joint_type::prismatic) return Eigen::Isometry3d(Eigen::Translation3d(by * along));
    return Eigen::Isometry3d(Eigen::AngleAxisd(by, along));
  }
};

struct robot {
  std::string name;
  std::vector<link> links;
  std::vector<joint> joints;
};

// `link 'hand' (line 12)`, for messages.
inline std::string named(const link& l) { return "link '" + l.name + "'"; }
inline std::string named(const joint& j) { return "joint '" + j.name + "'"; }
inline std::string with_line(const auto& thing) {
  return named(thing) + " (line " + std::to_string(thing.line) + ")";
}

}  // namespace cca_urdf
