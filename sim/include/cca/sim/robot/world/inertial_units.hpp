// Computes what the inertial units of a simulated robot read in a beat (ideal_inertial_unit.hpp).
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <cca/sim/robot/model/ideal_inertial_unit.hpp>
#include <cca/sim/robot/model/robot_state.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

class inertial_units {
public:
  using vector = Eigen::Vector3d;

  inertial_units(std::shared_ptr<const robot_model> model, double gravity)
      : model_(std::move(model)), gravity_(gravity), speeds_(count(), vector::Zero()) {}

  std::size_t count() const { return model_->inertial_units.size(); }

  // A beat begins.
  void begin(const tree_in_engine& tree) {
    for (std::size_t i = 0; i < count(); ++i) speeds_[i] = tree.at(model_->inertial_units[i]).velocity;
  }

  // A beat has ended.
  void read(const tree_in_engine& tree, std::vector<inertial_reading>& readings) const {
    for (std::size_t i = 0; i < count(); ++i)
      readings[i] =
          inertial_reading_of(tree.at(model_->inertial_units[i]), speeds_[i], model_->beat, gravity_);
  }

private:
  std::shared_ptr<const robot_model> model_;
  double gravity_;              // m/s^2
  std::vector<vector> speeds_;  // at the beginning of the beat, m/s
};

}  // namespace cca::sim
