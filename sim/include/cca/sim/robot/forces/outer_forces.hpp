// What pulls at the ends of a robot's parts and pushes its base, and what its force sensors feel of the
// contacts.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <cca/sim/robot/model/robot_state.hpp>
#include <cca/sim/engine/touching.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

// What is not finite is ignored.
inline void take_finite(std::array<double, 3>& kept, const Eigen::Vector3d& wanted) {
  for (std::size_t k = 0; k < 3; ++k)
    if (const double f = wanted[static_cast<Eigen::Index>(k)]; std::isfinite(f)) kept[k] = f;
}

// For the next step: on the centre of mass of the base, if it floats.
inline void push_base(const tree_in_engine& tree, const std::array<double, 3>& force) {
  if (tree.base()) dBodyAddForce(tree.base(), force[0], force[1], force[2]);
}

// For the next step.
inline void pull_at_ends(const robot_model& model,
                         const tree_in_engine& tree,
                         const std::vector<outer_load>& pulls) {
  for (std::size_t part = 0; part < pulls.size(); ++part) {
    const dBodyID b = tree.body_of(model.ends[part].link);
    const auto& [f, t] = pulls[part];
    if (!b || (f == std::array<double, 3>{} && t == f)) continue;
    const Eigen::Vector3d at = tree.at(model.ends[part]).where.at;
    dBodyAddForceAtPos(b, f[0], f[1], f[2], at[0], at[1], at[2]);
    dBodyAddTorque(b, t[0], t[1], t[2]);
  }
}

// Loads: at the place where the sensor was when the contact was found, up to one physics step. `share`: of
// the step in the beat.
inline void feel(
    const robot_model& model, const tree_in_engine& tree, const touch& t, double share, robot_state& state) {
  const auto [sensor, end] = std::pair(model.shapes[t.shape].sensor, model.shapes[t.shape].end);
  if (end >= 0)
    for (std::size_t k = 0; k < 3; ++k)
      state.end_forces[static_cast<std::size_t>(end)][k] += share * t.force[static_cast<Eigen::Index>(k)];
  if (sensor < 0) return;
  const rigid f = tree.at(model.sensors[static_cast<std::size_t>(sensor)]).where;
  const Eigen::Vector3d torque = f.turn.transpose() * cca::detail::cross(t.at - f.at, t.force),
                        force = f.turn.transpose() * t.force;
  auto& load = state.loads[static_cast<std::size_t>(sensor)];
  for (std::size_t k = 0; k < 3; ++k) {
    load[k] += share * torque[static_cast<Eigen::Index>(k)];
    load[3 + k] += share * force[static_cast<Eigen::Index>(k)];
  }
}

}  // namespace cca::sim
