// The simulated Oncilla on a page: its bodies, feet and forces, and a push on its trunk.
//
// Extra numbers of a row: the trunk's position (3), the force on each foot (4 x 3, N), contact of each foot
// (4), then whether it has fallen. Poses: position and quaternion (w x y z) of each body, then for each foot
// its position, and where the targets of hip and knee would put it.
#pragma once

#include <array>

#include <cca/base/math.hpp>
#include <cca/mapping/kinematics.hpp>
#include <cca/space/methods/rotation.hpp>
#include <cca/sim/oncilla/asked_by_leg.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/oncilla/kinematics.hpp>

#include "json_text.hpp"

namespace cca::page {

struct oncilla_scene {
  static constexpr int body_count = 1 + 4 * 4;  // the trunk; upper, middle, lower segment and toe of each leg
  static constexpr int extra_count = 3 + 12 + 4 + 1;
  static constexpr int pose_count = 7 * body_count + 4 * 6;

  template <class World>
  static void extra_of(const World& w, double* to) {
    for (const double x : w.trunk_position()) *to++ = x;
    for (const auto& leg : w.reading().legs)
      for (const double f : leg.foot_force) *to++ = f;
    for (const auto& leg : w.reading().legs) *to++ = leg.contact() ? 1 : 0;
    *to = w.fallen() ? 1 : 0;
  }

  template <class World>
  static void poses_of(const World& w, double* to) {
    const auto body = [&](int link, const link_inertia& of) {
      const rigid f = w.frame(link).where;
      const Eigen::Vector3d at = f.at + f.turn * cca::detail::as_vector(of.centre);
      const Eigen::Vector4d q = rotation::from_matrix<double>(f.turn);
      for (const double x : {at[0], at[1], at[2], q[3], q[0], q[1], q[2]}) *to++ = x;
    };
    const auto& links = w.model().links;
    body(-1, w.model().base);
    for (std::size_t i = 0; i < links.size(); ++i)
      if (links[i].inertia.mass > 0) body(static_cast<int>(i), links[i].inertia);  // not the abduction's

    const auto& m = sim::oncilla_defaults;
    const rigid trunk = w.frame(-1).where;
    const auto targets = w.targets();
    for (std::size_t i = 0; i < sim::leg_count; ++i) {
      for (const double x : w.foot_position(i)) *to++ = x;
      const auto foot = sim::foot_position(m, {targets[i].hip, targets[i].knee});
      const double tilt = sim::side_of(i) * targets[i].abduction;
      const Eigen::Vector3d at{(sim::is_front(i) ? m.hip_x : -m.hip_x) - m.trunk_forward_of_hips + foot.x,
                               sim::side_of(i) * m.hip_y - foot.z * cca::math::sin(tilt),
                               -m.trunk_above_hips + foot.z * cca::math::cos(tilt)};
      for (const double x : Eigen::Vector3d(trunk.at + trunk.turn * at)) *to++ = x;
    }
  }

  static void add_shapes_of(json_text& json, const sim::oncilla_model& m) {
    const auto body = [&](const char* shape, std::initializer_list<double> size, int part) {
      json.open('{').key("shape").add(shape).key("part").add(part).key("size").open('[');
      for (const double x : size) json.add(x);
      json.close(']').close('}');
    };
    json.key("robot").open('{').key("kind").add("oncilla").key("points").open('[');
    for (const char* leg : {"left front", "right front", "left hind", "right hind"}) json.add(leg);
    json.close(']').key("extra").open('{').key("position").add(0).key("forces").add(3);
    json.key("contacts").add(15).key("fallen").add(19).close('}').key("bodies").open('[');
    body("box", {m.trunk_length, m.trunk_width, m.trunk_height}, 0);
    for (std::size_t i = 0; i < sim::leg_count; ++i) {
      body("cylinder", {m.segment_radius, m.upper_length}, 1);
      body("cylinder", {m.segment_radius * 0.85, m.middle_length}, 2);
      body("cylinder", {m.segment_radius * 0.7, m.lower_length}, 3);
      body("sphere", {m.foot_radius}, 4);
    }
    json.close(']').key("segments").open('[');
    for (const double length : {m.upper_length, m.middle_length, m.lower_length, m.toe_length})
      json.add(length);
    json.close(']').key("hips").open('[');  // from the trunk's centre
    for (std::size_t i = 0; i < sim::leg_count; ++i) {
      json.open('[').add((sim::is_front(i) ? m.hip_x : -m.hip_x) - m.trunk_forward_of_hips);
      json.add(sim::side_of(i) * m.hip_y).add(-m.trunk_above_hips).close(']');
    }
    json.close(']').key("weight").add(m.mass() * sim::engine_settings{}.gravity).close('}');
  }

  template <class Simulator>
  static void push_on(Simulator& simulator, double x, double y, double z, double seconds) {
    sim::disturbance d = sim::disturbance::none();
    d.another = {simulator.world().time(), seconds, {x, y, z}};
    simulator.disturb(d);
  }
};

}  // namespace cca::page
