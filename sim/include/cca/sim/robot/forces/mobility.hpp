// Which soft forces (soft_force.hpp) a step can take explicitly, and which not.
//
// A force of resistance R that acts on what a force moves with the mobility w (speed per N m s) is explicit
// in a step h if h w R is small; together, if all eigenvalues of h W R are below 2. W has the mobilities of
// all coordinates and springs, from the inertia of the robot in its posture. Each sum over a row of h |W| R,
// scaled by the square roots of the diagonal, bounds them: while one is above 1, the force that has the
// largest share in it is taken at the end of the step. What remains is explicit, and costs and does what it
// always did; so every robot is stable, and a soft one is not slowed down.
//
// W is looked up in each beat, but not where the forces are soft enough for every posture: then a bound of it
// is enough. Sources: the bounds are Gershgorin's. Cost: nothing for soft robots; else an inversion of the
// inertia in each beat. Nothing allocates after it was made.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/robots/crossing.hpp>
#include <cca/sim/robot/forces/tree_inertia.hpp>

namespace cca::sim {

class mobility {
public:
  // Of coordinates, then of springs.
  explicit mobility(const std::shared_ptr<const robot_model>& model)
      : model_(model),
        inertia_(model),
        coordinates_(static_cast<Eigen::Index>(model->drives.size())),
        solver_(inertia_.size()) {
    const Eigen::Index count = coordinates_ + static_cast<Eigen::Index>(model->line_springs.size());
    slopes_.setZero(inertia_.size(), count);
    if (coordinates_ > 0) slopes_.middleRows(inertia_.first(), coordinates_).setIdentity();
    now_.setZero(count, count);
    most_.setZero(count);
    levers_.assign(model_->line_springs.size(), std::vector<double>(model_->drives.size(), 0));
    turns_.assign(model_->drives.size(), 0);
    for (const auto& l : model_->links)
      if (l.kind == joint_kind::revolute) turns_[static_cast<std::size_t>(l.coordinate)] = 1;
    bound();
  }

  std::size_t count() const { return static_cast<std::size_t>(now_.rows()); }
  double of(std::size_t i) const { return now_(place(i), place(i)); }

  // A beat begins. `resistances` are those of its forces, one for each coordinate or spring.
  void look_at(const tree_in_engine& tree, const std::vector<double>& resistances, double step) {
    double sum = 0;
    for (std::size_t i = 0; i < count(); ++i) sum += step * most_[place(i)] * resistances[i];
    is_soft_ = sum <= 1 && model_->line_springs.empty();
    if (is_soft_) now_.diagonal() = most_;
    else find(tree);
  }

  // Adds to `resistances`, over the coordinates, what a spring that pulls in a line resists when that line
  // turns: force times the second derivatives of its length, which levers and length bound.
  void add_turning(std::size_t spring,
                   double length,
                   double tension,
                   double step,
                   std::vector<double>& resistances) const {
    const auto& of = levers_[spring];
    for (std::size_t c = 0; c < of.size(); ++c)
      for (std::size_t k = 0; k < of.size(); ++k) {
        if (of[c] == 0 || of[k] == 0) continue;
        const double bend = turns_[c] && turns_[k] ? std::min(of[c], of[k]) : turns_[c] || turns_[k] ? 1 : 0;
        resistances[c] += step * std::abs(tension) * (bend + of[c] * of[k] / length);
      }
  }

  // Marks the forces that are to be taken at the end of a step. Several can act on one place: `force(k)` has
  // the place and the resistance of each.
  template <class Forces>
  void choose(const Forces& forces, std::vector<char>& stiff, double step) {
    std::fill(stiff.begin(), stiff.end(), 0);
    if (is_soft_) return;
    for (std::size_t k = 0; k < stiff.size(); ++k) {
      const auto [row, sum] = worst_row(forces, stiff, step);
      if (sum <= 1) return;
      std::size_t largest = 0;
      double share = -1;
      for (std::size_t i = 0; i < stiff.size(); ++i) {
        const double here = stiff[i] ? -1 : share_of(forces[i], row, step);
        if (here > share) largest = i, share = here;
      }
      stiff[largest] = 1;
    }
  }

  struct force {
    std::size_t at;
    double resistance;
  };

private:
  static Eigen::Index place(std::size_t i) { return static_cast<Eigen::Index>(i); }

  double share_of(const force& f, std::size_t row, double step) const {
    const double own = now_(place(f.at), place(f.at)), of_row = now_(place(row), place(row));
    const double scaled = std::abs(now_(place(row), place(f.at))) * math::sqrt(own / of_row);
    return step * scaled * f.resistance;
  }

  template <class Forces>
  std::pair<std::size_t, double> worst_row(const Forces& forces,
                                           const std::vector<char>& stiff,
                                           double step) const {
    std::pair<std::size_t, double> worst{0, 0};
    for (std::size_t k = 0; k < stiff.size(); ++k) {
      if (stiff[k] || !(forces[k].resistance > 0)) continue;
      double sum = 0;
      for (std::size_t i = 0; i < stiff.size(); ++i)
        if (!stiff[i] && forces[i].resistance > 0) sum += share_of(forces[i], forces[k].at, step);
      if (sum > worst.second) worst = {forces[k].at, sum};
    }
    return worst;
  }

  // The mobilities in the tree's posture.
  void find(const tree_in_engine& tree) {
    inertia_.look_at(tree);
    for (std::size_t i = 0; i < model_->line_springs.size(); ++i) {
      const placed_spring& s = model_->line_springs[i];
      const Eigen::Vector3d from = tree.at(s.from).where.at, to = tree.at(s.to).where.at;
      const double length = math::norm(to - from);
      auto row = slopes_.col(coordinates_ + place(i));
      row.setZero();
      if (!(length > 0)) continue;
      const Eigen::Vector3d along = (to - from) / length;
      inertia_.slope(s.to.link, to, along, 1, row);
      inertia_.slope(s.from.link, from, along, -1, row);
      for (std::size_t c = 0; c < levers_[i].size(); ++c)
        levers_[i][c] =
            math::norm(inertia_.speed_of(s.to.link, to, c) - inertia_.speed_of(s.from.link, from, c));
    }
    solver_.compute(inertia_.weights());
    half_ = slopes_;
    solver_.matrixL().solveInPlace(half_);
    now_.noalias() = half_.transpose() * half_;
  }

  // The links with a mass on both sides of a joint. Where joints cross, one of them turns against the axis.
  struct crossing {
    int above, below;
    bool turns_above = false, turns_below = false;
  };
  crossing crossing_at(const cca::detail::body_link& l) const {
    const auto own = static_cast<int>(&l - model_->links.data());
    crossing c{own, l.parent};
    if (!(l.inertia.mass > 0)) {
      c.above = robots::detail::crossing_after(model_->links, static_cast<std::size_t>(own));
      c.turns_above = true;
    }
    if (l.parent >= 0 && !(model_->links[static_cast<std::size_t>(l.parent)].inertia.mass > 0)) {
      c.below = model_->links[static_cast<std::size_t>(l.parent)].parent;
      c.turns_below = true;
    }
    return c;
  }

  // A bound for every posture: of the energy of all bodies only that of the two at a joint, and these free
  // otherwise. A slider moves the centre of its link along its axis, which changes no term here.
  void bound() {
    using cca::detail::as_vector, cca::detail::cross, cca::detail::matrix_of;
    for (const auto& l : model_->links) {
      const crossing at_joint = crossing_at(l);
      const bool has_parent = at_joint.below >= 0 || model_->floats;
      const link_inertia &above = model_->links[static_cast<std::size_t>(at_joint.above)].inertia,
                         &below = at_joint.below >= 0
                                      ? model_->links[static_cast<std::size_t>(at_joint.below)].inertia
                                      : model_->base;
      const Eigen::Matrix3d turn = Eigen::Map<const Eigen::Matrix3d>(l.turn.data()),
                            own = turn * matrix_of(above.about_centre) * turn.transpose();
      const Eigen::Vector3d axis = turn * as_vector(l.axis);
      const auto eased = [](const Eigen::Matrix3d& inertia, const Eigen::Vector3d& a, bool any_way = false) {
        if (any_way) return 1 / Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues()[0];
        return math::dot(a, inertia.llt().solve(a).eval());
      };
      double all =
          l.kind == joint_kind::revolute ? eased(own, axis, at_joint.turns_above) : 1 / l.inertia.mass;
      if (has_parent && l.kind == joint_kind::revolute)
        all += eased(matrix_of(below.about_centre), axis, at_joint.turns_below);
      if (has_parent && l.kind == joint_kind::prismatic) {
        const Eigen::Vector3d apart =
            as_vector(l.at) + turn * as_vector(l.inertia.centre) - as_vector(below.centre);
        all += 1 / below.mass + eased(own + matrix_of(below.about_centre), cross(apart, axis));
      }
      double& most = most_[l.coordinate];  // of several joints of a coordinate, each alone is a bound
      all /= l.ratio * l.ratio;
      most = most > 0 ? std::min(most, all) : all;
    }
  }

  std::shared_ptr<const robot_model> model_;
  tree_inertia inertia_;
  Eigen::Index coordinates_;
  Eigen::LLT<Eigen::MatrixXd> solver_;
  Eigen::MatrixXd slopes_, half_, now_;
  Eigen::VectorXd most_;                     // in any posture
  std::vector<std::vector<double>> levers_;  // of springs: how far their points move, for each coordinate
  std::vector<char> turns_;                  // over the coordinates
  bool is_soft_ = true;
};

}  // namespace cca::sim
