#pragma once
// A robot that does nothing: the ports of the Oncilla that the trot uses, without a simulator. It measures
// the cost of the controller alone.
#include <tuple>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace trot {

struct idle_robot {
  auto sense() -> std::tuple<cca::out<"angles", oncilla::leg_angles>,
                             cca::out<"orientation", oncilla::trunk_orientation>> {
    return {command, Eigen::Vector4d(0, 0, 0, 1)};
  }
  void act(cca::in<"command", oncilla::leg_angles> wanted) { command = wanted.vector(); }

  oncilla::leg_angles::vector_type command = oncilla::leg_angles::vector_type::Constant(1.0);
};

}  // namespace trot
