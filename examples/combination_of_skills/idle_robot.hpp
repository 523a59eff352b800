#pragma once
// A robot without a simulator, with the Oncilla's ports: its joints are at once at their commands.
#include <tuple>

#include <cca/cca.hpp>

namespace skills {

struct idle_robot {
  auto sense() -> std::tuple<cca::out<"angles", oncilla::leg_angles>,
                             cca::out<"abducted", oncilla::abduction_angles>,
                             cca::out<"orientation", oncilla::trunk_orientation>,
                             cca::out<"angular_velocity", oncilla::trunk_angular_velocity>,
                             cca::out<"contacts", oncilla::foot_contacts>> {
    return {legs, abduction, Eigen::Vector4d(0, 0, 0, 1), Eigen::Vector3d(0, 0, 0), contacts};
  }
  void act(cca::in<"command", oncilla::leg_angles> wanted,
           cca::in<"abduction", oncilla::abduction_angles> sideways,
           cca::in<"stiffness", oncilla::hip_stiffnesses> stiffness) {
    legs = wanted.vector();
    abduction = sideways.vector();
    hips = stiffness.vector();
  }

  oncilla::leg_angles::vector_type legs = oncilla::leg_angles::vector_type::Constant(1.0);
  oncilla::abduction_angles::vector_type abduction = oncilla::abduction_angles::vector_type::Zero();
  oncilla::hip_stiffnesses::vector_type hips = oncilla::hip_stiffnesses::vector_type::Zero();
  oncilla::foot_contacts::vector_type contacts =
      oncilla::foot_contacts::vector_type::Ones();  // a program may set them
};

}  // namespace skills
