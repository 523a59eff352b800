// Springs and cables of a robot in the engine: forces along the straight line between two points.
//
// They are explicit: each physics step takes the lengths and speeds of its beginning. A step h is stable
// while stiffness * h^2 is well below the masses that hang on it. Points that lie on each other have no
// direction, so no force.
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/sim/robot/tree_in_engine.hpp>

namespace cca::sim {

class springs_in_engine {
public:
  using vector = Eigen::Vector3d;

  // The force that pulls the two points of a spring together, N; negative: it pushes.
  static double tension(const placed_spring& s, const tree_in_engine& tree) {
    return tension(s, line_of(s, tree));
  }

  static void act(const robot_model& model, const tree_in_engine& tree) {
    for (const placed_spring& s : model.line_springs) {
      const line l = line_of(s, tree);
      const vector f = tension(s, l) * l.along;
      push(tree.body_of(s.from.link), f, l.from);
      push(tree.body_of(s.to.link), -f, l.to);
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

  static line line_of(const placed_spring& s, const tree_in_engine& tree) {
    const moving_frame a = tree.at(s.from), b = tree.at(s.to);
    line l{a.where.at, b.where.at, b.where.at - a.where.at, 0, 0};
    l.length = l.along.norm();
    l.along = l.length > 0 ? vector(l.along / l.length) : vector::Zero();
    l.speed = (b.velocity - a.velocity).dot(l.along);
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
