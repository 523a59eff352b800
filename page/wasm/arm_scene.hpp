// A simulated arm on a page: its bodies and those around it, the force on its tool, a pull at its hand.
//
// Extra numbers of a row: the hand's position (3, m), the force of the world on the tool (3, N). Poses:
// position and quaternion (w x y z) of each body, then where the tool is touched (3). Where the hand should
// be is a port, `target` in the description.
//
// The bodies are the shapes with which the arm touches the world; where there are none, bones from joint to
// joint.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include <Eigen/Geometry>

#include <cca/mapping/kinematics.hpp>
#include <cca/sim/engine/scene.hpp>
#include <cca/sim/robot/model/robot_model.hpp>

#include "json_text.hpp"

namespace cca::page {

struct arm_scene {
  static constexpr int extra_count = 3 + 3;

  struct drawn_body {
    int link;  // -1: the base
    const char* shape;
    std::array<double, 3> size;
    rigid where;
    int part;
  };

  static std::vector<drawn_body> bodies_of(const sim::robot_model& m) {
    std::vector<drawn_body> all;
    constexpr double joint = 0.065, bone = 0.04;  // radii, m
    const auto add_bone = [&](int link, const Eigen::Vector3d& to) {
      if (to.norm() < 0.02) return;
      const Eigen::Quaterniond along = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), to);
      all.push_back({link, "capsule", {bone, to.norm(), 0}, {along.toRotationMatrix(), 0.5 * to}, 1});
    };
    all.push_back({-1, "cylinder", {0.09, 0.12, 0}, {Eigen::Matrix3d::Identity(), {0, 0, 0.06}}, 4});
    for (std::size_t i = 0; i < m.links.size(); ++i) {
      add_bone(m.links[i].parent, cca::detail::as_vector(m.links[i].at));
      all.push_back({static_cast<int>(i), "sphere", {joint, 0, 0}, {}, 2});
    }
    for (const auto& end : m.ends) add_bone(end.link, cca::detail::as_vector(end.where.translation));
    for (const sim::placed_shape& s : m.shapes) {
      const char* const kind = s.form.kind == robots::shape_kind::box       ? "box"
                               : s.form.kind == robots::shape_kind::capsule ? "capsule"
                                                                            : "sphere";
      all.push_back({s.link, kind, s.form.size, rigid() * s.where, s.sensor < 0 ? 1 : 3});
    }
    return all;
  }

  static constexpr int pose_count = 256;  // at most

  template <class World>
  static Eigen::Vector3d force_on_tool(const World& w) {
    const auto& felt = w.load(0);
    return w.end(0).where.turn * Eigen::Vector3d(felt[3], felt[4], felt[5]);
  }
  template <class World>
  static void extra_of(const World& w, double* to) {
    for (const double x : w.end(0).where.at) *to++ = x;
    for (const double x : force_on_tool(w)) *to++ = x;
  }

  // `boxes`: how many the scene has. `radius`: of the tool, a sphere in front of the hand.
  template <class World>
  static void poses_of(const World& w,
                       const std::vector<drawn_body>& bodies,
                       std::size_t boxes,
                       double radius,
                       double* to) {
    for (const drawn_body& b : bodies) {
      const rigid f = w.frame(b.link).where;
      const Eigen::Vector3d at = f.turn * b.where.at + f.at;
      const Eigen::Quaterniond q(Eigen::Matrix3d(f.turn * b.where.turn));
      for (const double x : {at[0], at[1], at[2], q.w(), q.x(), q.y(), q.z()}) *to++ = x;
    }
    for (std::size_t i = 0; i < boxes; ++i) {
      const auto& box = w.save().around.boxes[i];
      const auto& [x, y, z, turn] = box.attitude.q;
      for (const double number : {box.at[0], box.at[1], box.at[2], turn, x, y, z}) *to++ = number;
    }
    const auto hand = w.end(0).where;
    const Eigen::Vector3d force = force_on_tool(w);
    Eigen::Vector3d touched = hand.at + hand.turn * Eigen::Vector3d(0, 0, radius);
    if (force.norm() > 0.1) touched -= radius * force.normalized();
    for (const double x : touched) *to++ = x;
  }

  static void add_shapes_of(json_text& json,
                            const std::vector<drawn_body>& bodies,
                            const sim::scene& around,
                            const char* target) {
    const auto numbers = [&](const char* key, std::initializer_list<double> all) {
      json.key(key).open('[');
      for (const double x : all) json.add(x);
      json.close(']');
    };
    const auto body = [&](const char* shape, const std::array<double, 3>& size, int part, bool stands) {
      json.open('{').key("shape").add(shape).key("part").add(part).key("stands").add(stands);
      numbers("size", {size[0], size[1], size[2]});
      json.close('}');
    };
    json.key("robot").open('{').key("kind").add("arm");
    json.key("points").open('[').add("hand").close(']');
    json.key("bodies").open('[');
    for (const drawn_body& b : bodies) body(b.shape, b.size, b.part, b.link < 0);
    for (const sim::fixed_box& b : around.boxes) body("box", b.size, 5, true);
    json.close(']');
    json.key("extra").open('{').key("position").add(0).key("forces").add(3).close('}');
    json.key("target").add(target).key("newtonsPerMetre").add(60);
    json.key("view").open('{').key("distance").add(1.9).key("azimuth").add(-0.9).key("height").add(0.38);
    numbers("at", {0.35, 0, 0.32});
    json.close('}').close('}');
  }
};

}  // namespace cca::page
