// The torque loop below a policy: springs and dampers with the gains of its contract, at the robot's rate.
//
//   cca::policy_servo<walk::contract, leg_angles, leg_velocities, leg_torques>
//
//   in  "target"      angles' space      optional_in; may be slower than this loop (wire it with cca::latest)
//   in  "angles"      Angles     rad
//   in  "velocities"  Velocities rad/s
//   out "torques"     Torques    N m: stiffness (target - angle) - damping velocity
//
// Gains are matched by name with the axes; one that is missing does not compile (mapping.policy_numbers).
// Until a target has come, or while a number is not finite, torques only damp: zero where there is no
// velocity either. Source: the joint actuators that such policies are trained with (implicit or ideal PD).
#pragma once

#include <cca/mapping/imported/policy_gains_check.hpp>

namespace cca {

template <class Contract, Space Target, Space Angles, Space Velocities, Space Torques>
struct policy_servo {
  using gains = detail::gains_of<Contract, "joint_torques">;
  using checked = detail::policy_gains_check<Contract, Torques, Target, Angles, Velocities>;
  static_assert(detail::holds_or_tells<checked::holds, checked>::value);

  auto process(in<"target", Target> target,
               in<"angles", Angles> angles,
               in<"velocities", Velocities> velocities) -> out<"torques", Torques> {
    typename Torques::vector_type torques = Torques::vector_type::Zero();
    const bool moves = detail::has_come(velocities),
               holds = detail::has_come(target) && detail::has_come(angles);
    for (std::size_t i = 0; i < gains::numbers.size(); ++i) {
      const int at = detail::places_of<gains, Torques>[i];
      if (holds) torques[at] = Contract::gains[i].stiffness * (target.vector()[at] - angles.vector()[at]);
      if (moves) torques[at] -= Contract::gains[i].damping * velocities.vector()[at];
    }
    return torques;
  }
};

}  // namespace cca
