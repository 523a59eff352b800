#pragma once
// A robot that does nothing: the Oncilla's ports without a simulator. Its joints are where they were
// commanded to.
#include <tuple>

#include <cca/cca.hpp>
#include <cca/sim/oncilla_spaces.hpp>

namespace skills {

struct idle_robot {
  auto sense() -> std::tuple<cca::out<"angles", cca::sim::leg_angles>,
                             cca::out<"abducted", cca::sim::abduction_angles>,
                             cca::out<"orientation", cca::sim::trunk_orientation>,
                             cca::out<"angular_velocity", cca::sim::trunk_angular_velocity>,
                             cca::out<"contacts", cca::sim::foot_contacts>> {
    return {legs, abduction, Eigen::Vector4d(0, 0, 0, 1), Eigen::Vector3d(0, 0, 0), contacts};
  }
  void act(cca::in<"command", cca::sim::leg_angles> wanted,
           cca::in<"abduction", cca::sim::abduction_angles> sideways,
           cca::in<"stiffness", cca::sim::hip_stiffnesses> stiffness) {
    legs = wanted.vector();
    abduction = sideways.vector();
    hips = stiffness.vector();
  }

  cca::sim::leg_angles::vector_type legs = cca::sim::leg_angles::vector_type::Constant(1.0);
  cca::sim::abduction_angles::vector_type abduction = cca::sim::abduction_angles::vector_type::Zero();
  cca::sim::hip_stiffnesses::vector_type hips = cca::sim::hip_stiffnesses::vector_type::Zero();
  cca::sim::foot_contacts::vector_type contacts =
      cca::sim::foot_contacts::vector_type::Ones();  // for a program to set
};

}  // namespace skills
