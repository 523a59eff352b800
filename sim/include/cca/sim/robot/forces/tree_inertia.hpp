// The inertia of a robot's coordinates in its present posture, from the Jacobians of its bodies.
//
//   tree_inertia now(model);
//   now.look_at(tree);
//   now.weights()     (coordinates, + 6 in front if the base floats)^2, kg m^2 and the like
//   now.jacobian(i)   of the centre of mass of link i (-1: the base): angular, then linear
//
// The columns of a base that floats are its angular, then its linear velocity in the world. Joints that
// follow others are part of their coordinate. Cost: for each link, the square of the coordinates that move
// it. Nothing allocates after it was made.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <cca/base/math/reductions.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

class tree_inertia {
public:
  using vector = Eigen::Vector3d;

  explicit tree_inertia(std::shared_ptr<const robot_model> model)
      : model_(std::move(model)), first_(model_->floats ? 6 : 0) {
    jacobians_.assign(slots(), Eigen::MatrixXd::Zero(6, size()));
    inertias_.assign(slots(), Eigen::Matrix3d::Zero());
    origins_.assign(slots(), vector::Zero());
    centres_.assign(slots(), vector::Zero());
    weights_.setZero(size(), size());
    columns_.resize(slots());
    for (Eigen::Index k = 0; k < first_; ++k) columns_[slot(-1)].push_back(k);
    for (int i = 0; i < links(); ++i) {
      const auto& l = model_->links[static_cast<std::size_t>(i)];
      auto& own = columns_[slot(i)] = columns_[slot(l.parent)];
      const Eigen::Index column = first_ + l.coordinate;
      if (std::find(own.begin(), own.end(), column) == own.end()) own.push_back(column);
    }
  }

  // Of the first coordinate.
  Eigen::Index first() const { return first_; }
  Eigen::Index size() const { return first_ + static_cast<Eigen::Index>(model_->drives.size()); }
  int links() const { return static_cast<int>(model_->links.size()); }
  // The first body that moves: -1 is the base.
  int begin() const { return first_ > 0 ? -1 : 0; }

  const Eigen::MatrixXd& weights() const { return weights_; }
  const Eigen::MatrixXd& jacobian(int link) const { return jacobians_[slot(link)]; }
  const Eigen::Matrix3d& rotational(int link) const { return inertias_[slot(link)]; }  // in the world
  double mass(int link) const { return inertia_of(link).mass; }
  const vector& centre(int link) const { return centres_[slot(link)]; }

  // The velocity of a point of a link for a speed of 1 of a coordinate.
  vector speed_of(int link, const vector& at, std::size_t c) const {
    const auto column = jacobian(link).col(first_ + static_cast<Eigen::Index>(c));
    return column.tail<3>() + cca::detail::cross(vector(column.head<3>()), vector(at - centre(link)));
  }
  // How fast a point of a link moves along a direction, for each of the speeds.
  template <class Row>
  void slope(int link, const vector& at, const vector& along, double sign, Row&& row) const {
    const Eigen::MatrixXd& j = jacobian(link);
    const vector turning = cca::detail::cross(at - centre(link), along);
    for (Eigen::Index k = 0; k < j.cols(); ++k)
      row[k] += sign * (math::dot(j.col(k).head<3>(), turning) + math::dot(j.col(k).tail<3>(), along));
  }

  void look_at(const tree_in_engine& tree) {
    Eigen::MatrixXd& root = jacobians_[slot(-1)];
    root.setZero();
    if (first_ > 0) root.leftCols<6>().setIdentity();
    origins_[slot(-1)] = tree.frame(-1).where.at;
    for (int i = 0; i < links(); ++i) {
      const auto& l = model_->links[static_cast<std::size_t>(i)];
      const rigid f = tree.frame(i).where;
      origins_[slot(i)] = f.at;
      Eigen::MatrixXd& j = jacobians_[slot(i)];
      j = jacobians_[slot(l.parent)];
      shift(i, f.at - origins_[slot(l.parent)]);
      const vector axis = l.ratio * (f.turn * cca::detail::as_vector(l.axis));
      auto column = j.col(first_ + l.coordinate);
      if (l.kind == joint_kind::revolute) column.head<3>() += axis;
      else column.tail<3>() += axis;
    }
    for (int i = -1; i < links(); ++i) {
      const rigid f = tree.frame(i).where;
      const vector arm = f.turn * cca::detail::as_vector(inertia_of(i).centre);
      centres_[slot(i)] = f.at + arm;
      shift(i, arm);
    }
    weigh(tree);
  }

private:
  // Link -1 is the base and has slot 0.
  static std::size_t slot(int link) { return static_cast<std::size_t>(link + std::ptrdiff_t{1}); }
  std::size_t slots() const { return model_->links.size() + 1; }
  const link_inertia& inertia_of(int link) const {
    return link < 0 ? model_->base : model_->links[static_cast<std::size_t>(link)].inertia;
  }

  void shift(int link, const vector& by) {
    Eigen::MatrixXd& j = jacobians_[slot(link)];
    for (const Eigen::Index k : columns_[slot(link)])
      j.col(k).tail<3>() += cca::detail::cross(vector(j.col(k).head<3>()), by);
  }

  void weigh(const tree_in_engine& tree) {
    weights_.setZero();
    for (int i = begin(); i < links(); ++i) {
      const Eigen::Matrix3d turn = tree.frame(i).where.turn;
      const Eigen::Matrix3d& w = inertias_[slot(i)] =
          turn * cca::detail::matrix_of(inertia_of(i).about_centre) * turn.transpose();
      if (!(mass(i) > 0)) continue;
      const Eigen::MatrixXd& j = jacobians_[slot(i)];
      const auto& moving = columns_[slot(i)];
      for (const Eigen::Index a : moving) {
        const vector turned = w * j.col(a).head<3>(), moved = mass(i) * j.col(a).tail<3>();
        for (const Eigen::Index b : moving)
          weights_(b, a) += math::dot(turned, j.col(b).head<3>()) + math::dot(moved, j.col(b).tail<3>());
      }
    }
  }

  std::shared_ptr<const robot_model> model_;
  Eigen::Index first_;
  std::vector<std::vector<Eigen::Index>> columns_;  // of each body: those of the speeds that move it
  std::vector<Eigen::MatrixXd> jacobians_;
  std::vector<Eigen::Matrix3d> inertias_;
  std::vector<vector> origins_, centres_;
  Eigen::MatrixXd weights_;
};

}  // namespace cca::sim
