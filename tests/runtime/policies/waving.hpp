// A graph with a policy, for `cca-policy contract --at`.
#pragma once

#include <tuple>

#include <cca/cca.hpp>
#include <cca/mapping/policy.hpp>

#include "robot.hpp"

namespace policies {

struct wave : cca::policy<cca::policy_inputs<cca::in<"joint_pos", angles>, cca::in<"base_ang_vel", gyro>>,
                          cca::hidden_layers<8>,
                          cca::hyperbolic_tangent,
                          targets> {};
struct arms {
  auto sense() -> std::tuple<cca::out<"angles", angles>, cca::out<"rates", gyro>> {
    return {Eigen::Vector4d::Zero().eval(), Eigen::Vector3d::Zero().eval()};
  }
  void act(cca::in<"targets", targets>) {}
};
struct inner : cca::graph<cca::node<"policy", wave, cca::timed<20>>,
                          cca::expose<"policy.joint_pos", "angles">,
                          cca::expose<"policy.base_ang_vel", "rates">,
                          cca::expose<"policy.output", "targets">> {};
struct waving : cca::graph<cca::rate<1000>,
                           cca::node<"arms", arms>,
                           cca::node<"brain", inner>,
                           cca::node<"limits", cca::limiter<targets>>,
                           cca::wire<"arms.angles", "brain.angles", cca::latest>,
                           cca::wire<"arms.rates", "brain.rates", cca::latest>,
                           cca::wire<"brain.targets", "limits.command">,
                           cca::wire<"limits.safe", "arms.targets", cca::latest>> {};

}  // namespace policies
