// Computes what the inertial units of a simulated robot read in a beat. They are ideal: without noise, bias
// or delay.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <cca/sim/robot/model/robot_state.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

class inertial_units {
public:
  using vector = Eigen::Vector3d;

  inertial_units(std::shared_ptr<const robot_model> model, double gravity)
      : model_(std::move(model)), gravity_(0, 0, gravity), speeds_(count(), vector::Zero()) {}

  std::size_t count() const { return model_->inertial_units.size(); }

  // A beat begins.
  void begin(const tree_in_engine& tree) {
    for (std::size_t i = 0; i < count(); ++i) speeds_[i] = tree.at(model_->inertial_units[i]).velocity;
  }

  // A beat has ended.
  void read(const tree_in_engine& tree, std::vector<inertial_reading>& readings) const {
    for (std::size_t i = 0; i < count(); ++i) {
      const moving_frame now = tree.at(model_->inertial_units[i]);
      const Eigen::Matrix3d into_unit = now.where.turn.transpose();
      const vector acceleration = (now.velocity - speeds_[i]) / model_->beat;
      inertial_reading& r = readings[i];
      Eigen::Vector4d::Map(r.orientation.data()) = cca::detail::quaternion_of(now.where.turn);
      vector::Map(r.angular_velocity.data()) = into_unit * now.angular_velocity;
      vector::Map(r.specific_force.data()) = into_unit * (acceleration + gravity_);
    }
  }

private:
  std::shared_ptr<const robot_model> model_;
  vector gravity_;              // what the ground would push back with, m/s^2
  std::vector<vector> speeds_;  // at the beginning of the beat, m/s
};

}  // namespace cca::sim
