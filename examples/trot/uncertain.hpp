#pragma once
// A robot and a ground that differ from their description, all kinds at once: those in which gaits are
// judged, searched and trained.
//
//   cca::controller<trot::uncertain_trot<cca::sim::world>> c;
//   c.load("trot.toml");
//   trot::on_drawn_ground(c, trot::drawn_uncertainty(7), cca::sim::disturbance::from_seed(7, 20), ground,
//                         [](auto& c, const auto& ground, const auto& disturbance, const auto& settings) {
//                           return trot::roll_out(c, ground, disturbance, 20, between, settings);
//                         });
//
// With nothing uncertain it is the robot as described, bit for bit.
#include <cstdint>

#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/uncertain/uncertain_robot.hpp>

#include "architecture.hpp"

namespace trot {

// An Oncilla that is not ideal, in this world.
template <class World>
struct uncertain_oncilla : cca::sim::robot<cca::robots::oncilla::as_built, cca::sim::uncertain<World>> {};
template <class World>
struct uncertain_trot : architecture<uncertain_oncilla<World>> {};

// `share`: from a robot as described, 0, to the most uncertain one, 1. `number` is the seed of what is drawn.
inline cca::sim::uncertainty uncertainty_of(std::uint64_t number, double share) {
  cca::sim::uncertainty u{};
  u.seed = static_cast<std::int64_t>(number);
  u.orientation.noise = 0.01 * share, u.orientation.bias = 0.015 * share;
  u.angular_velocity.noise = 0.1 * share, u.angular_velocity.bias = 0.02 * share;
  u.angle.noise = 0.003 * share, u.angle.bias = 0.015 * share;
  u.angle.delay = u.orientation.delay = u.angular_velocity.delay = 0.008 * share;
  u.drives.delay = 0.008 * share;
  u.drives.strength = 0.1 * share, u.drives.weakness = 0.1 * share;
  u.drives.backlash = 0.01 * share;
  u.drives.friction = 0.05 * share, u.drives.dry_friction = 0.1 * share;
  u.body.mass = 0.08 * share;
  u.ground.friction = 0.15 * share;
  return u;
}
// The share is drawn from the number, too.
inline cca::sim::uncertainty drawn_uncertainty(std::uint64_t number) {
  return uncertainty_of(number, cca::sim::uniform_numbers(number * 104729 + 7).between(0, 1));
}

// A run of a loaded controller whose robot is uncertain: rolled(controller, ground, disturbance, settings of
// the world), all as `u` and `disturbance` have drawn them; the ground is `like` this, but for its friction.
template <class Controller, class Rolled>
auto on_drawn_ground(Controller& c,
                     const cca::sim::uncertainty& u,
                     cca::sim::disturbance disturbance,
                     const cca::sim::terrain& like,
                     Rolled rolled) {
  c.template set<"robot.simulator">(u);
  const auto ground = cca::sim::drawn_ground(u, like.with_friction(disturbance.friction));
  disturbance.friction = ground.friction();  // a run takes it from there
  return rolled(c, ground, disturbance, cca::sim::drawn_settings(u));
}

}  // namespace trot
