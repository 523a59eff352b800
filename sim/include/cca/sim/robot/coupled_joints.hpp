// Joints that follow others, in an engine that has no such joint.
//
// The engine steps as if each joint moved alone. Then all bodies are moved to where the coordinates can have
// them: of all motions of the robot it takes the one nearest to the engine's, weighed by the masses and
// inertias. That is what ideal gears between the joints do: they pass momentum on and take no energy.
//
//   V* = velocities of the bodies after the engine's step, J(q) v = those that coordinates and base can have
//   v  = argmin |J(q) v - V*|^2 in the metric of the masses: once at the old q, which gives q + h v, then
//   there
//
// A joint that keeps its link parallel to the one before its leader is a constraint of the engine instead
// (tree_in_engine.hpp); a robot that has no other followers needs no projection.
//
// The projection at the new q turns the velocities with the joints, as the engine's own constraints do in the
// step after; so the accelerations are right to the same order as those of joints that are not coupled. A
// contact is solved in the engine's step, for a joint that moves alone; what it takes from one joint the
// others feel at the end of the step. Source: the projection is Gauss's principle of least constraint, over
// one step. Cost: two symmetric solves of (coordinates, + 6 if the base floats) per step, only for robots
// with coupled joints. Nothing allocates after it was made.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include <Eigen/Cholesky>

#include <cca/sim/robot/joint_law.hpp>
#include <cca/sim/robot/tree_in_engine.hpp>

namespace cca::sim {

class coupled_joints {
public:
  coupled_joints(std::shared_ptr<const robot_model> model, const tree_in_engine& tree)
      : model_(std::move(model)), first_(model_->floats ? 6 : 0) {
    for (std::size_t i = 0; i < model_->links.size(); ++i)
      exist_ = exist_ || !(tree.leads(i) || tree.is_held_parallel(i));
    if (!exist_) return;
    const auto n = first_ + static_cast<Eigen::Index>(model_->drives.size());
    jacobians_.assign(model_->links.size() + 1, Eigen::MatrixXd::Zero(6, n));
    moved_.assign(model_->links.size() + 1, vector6::Zero());
    weights_.setZero(n, n);
    motion_.setZero(n);
    solver_ = Eigen::LDLT<Eigen::MatrixXd>(n);
    q_.assign(model_->drives.size(), 0);
    dq_ = q_;
  }

  bool exist() const { return exist_; }

  // Before the engine's step.
  void begin(const tree_in_engine& tree) {
    base_ = tree.frame(-1);
    look_at(tree);
  }

  // After it.
  void end(tree_in_engine& tree, std::vector<joint_reading>& joints, double step) {
    for (int i = -1; i < links(); ++i)
      if (const dBodyID b = tree.body_of(i))
        moved_[slot(i)] =
            cca::detail::spatial(vector::Map(dBodyGetAngularVel(b)), vector::Map(dBodyGetLinearVel(b)));
    project();
    for (std::size_t c = 0; c < q_.size(); ++c) {
      q_[c] = joints[c].angle + step * speed(c);
      dq_[c] = 0;
    }
    if (first_ > 0) move_base(step);
    base_.angular_velocity.setZero(), base_.velocity.setZero();
    tree.place(q_, dq_, base_);
    look_at(tree);
    project();
    if (first_ > 0) base_.angular_velocity = motion_.head<3>(), base_.velocity = motion_.segment<3>(3);
    for (std::size_t c = 0; c < q_.size(); ++c) {
      dq_[c] = speed(c);
      joints[c].angle = q_[c], joints[c].velocity = dq_[c];
    }
    tree.place(q_, dq_, base_);
  }

private:
  using vector = Eigen::Vector3d;
  using vector6 = cca::detail::vector6;

  int links() const { return static_cast<int>(model_->links.size()); }
  // Link -1 is the base and has slot 0.
  static std::size_t slot(int link) { return static_cast<std::size_t>(link + std::ptrdiff_t{1}); }
  double speed(std::size_t c) const { return motion_[first_ + static_cast<Eigen::Index>(c)]; }

  void move_base(double step) {
    base_.where.at += step * motion_.segment<3>(3);
    const vector turned = step * motion_.head<3>();
    base_.where.turn = (rotation::matrix(rotation::exp(turned)) * base_.where.turn).eval();
  }

  static void shift(Eigen::MatrixXd& j, const vector& by) {
    for (Eigen::Index k = 0; k < j.cols(); ++k)
      j.col(k).tail<3>() += cca::detail::cross(vector(j.col(k).head<3>()), by);
  }

  // The Jacobians of all frames, then of all centres of mass, and the inertia of the coordinates.
  void look_at(const tree_in_engine& tree) {
    Eigen::MatrixXd& root = jacobians_[slot(-1)];
    root.setZero();
    if (first_ > 0) root.leftCols<6>().setIdentity();
    const vector origin = tree.frame(-1).where.at;
    origins_.assign(model_->links.size() + 1, origin);
    for (int i = 0; i < links(); ++i) {
      const auto& l = model_->links[static_cast<std::size_t>(i)];
      const rigid f = tree.frame(i).where;
      origins_[slot(i)] = f.at;
      Eigen::MatrixXd& j = jacobians_[slot(i)];
      j = jacobians_[slot(l.parent)];
      shift(j, f.at - origins_[slot(l.parent)]);
      const vector axis = l.ratio * (f.turn * cca::detail::as_vector(l.axis));
      auto column = j.col(first_ + l.coordinate);
      if (l.kind == joint_kind::revolute) column.head<3>() += axis;
      else column.tail<3>() += axis;
    }
    for (int i = first_ > 0 ? -1 : 0; i < links(); ++i) {
      const link_inertia& of = i < 0 ? model_->base : model_->links[static_cast<std::size_t>(i)].inertia;
      const Eigen::Matrix3d turn = tree.frame(i).where.turn;
      Eigen::MatrixXd& j = jacobians_[slot(i)];
      shift(j, turn * cca::detail::as_vector(of.centre));
    }
    weigh(tree);
  }

  Eigen::Matrix3d inertia(const tree_in_engine& tree, int i) const {
    const link_inertia& of = i < 0 ? model_->base : model_->links[static_cast<std::size_t>(i)].inertia;
    const Eigen::Matrix3d turn = tree.frame(i).where.turn;
    return turn * cca::detail::matrix_of(of.about_centre) * turn.transpose();
  }
  double mass(int i) const {
    return (i < 0 ? model_->base : model_->links[static_cast<std::size_t>(i)].inertia).mass;
  }

  void weigh(const tree_in_engine& tree) {
    weights_.setZero();
    inertias_.assign(model_->links.size() + 1, Eigen::Matrix3d::Zero());
    for (int i = first_ > 0 ? -1 : 0; i < links(); ++i) {
      const Eigen::Matrix3d& w = inertias_[slot(i)] = inertia(tree, i);
      const Eigen::MatrixXd& j = jacobians_[slot(i)];
      for (Eigen::Index a = 0; a < j.cols(); ++a) {
        const vector turned = w * j.col(a).head<3>(), moved = mass(i) * j.col(a).tail<3>();
        for (Eigen::Index b = 0; b < j.cols(); ++b)
          weights_(b, a) += turned.dot(j.col(b).head<3>()) + moved.dot(j.col(b).tail<3>());
      }
    }
    solver_.compute(weights_);
  }

  void project() {
    motion_.setZero();
    for (int i = first_ > 0 ? -1 : 0; i < links(); ++i) {
      const vector turned = inertias_[slot(i)] * moved_[slot(i)].head<3>(),
                   moved = mass(i) * moved_[slot(i)].tail<3>();
      const Eigen::MatrixXd& j = jacobians_[slot(i)];
      for (Eigen::Index a = 0; a < j.cols(); ++a)
        motion_[a] += turned.dot(j.col(a).head<3>()) + moved.dot(j.col(a).tail<3>());
    }
    solver_.solveInPlace(motion_);
  }

  std::shared_ptr<const robot_model> model_;
  Eigen::Index first_;  // the coordinates stand behind the base
  bool exist_ = false;
  moving_frame base_;
  std::vector<Eigen::MatrixXd> jacobians_;  // of the centres of mass: angular, then linear
  std::vector<vector6> moved_;
  std::vector<vector> origins_;
  std::vector<Eigen::Matrix3d> inertias_;
  Eigen::MatrixXd weights_;
  Eigen::VectorXd motion_;  // of the base, if it floats; of the coordinates
  Eigen::LDLT<Eigen::MatrixXd> solver_;
  std::vector<double> q_, dq_;
};

}  // namespace cca::sim
