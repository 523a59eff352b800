// Looks at a whole world for what can't be (plausible.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <cca/base/math/reductions.hpp>
#include <cca/sim/robot/model/body_state.hpp>
#include <cca/sim/robot/model/joint_law.hpp>
#include <cca/sim/robot/model/plausible.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

// The motion of one body; adds its kinetic energy to `energy`.
inline world_trouble look_at_body(
    dBodyID b, int name, const plausible_bounds& bounds, double step, double& energy) {
  const Eigen::Vector3d v = Eigen::Vector3d::Map(dBodyGetLinearVel(b)),
                        w = Eigen::Vector3d::Map(dBodyGetAngularVel(b)),
                        at = Eigen::Vector3d::Map(dBodyGetPosition(b));
  const double speed = math::norm(v), turning = math::norm(w), own = kinetic_energy(b);
  energy += own;
  if (!std::isfinite(speed + turning + math::sum(at) + own)) return {implausible::number, name};
  if (speed > bounds.speed) return {implausible::speed, name, speed, bounds.speed};
  if (turning * step > bounds.turn) return {implausible::turning, name, turning, bounds.turn / step};
  if (energy > bounds.energy) return {implausible::energy, name, energy, bounds.energy};
  return {};
}

// The first body that can't be right: the base, the links, the balls.
inline world_trouble look_at_bodies(const tree_in_engine& tree,
                                    const std::vector<dBodyID>& balls,
                                    const plausible_bounds& bounds,
                                    double step) {
  world_trouble found;
  double energy = 0;
  const auto judge = [&](dBodyID b, int name) {
    if (!found) found = look_at_body(b, name, bounds, step, energy);
  };
  if (tree.base()) judge(tree.base(), world_trouble::base);
  for (std::size_t i = 0; i < tree.links().size(); ++i)
    if (tree.links()[i]) judge(tree.links()[i], static_cast<int>(i));
  for (std::size_t i = 0; i < balls.size(); ++i)
    judge(balls[i], world_trouble::first_ball - static_cast<int>(i));
  return found;
}

// The first joint that is too far beyond a stop.
inline world_trouble look_at_stops(const robot_model& model,
                                   const tree_in_engine& tree,
                                   const std::vector<joint_reading>& joints,
                                   const plausible_bounds& bounds) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!tree.leads(i)) continue;
    const auto& l = model.links[i];
    const joint_stops& s = model.stops[static_cast<std::size_t>(l.coordinate)];
    if (!(stop_reach(l, s) > 0)) continue;
    const double angle = joints[static_cast<std::size_t>(l.coordinate)].angle;
    const double bound = l.kind == joint_kind::revolute ? bounds.stop : bounds.stop_way;
    const double beyond = std::abs(l.ratio) * std::max(angle - s.high, s.low - angle);
    if (beyond > bound) return {implausible::stop, static_cast<int>(i), beyond, bound};
  }
  return {};
}

}  // namespace cca::sim
