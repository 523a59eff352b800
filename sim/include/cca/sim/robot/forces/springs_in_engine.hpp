// Springs and cables of a robot in the engine: forces along the straight line between two points.
//
// Those that a step can take explicitly (mobility.hpp) are forces, from the lengths and speeds of its
// beginning. The others are constraints from those of its end: of the engine, a friction along the line whose
// softness follows from the resistance (soft_force.hpp), or of the projection (coupled_joints.hpp). Points
// that lie on each other have no direction, so no force.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <cca/base/math/reductions.hpp>
#include <cca/sim/engine/engine.hpp>
#include <cca/sim/robot/forces/coupled_joints.hpp>
#include <cca/sim/robot/forces/drives_in_engine.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

class springs_in_engine {
public:
  using vector = Eigen::Vector3d;

  // The force that pulls the two points of a spring together, N; negative: it pushes.
  static double tension(const placed_spring& s, const tree_in_engine& tree) {
    return tension(s, line_of(s, tree));
  }

  // Of a spring: its length and its force.
  static std::pair<double, double> length_and_tension(const placed_spring& s, const tree_in_engine& tree) {
    const line l = line_of(s, tree);
    return {l.length, tension(s, l)};
  }

  static void act(const engine& e,
                  const robot_model& model,
                  const tree_in_engine& tree,
                  const drives_in_engine& drives,
                  coupled_joints& coupled,
                  double step) {
    for (std::size_t i = 0; i < model.line_springs.size(); ++i) {
      const placed_spring& s = model.line_springs[i];
      const line l = line_of(s, tree);
      const dBodyID from = tree.body_of(s.from.link), to = tree.body_of(s.to.link);
      // Positive: it makes the line longer.
      soft_force f{.pull = s.stiffness * (s.rest - l.length), .stiffness = s.stiffness, .damping = s.damping};
      if (s.only_pulls) f.high = 0;
      if (!drives.spring_is_stiff(i)) {
        const vector pull = tension(s, l) * l.along;
        push(from, pull, l.from);
        push(to, -pull, l.to);
      } else if (!s.only_pulls || l.length > s.rest) {
        if (coupled.exist()) coupled.set_spring(i, f, l.from, l.to, l.along);
        else hold(e, l, f, from, to, step);
      }
    }
  }

  // J; damping aside.
  static double stored(const robot_model& model, const tree_in_engine& tree) {
    double sum = 0;
    for (const placed_spring& s : model.line_springs) {
      const double stretch = line_of(s, tree).length - s.rest;
      if (!s.only_pulls || stretch > 0) sum += 0.5 * s.stiffness * stretch * stretch;
    }
    return sum;
  }

private:
  struct line {
    vector from, to, along;  // along: from `from` to `to`, length 1
    double length, speed;    // m, m/s
  };

  // A constraint for one step. Its force has the same bound both ways: half of a cable's is a force, so that
  // it only pulls.
  static void hold(
      const engine& e, const line& l, const soft_force& f, dBodyID from, dBodyID to, double step) {
    const double resistance = f.resistance(step),
                 most = 10 * (std::abs(f.pull) + resistance * std::abs(l.speed));
    const double middle = f.high < most ? (f.high - most) / 2 : 0;
    push(from, -middle * l.along, l.from);
    push(to, middle * l.along, l.to);
    dContact c{};
    c.surface.mode = dContactAxisDep | dContactFDir1 | dContactMotion1 | dContactSlip1 | dContactSoftCFM;
    c.surface.mu = most + middle + 1e-9;
    c.surface.mu2 = 0;
    c.surface.soft_cfm = 1e12;  // nothing across the line
    c.surface.slip1 = 1 / resistance;
    c.surface.motion1 = (f.pull - middle) / resistance * (to ? 1 : -1);
    const vector across = std::abs(l.along[0]) < 0.8 ? vector::UnitX() : vector::UnitY();
    const vector normal = cca::detail::cross(l.along, across).normalized();
    for (int k = 0; k < 3; ++k)
      c.geom.pos[k] = l.to[k], c.geom.normal[k] = normal[k], c.fdir1[k] = l.along[k];
    const dJointID joint = dJointCreateContact(e.id(), e.contacts(), &c);
    dJointAttach(joint, to ? to : from, to ? from : nullptr);
  }

  static line line_of(const placed_spring& s, const tree_in_engine& tree) {
    const moving_frame a = tree.at(s.from), b = tree.at(s.to);
    line l{a.where.at, b.where.at, b.where.at - a.where.at, 0, 0};
    l.length = math::norm(l.along);
    l.along = l.length > 0 ? vector(l.along / l.length) : vector::Zero();
    l.speed = math::dot(b.velocity - a.velocity, l.along);
    return l;
  }

  static double tension(const placed_spring& s, const line& l) {
    const double pull = s.stiffness * (l.length - s.rest) + s.damping * l.speed;
    if (!s.only_pulls) return pull;
    return l.length > s.rest ? std::max(0.0, pull) : 0;
  }

  static void push(dBodyID b, const vector& f, const vector& at) {
    if (b) dBodyAddForceAtPos(b, f[0], f[1], f[2], at[0], at[1], at[2]);
  }
};

}  // namespace cca::sim
