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
// others feel at the end of the step. Soft forces that a step takes at its end (soft_force.hpp) act in the
// projection, on all joints of a coordinate together. With resistance R and pull p of each, and the metric M:
//
//   (J^T M J + h R) v = J^T M V* + h p       a force at a bound is that bound
//
// So do stops: a coordinate that would pass one in this step gets the speed that ends there.
// Source: the projection is Gauss's principle of least constraint, over one step. Cost: two symmetric solves
// of (coordinates, + 6 if the base floats) per step, only for robots with coupled joints. Nothing allocates
// after it was made.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include <Eigen/Cholesky>

#include <cca/base/math/reductions.hpp>
#include <cca/sim/robot/model/joint_law.hpp>
#include <cca/sim/robot/forces/soft_joints.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>
#include <cca/sim/robot/forces/tree_inertia.hpp>

namespace cca::sim {

class coupled_joints {
public:
  using vector = Eigen::Vector3d;

  coupled_joints(const std::shared_ptr<const robot_model>& model, const tree_in_engine& tree)
      : model_(model), inertia_(model) {
    for (std::size_t i = 0; i < model->links.size(); ++i)
      if (!(tree.leads(i) || tree.is_held_parallel(i))) exist_ = true;
    if (!exist_) return;
    const auto n = inertia_.size();
    moved_.assign(model->links.size() + 1, vector6::Zero());
    soft_.assign(model->drives.size(), {});
    springs_.assign(model->line_springs.size(), {});
    rows_.setZero(n, static_cast<Eigen::Index>(springs_.size()));
    stopped_.assign(model->drives.size(), 0);
    weights_.setZero(n, n);
    pushed_.setZero(n);
    motion_.setZero(n);
    solver_ = Eigen::LDLT<Eigen::MatrixXd>(n);
    q_.assign(model->drives.size(), 0);
    dq_ = q_;
  }

  bool exist() const { return exist_; }

  // Before the engine's step.
  void begin(const tree_in_engine& tree) {
    base_ = tree.frame(-1);
    inertia_.look_at(tree);
    for (part& p : springs_) p.acts = false;
  }

  // For the next step.
  void set(std::size_t c, joint_force which, const soft_force& f) {
    soft_[c][static_cast<std::size_t>(which)] = {f, true};
  }
  void clear(std::size_t c, joint_force which) { soft_[c][static_cast<std::size_t>(which)].acts = false; }

  // The force of a spring that makes its line longer; it acts at two points, along the line.
  void set_spring(
      std::size_t i, const soft_force& f, const vector& from, const vector& to, const vector& along) {
    const placed_spring& s = model_->line_springs[i];
    springs_[i] = {f, true};
    auto row = rows_.col(static_cast<Eigen::Index>(i));
    row.setZero();
    inertia_.slope(s.to.link, to, along, 1, row);
    inertia_.slope(s.from.link, from, along, -1, row);
  }

  // After it. False if it finds no motion that is finite.
  bool end(tree_in_engine& tree, std::vector<joint_reading>& joints, double step) {
    for (int i = -1; i < inertia_.links(); ++i)
      if (const dBodyID b = tree.body_of(i))
        moved_[slot(i)] =
            cca::detail::spatial(vector::Map(dBodyGetAngularVel(b)), vector::Map(dBodyGetLinearVel(b)));
    for (std::size_t c = 0; c < q_.size(); ++c) q_[c] = joints[c].angle;
    project(step);
    if (!std::isfinite(math::sum(motion_))) return false;
    for (std::size_t c = 0; c < q_.size(); ++c) {
      q_[c] += step * speed(c);
      dq_[c] = 0;
    }
    if (floats()) move_base(step);
    base_.angular_velocity.setZero(), base_.velocity.setZero();
    tree.place(q_, dq_, base_);
    inertia_.look_at(tree);
    project(step);
    if (!std::isfinite(math::sum(motion_))) return false;
    if (floats()) base_.angular_velocity = motion_.head<3>(), base_.velocity = motion_.segment<3>(3);
    for (std::size_t c = 0; c < q_.size(); ++c) {
      dq_[c] = speed(c);
      joints[c].angle = q_[c], joints[c].velocity = dq_[c];
    }
    tree.place(q_, dq_, base_);
    return true;
  }

private:
  using vector6 = cca::detail::vector6;

  struct part {
    soft_force force{};
    bool acts = false, bounded = false;  // bounded: at the bound `limit` in this projection
    double limit = 0;
  };

  static std::size_t slot(int link) { return static_cast<std::size_t>(link + std::ptrdiff_t{1}); }
  bool floats() const { return inertia_.first() > 0; }
  Eigen::Index row(std::size_t c) const { return inertia_.first() + static_cast<Eigen::Index>(c); }
  double speed(std::size_t c) const { return motion_[row(c)]; }

  void move_base(double step) {
    base_.where.at += step * motion_.segment<3>(3);
    const vector turned = step * motion_.head<3>();
    base_.where.turn = (rotation::matrix(rotation::exp(turned)) * base_.where.turn).eval();
  }

  void project(double step) {
    pushed_.setZero();
    for (int i = inertia_.begin(); i < inertia_.links(); ++i) {
      const vector turned = inertia_.rotational(i) * moved_[slot(i)].head<3>(),
                   moved = inertia_.mass(i) * moved_[slot(i)].tail<3>();
      const Eigen::MatrixXd& j = inertia_.jacobian(i);
      for (Eigen::Index a = 0; a < j.cols(); ++a)
        pushed_[a] += math::dot(turned, j.col(a).head<3>()) + math::dot(moved, j.col(a).tail<3>());
    }
    each_part([](part& p, auto) { p.bounded = false; });
    std::fill(stopped_.begin(), stopped_.end(), 0);
    do solve(step);
    while (new_bounds(step));
  }

  // f(part, its place among the speeds, or the column of its slopes).
  template <class F>
  void each_part(F f) {
    for (std::size_t c = 0; c < soft_.size(); ++c)
      for (part& p : soft_[c])
        if (p.acts) f(p, row(c));
    for (std::size_t i = 0; i < springs_.size(); ++i)
      if (springs_[i].acts) f(springs_[i], rows_.col(static_cast<Eigen::Index>(i)));
  }

  void solve(double step) {
    weights_ = inertia_.weights();
    motion_ = pushed_;
    each_part([&](const part& p, auto at) {
      const double push = step * (p.bounded ? p.limit : p.force.pull),
                   resist = p.bounded ? 0 : step * p.force.resistance(step);
      if constexpr (std::is_integral_v<decltype(at)>) {
        motion_[at] += push;
        weights_(at, at) += resist;
      } else {
        motion_ += push * at;
        for (Eigen::Index k = 0; k < at.size(); ++k)
          if (at[k] != 0) weights_.col(k) += resist * at[k] * at;
      }
    });
    for (std::size_t c = 0; c < stopped_.size(); ++c) {
      if (!stopped_[c]) continue;
      const double hard = 1e9 * weights_(row(c), row(c));
      weights_(row(c), row(c)) += hard;
      motion_[row(c)] += hard * speed_to_stop(c, step);
    }
    solver_.compute(weights_);
    solver_.solveInPlace(motion_);
  }

  // Whether some more forces are beyond a bound; each can be so once, so this ends.
  bool new_bounds(double step) {
    bool found = false;
    each_part([&](part& p, auto at) {
      if (p.bounded) return;
      double speed;
      if constexpr (std::is_integral_v<decltype(at)>) speed = motion_[at];
      else speed = math::dot(at, motion_);
      const double free = p.force.pull - p.force.resistance(step) * speed;
      p.limit = std::clamp(free, p.force.low, p.force.high);
      p.bounded = p.limit != free;
      found = found || p.bounded;
    });
    for (std::size_t c = 0; c < stopped_.size(); ++c) {
      const joint_stops& s = model_->stops[c];
      const double end = q_[c] + step * speed(c);
      if (stopped_[c] || (end >= s.low && end <= s.high)) continue;
      stopped_[c] = end < s.low ? -1 : 1;
      found = true;
    }
    return found;
  }

  // The engine's share of what a coordinate is beyond a stop, or all that is left to it.
  double speed_to_stop(std::size_t c, double step) const {
    const double way = (stopped_[c] < 0 ? model_->stops[c].low : model_->stops[c].high) - q_[c];
    return (way * stopped_[c] < 0 ? 0.2 : 1.0) * way / step;
  }

  std::shared_ptr<const robot_model> model_;
  tree_inertia inertia_;
  bool exist_ = false;
  moving_frame base_;
  std::vector<vector6> moved_;
  std::vector<std::array<part, joint_forces>> soft_;  // over the coordinates
  std::vector<part> springs_;                         // between two points
  Eigen::MatrixXd rows_;                              // their slopes over the speeds, a column each
  Eigen::MatrixXd weights_;
  Eigen::VectorXd pushed_, motion_;  // of the base, if it floats; of the coordinates
  Eigen::LDLT<Eigen::MatrixXd> solver_;
  std::vector<int> stopped_;  // over the coordinates: -1 at the lower stop, 1 at the upper one
  std::vector<double> q_, dq_;
};

}  // namespace cca::sim
