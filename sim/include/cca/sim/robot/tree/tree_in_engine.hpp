// A tree of joints in the engine: one body for each link, one hinge or slider for each joint.
//
// A body of the engine lies in the centre of mass of its link, along the axes of the link. Its positions and
// speeds are read from the bodies, so they don't depend on the posture in which the joints were made. Forces
// on joints act on both links, so they do the work of their coordinate and no other.
//
// The base is fixed in the world, or floats: then it is a body too. Of several joints of one coordinate the
// first without a ratio leads: it alone is pushed and has stops; the others follow it (coupled_joints.hpp).
// One that turns back what its parent turned keeps its link parallel to the one before (a pantograph): the
// engine itself holds it, by an angular motor whose stops are zero. Two hinges that cross at right angles,
// with a link without mass between them, are one universal joint of the engine: that link has no body.
// Errors: std::invalid_argument, outside of the loop, for what the engine can't represent: a coordinate
// without a joint, a link without mass (but the one above), an inertia that is not positive definite, a shape
// or a spring on a link without mass.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <ode/ode.h>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/robots/crossing.hpp>
#include <cca/sim/engine/engine.hpp>
#include <cca/sim/robot/tree/crossing_joints.hpp>
#include <cca/sim/robot/tree/engine_joint.hpp>
#include <cca/sim/robot/tree/link_in_engine.hpp>
#include <cca/sim/robot/model/robot_model.hpp>

namespace cca::sim {

class tree_in_engine {
public:
  using vector = Eigen::Vector3d;

  tree_in_engine(dWorldID world, std::shared_ptr<const robot_model> model, const rigid& mount)
      : model_(std::move(model)), links_(model_->links.size()), frames_(links_.size()), mount_(mount) {
    check();
    if (model_->floats) base_ = made_link(world, model_->base, "the base");
    for (std::size_t i = 0; i < links_.size(); ++i)
      if (!is_crossing(i))
        links_[i] = made_link(world, model_->links[i].inertia, "link " + std::to_string(i));
    std::vector<double> middle;
    for (const joint_stops& s : model_->stops) middle.push_back(s.middle());
    place(middle, std::vector<double>(middle.size(), 0.0), {mount, vector::Zero(), vector::Zero()});
    joints_.assign(links_.size(), {});
    for (std::size_t i = 0; i < links_.size(); ++i)
      if (!is_crossing(i)) add_joint(world, i);
    held_.assign(links_.size(), nullptr);
    for (std::size_t i = 0; i < links_.size(); ++i)
      if (turns_back(i)) held_[i] = parallel(world, i);
  }

  // Puts all bodies where these coordinates, speeds and the motion of the base have them. The motion of a
  // fixed base is ignored.
  void place(std::span<const double> q, std::span<const double> dq, const moving_frame& base) {
    moving_frame root{mount_, vector::Zero(), vector::Zero()};
    if (base_) {
      root = base;
      put_link(base_, root, model_->base);
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const auto& l = model_->links[i];
      const moving_frame& p = l.parent < 0 ? root : frames_[static_cast<std::size_t>(l.parent)];
      const auto c = static_cast<std::size_t>(l.coordinate);
      const double angle = l.ratio * q[c] + l.rest, speed = l.ratio * dq[c];
      moving_frame& f = frames_[i];
      f.where = home_of(p.where, l);
      const vector axis = f.where.turn * cca::detail::as_vector(l.axis);
      if (l.kind == joint_kind::revolute) cca::detail::turn_about(f.where.turn, l, angle);
      else f.where.at += angle * axis;
      f.angular_velocity = p.angular_velocity;
      f.velocity = p.velocity + cross(p.angular_velocity, f.where.at - p.where.at);
      (l.kind == joint_kind::revolute ? f.angular_velocity : f.velocity) += speed * axis;
      if (links_[i]) put_link(links_[i], f, l.inertia);
    }
  }

  // Null: a fixed base, or a link without mass where joints cross.
  dBodyID body_of(int link) const { return link < 0 ? base_ : links_[static_cast<std::size_t>(link)]; }
  // The bodies that a joint turns or shifts against each other. Below, null: a fixed base.
  dBodyID body_above(std::size_t joint) const {
    return links_[is_crossing(joint) ? static_cast<std::size_t>(next_[joint]) : joint];
  }
  dBodyID body_below(std::size_t joint) const {
    const int parent = model_->links[joint].parent;
    const bool crosses = parent >= 0 && is_crossing(static_cast<std::size_t>(parent));
    return body_of(crosses ? model_->links[static_cast<std::size_t>(parent)].parent : parent);
  }
  // The link of this joint has no body: its joint crosses the next one.
  bool is_crossing(std::size_t joint) const { return next_[joint] >= 0; }

  const engine_joint& joint_of(std::size_t joint) const { return joints_[joint]; }
  const std::vector<dBodyID>& links() const { return links_; }
  dBodyID base() const { return base_; }  // null: it is fixed

  // The frame of a link (-1: the base), with its motion.
  moving_frame frame(int link) const {
    const dBodyID b = body_of(link);
    if (!b) return link < 0 ? moving_frame{mount_} : between(static_cast<std::size_t>(link));
    const link_inertia& of = link < 0 ? model_->base : model_->links[static_cast<std::size_t>(link)].inertia;
    moving_frame f;
    f.where.turn = turn_of(b);
    const vector arm = f.where.turn * cca::detail::as_vector(of.centre);
    f.where.at = vector::Map(dBodyGetPosition(b)) - arm;
    f.angular_velocity = vector::Map(dBodyGetAngularVel(b));
    f.velocity = vector::Map(dBodyGetLinearVel(b)) - cross(f.angular_velocity, arm);
    return f;
  }

  // The same of a place on a link.
  moving_frame at(const place_on_link& p) const {
    moving_frame f = frame(p.link);
    const vector arm = f.where.turn * cca::detail::as_vector(p.where.translation);
    f.where = f.where * p.where;
    f.velocity += cross(f.angular_velocity, arm);
    return f;
  }

  // A joint's coordinate, from (-pi, pi] for a hinge, and its speed.
  struct motion {
    double position, speed;
  };
  motion read(std::size_t i) const {
    const auto& l = model_->links[i];
    if (is_crossing(i)) return read_crossing(i, i);
    if (l.parent >= 0 && is_crossing(static_cast<std::size_t>(l.parent)))
      return read_crossing(static_cast<std::size_t>(l.parent), i);
    const moving_frame p = frame(l.parent), c = frame(static_cast<int>(i));
    const rigid home = home_of(p.where, l);
    const vector axis = home.turn * cca::detail::as_vector(l.axis);
    if (l.kind == joint_kind::prismatic) {
      const vector arm = c.where.at - p.where.at;
      return {(math::dot(c.where.at - home.at, axis) - l.rest) / l.ratio,
              math::dot(c.velocity - p.velocity - cross(p.angular_velocity, arm), axis) / l.ratio};
    }
    const double angle = angle_about(l, home.turn.transpose() * c.where.turn);
    return {(angle - l.rest) / l.ratio, math::dot(c.angular_velocity - p.angular_velocity, axis) / l.ratio};
  }

  // Whether a joint is the one that its coordinate moves.
  bool leads(std::size_t i) const {
    return leads_[static_cast<std::size_t>(model_->links[i].coordinate)] == static_cast<int>(i);
  }

  bool is_held_parallel(std::size_t i) const { return held_[i] != nullptr; }

  // Before each step: the engine's motors don't know the angles that they hold. The largest of them, rad.
  double hold_parallel() const {
    double largest = 0;
    for (std::size_t i = 0; i < held_.size(); ++i) {
      if (!held_[i]) continue;
      const double off = deviation(i);
      dJointSetAMotorAngle(held_[i], 0, off);
      largest = std::max(largest, std::abs(off));
    }
    return largest;
  }

  // The force of a coordinate on its joint, which leads, for the next step, N m (a slider: N).
  void push(std::size_t i, double force) const {
    const auto& l = model_->links[i];
    const dBodyID child = body_above(i), parent = body_below(i);
    const vector f = force / l.ratio * axis_of(i);
    if (l.kind == joint_kind::revolute) {
      dBodyAddTorque(child, f[0], f[1], f[2]);
      if (parent) dBodyAddTorque(parent, -f[0], -f[1], -f[2]);
    } else {
      const dReal* at = dBodyGetPosition(child);
      dBodyAddForce(child, f[0], f[1], f[2]);
      if (parent) dBodyAddForceAtPos(parent, -f[0], -f[1], -f[2], at[0], at[1], at[2]);
    }
  }

private:
  static vector cross(const vector& a, const vector& b) { return cca::detail::cross(a, b); }
  static Eigen::Map<const Eigen::Matrix3d> home_turn(const cca::detail::body_link& l) {
    return Eigen::Map<const Eigen::Matrix3d>(l.turn.data());
  }
  Eigen::Matrix3d turn_below(std::size_t i) const {
    const dBodyID b = body_below(i);
    return b ? turn_of(b) : mount_.turn;
  }
  // Of a joint, in the world. A joint that crosses the next one has its axis in the link below.
  vector axis_of(std::size_t i) const {
    const auto& l = model_->links[i];
    const vector axis = cca::detail::as_vector(l.axis);
    if (is_crossing(i)) return turn_below(i) * (home_turn(l) * axis);
    return turn_of(links_[i]) * axis;
  }

  // One of two joints that cross; `first` is the one below.
  motion read_crossing(std::size_t first, std::size_t i) const {
    const auto &l = model_->links[i], &a = model_->links[first],
               &b = model_->links[static_cast<std::size_t>(next_[first])];
    const crossing_angles now = crossing_of(a, b, turn_below(first), turn_of(body_above(first)));
    vector turning = vector::Map(dBodyGetAngularVel(body_above(first)));
    if (const dBodyID below = body_below(first)) turning -= vector::Map(dBodyGetAngularVel(below));
    return {((i == first ? now.first : now.second) - l.rest) / l.ratio,
            math::dot(turning, axis_of(i)) / l.ratio};
  }
  // The frame of a link without a body.
  moving_frame between(std::size_t i) const {
    const auto& l = model_->links[i];
    const motion now = read_crossing(i, i);
    moving_frame f = frame(l.parent);
    const rigid home = home_of(f.where, l);
    f.velocity += cross(f.angular_velocity, home.at - f.where.at);
    f.angular_velocity += l.ratio * now.speed * axis_of(i);
    f.where = home;
    cca::detail::turn_about(f.where.turn, l, l.ratio * now.position + l.rest);
    return f;
  }

  void check() {
    if (model_->stops.size() != model_->drives.size() || model_->start.size() != model_->drives.size())
      throw std::invalid_argument(
          "cca::sim::robot: `drives`, `stops` and `start` need one entry for each coordinate");
    leads_.assign(model_->drives.size(), -1);
    for (std::size_t i = 0; i < model_->links.size(); ++i) {
      const auto& l = model_->links[i];
      int& lead = leads_.at(static_cast<std::size_t>(l.coordinate));
      if (lead < 0 || (l.ratio == 1 && model_->links[static_cast<std::size_t>(lead)].ratio != 1))
        lead = static_cast<int>(i);
    }
    for (std::size_t c = 0; c < leads_.size(); ++c)
      if (leads_[c] < 0 || model_->links[static_cast<std::size_t>(leads_[c])].ratio == 0)
        throw std::invalid_argument("cca::sim::robot: coordinate " + std::to_string(c) + " moves no joint");
    next_.assign(model_->links.size(), -1);
    for (std::size_t i = 0; i < next_.size(); ++i) {
      const int after = robots::detail::crossing_after(model_->links, i);
      if (after >= 0 && leads(i) && leads(static_cast<std::size_t>(after))) next_[i] = after;
    }
    for (const placed_shape& s : model_->shapes) check_link(s.link);
    for (const placed_spring& s : model_->line_springs) check_link(s.from.link), check_link(s.to.link);
    for (const place_on_link& end : model_->ends) check_link(end.link);
  }
  void check_link(int link) const {
    if (link >= 0 && is_crossing(static_cast<std::size_t>(link)))
      throw std::invalid_argument("cca::sim::robot: link " + std::to_string(link) +
                                  " has no mass, so it can't carry a shape, a spring or the end of a part; "
                                  "give it an inertia");
  }

  // The frame of a joint whose angle is 0.
  static rigid home_of(const rigid& parent, const cca::detail::body_link& l) {
    return {parent.turn * home_turn(l), parent.at + parent.turn * cca::detail::as_vector(l.at)};
  }

  // Made with all coordinates in the middle of their ranges: the engine's stops work on angles within
  // (-pi, pi) of where a joint was made. A hinge with a wider range has no stops.
  void add_joint(dWorldID world, std::size_t i) {
    const auto& l = model_->links[i];
    const dBodyID child = body_above(i), parent = body_below(i);
    const vector at = frame(static_cast<int>(i)).where.at, axis = axis_of(i);
    if (l.parent >= 0 && is_crossing(static_cast<std::size_t>(l.parent))) {
      const auto below = static_cast<std::size_t>(l.parent);
      joints_[i] = engine_joint::universal(world, child, parent, at, axis, axis_of(below));
      joints_[below] = joints_[i].other_axis();
      add_stops(below);
    } else if (l.kind == joint_kind::prismatic) {
      joints_[i] = engine_joint::slider(world, child, parent, axis);
    } else {
      joints_[i] = engine_joint::hinge(world, child, parent, at, axis);
    }
    add_stops(i);
  }
  void add_stops(std::size_t i) const {
    const auto& l = model_->links[i];
    const double reach = stop_reach(l, model_->stops[static_cast<std::size_t>(l.coordinate)]);
    if (!leads(i) || !(reach > 0)) return;
    joints_[i].set(dParamLoStop, -reach);
    joints_[i].set(dParamHiStop, reach);
  }

  // A hinge directly behind its leader, about the same axis, as far back as the leader goes.
  bool turns_back(std::size_t i) const {
    const auto& l = model_->links[i];
    if (leads(i) || l.parent < 0 || !leads(static_cast<std::size_t>(l.parent))) return false;
    const auto& leader = model_->links[static_cast<std::size_t>(l.parent)];
    const vector axis = Eigen::Map<const Eigen::Matrix3d>(l.turn.data()) * cca::detail::as_vector(l.axis);
    return l.coordinate == leader.coordinate && l.kind == joint_kind::revolute && leader.kind == l.kind &&
           l.ratio == -1 && leader.ratio == 1 &&
           math::norm(axis - cca::detail::as_vector(leader.axis)) < 1e-12;
  }

  // How far the link of such a hinge has turned from where it belongs, about its axis, rad.
  double deviation(std::size_t i) const {
    const auto& l = model_->links[i];
    const auto& leader = model_->links[static_cast<std::size_t>(l.parent)];
    rigid home = home_of(frame(leader.parent).where, leader);
    cca::detail::turn_about(home.turn, leader, leader.rest + l.rest);
    return angle_about(l, home_of(home, l).turn.transpose() * turn_of(links_[i]));
  }

  // Of a rotation about the axis of a joint, from (-pi, pi].
  static double angle_about(const cca::detail::body_link& l, const Eigen::Matrix3d& m) {
    const vector twice_sine(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
    return math::atan2(math::dot(twice_sine, cca::detail::as_vector(l.axis)), math::trace(m) - 1);
  }

  dJointID parallel(dWorldID world, std::size_t i) const {
    constexpr int in_first_body = 1;
    const auto& l = model_->links[i];
    const vector axis = turn_of(links_[i]) * cca::detail::as_vector(l.axis);
    const dJointID j = dJointCreateAMotor(world, nullptr);
    dJointAttach(j, links_[i], body_of(model_->links[static_cast<std::size_t>(l.parent)].parent));
    dJointSetAMotorMode(j, dAMotorUser);
    dJointSetAMotorNumAxes(j, 1);
    dJointSetAMotorAxis(j, 0, in_first_body, axis[0], axis[1], axis[2]);
    dJointSetAMotorParam(j, dParamLoStop, 0);
    dJointSetAMotorParam(j, dParamHiStop, 0);
    return j;
  }

  std::shared_ptr<const robot_model> model_;
  std::vector<dBodyID> links_;
  std::vector<moving_frame> frames_;  // those of the last `place`
  std::vector<engine_joint> joints_;
  std::vector<dJointID> held_;  // null: not held parallel
  std::vector<int> leads_;      // over the coordinates
  std::vector<int> next_;       // over the joints: the one that it crosses, -1: none
  dBodyID base_ = nullptr;
  rigid mount_;
};

}  // namespace cca::sim
