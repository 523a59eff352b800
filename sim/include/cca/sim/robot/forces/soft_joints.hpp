// Soft forces on joints that a step takes at its end, as constraints of the engine.
//
// A soft force (soft_force.hpp) is a motor of the engine whose softness (CFM) is one divided by the force's
// resistance: the engine finds its force together with those of joints, stops and contacts. Three for each
// coordinate: what is in the joint, without bounds, and its motor and its dry friction, within bounds. One
// without a force costs nothing in a step. In a robot with coupled joints all are part of the projection
// (coupled_joints.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <ode/ode.h>

#include <cca/sim/robot/forces/soft_force.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

enum class joint_force : std::size_t { passive, motor, dry };
inline constexpr std::size_t joint_forces = 3;

class soft_joints {
public:
  // In the posture in which the tree is.
  soft_joints(dWorldID world, const robot_model& model, const tree_in_engine& tree)
      : rows_(model.drives.size()), ratio_(model.drives.size(), 1) {
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      if (!tree.leads(i)) continue;
      const auto& l = model.links[i];
      const auto c = static_cast<std::size_t>(l.coordinate);
      ratio_[c] = l.ratio;
      for (row& r : rows_[c]) r = made(world, tree, l, i);
    }
  }

  // For the next step. Both bounds are finite, or none is.
  void set(const tree_in_engine& tree,
           std::size_t link,
           std::size_t c,
           joint_force which,
           const soft_force& f,
           double step) {
    row& r = rows_[c][static_cast<std::size_t>(which)];
    const double resistance = f.resistance(step), ratio = ratio_[c];
    // The engine's motors have one bound for both directions.
    const bool bounded = std::isfinite(f.low) && std::isfinite(f.high);
    const double middle = bounded ? (f.low + f.high) / 2 : 0;
    if (middle != 0) tree.push(link, middle);
    put(r, dParamVel, ratio * (f.pull - middle) / resistance);
    put(r, dParamCFM, ratio * ratio / resistance);
    put(r, dParamFMax, bounded ? (f.high - f.low) / 2 / std::abs(ratio) : dInfinity);
    r.acts = true;
  }
  void clear(std::size_t c, joint_force which) {
    row& r = rows_[c][static_cast<std::size_t>(which)];
    if (r.acts) put(r, dParamFMax, 0);
    r.acts = false;
  }

private:
  struct row {
    dJointID joint = nullptr;
    bool turns = true, acts = false;
  };

  static row made(dWorldID world,
                  const tree_in_engine& tree,
                  const cca::detail::body_link& l,
                  std::size_t link) {
    constexpr int in_world = 0, in_first_body = 1, in_second_body = 2;
    const Eigen::Vector3d axis =
        tree.frame(static_cast<int>(link)).where.turn * cca::detail::as_vector(l.axis);
    const int fixed_in = !tree.is_crossing(link) ? in_first_body
                         : tree.body_below(link) ? in_second_body
                                                 : in_world;
    row r{.turns = l.kind == joint_kind::revolute};
    r.joint = r.turns ? dJointCreateAMotor(world, nullptr) : dJointCreateLMotor(world, nullptr);
    dJointAttach(r.joint, tree.body_above(link), tree.body_below(link));
    if (r.turns) {
      dJointSetAMotorMode(r.joint, dAMotorUser);
      dJointSetAMotorNumAxes(r.joint, 1);
      dJointSetAMotorAxis(r.joint, 0, fixed_in, axis[0], axis[1], axis[2]);
    } else {
      dJointSetLMotorNumAxes(r.joint, 1);
      dJointSetLMotorAxis(r.joint, 0, in_first_body, axis[0], axis[1], axis[2]);
    }
    return r;
  }

  static void put(const row& r, int parameter, double value) {
    if (r.turns) dJointSetAMotorParam(r.joint, parameter, value);
    else dJointSetLMotorParam(r.joint, parameter, value);
  }

  std::vector<std::array<row, joint_forces>> rows_;
  std::vector<double> ratio_;
};

}  // namespace cca::sim
