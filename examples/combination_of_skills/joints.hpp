#pragma once
// Converts joints from the robot's order (hips, then knees, of the four legs) to kinds (hips with their
// abduction; knees), and back.
#include <tuple>

#include <cca/cca.hpp>

#include "spaces.hpp"

namespace skills {

struct measured_joints {
  auto process(cca::in<"angles", oncilla::leg_angles> legs,
               cca::in<"abducted", oncilla::abduction_angles> abducted)
      -> std::tuple<cca::out<"hips", hip_angles>, cca::out<"knees", knee_angles>> {
    hip_angles::vector_type hips;
    hips << abducted.vector(), legs.vector().head<4>();
    return {hips, legs.vector().tail<4>().eval()};
  }
};

// The output of the Reaching Controllers: the angles around which the legs swing.
struct joint_goal {
  auto process(cca::in<"hips", hip_angles> hips, cca::in<"knees", knee_angles> knees)
      -> std::tuple<cca::out<"legs", oncilla::leg_angles>, cca::out<"abduction", oncilla::abduction_angles>> {
    oncilla::leg_angles::vector_type legs;
    legs << hips.vector().tail<4>(), knees.vector();
    return {legs, hips.vector().head<4>().eval()};
  }
};

}  // namespace skills
