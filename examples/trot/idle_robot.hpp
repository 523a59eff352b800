#pragma once
// A robot that does nothing: the Oncilla's ports without a simulator, to see what the controller alone costs.
#include <tuple>

#include <cca/cca.hpp>
#include <cca/sim/oncilla_spaces.hpp>

namespace trot {

struct idle_robot {
  auto sense() -> std::tuple<cca::out<"angles", cca::sim::leg_angles>,
                             cca::out<"orientation", cca::sim::trunk_orientation>> {
    return {command, Eigen::Vector4d(0, 0, 0, 1)};
  }
  void act(cca::in<"command", cca::sim::leg_angles> wanted) { command = wanted.vector(); }

  cca::sim::leg_angles::vector_type command = cca::sim::leg_angles::vector_type::Constant(1.0);
};

}  // namespace trot
