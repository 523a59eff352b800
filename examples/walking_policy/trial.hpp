#pragma once
// The circumstances of a run of the training: what is commanded, the disturbance, and how far robot and
// ground are from their description. Each trial has a number of its own, and all is drawn from it, so a judge
// that takes other numbers has other trials.
#include <cstdint>

#include <cca/cca.hpp>
#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/uncertain/uncertain_robot.hpp>

#include "rollout.hpp"
#include "way.hpp"

namespace walking {

// An Oncilla that is not ideal, in this world.
template <class World>
struct uncertain_oncilla : cca::sim::robot<cca::robots::oncilla::as_built, cca::sim::uncertain<World>> {};

// A training with the seed n takes the numbers from n times this on; those below are left to a judge.
inline constexpr std::uint64_t first_of_training = 1'000'000;

struct trial {
  std::uint64_t number = 0;
  command wanted{};
  cca::sim::uncertainty uncertain{};
};

// A third of all trials goes straight on. `share`: from a robot as described, 0, to the most uncertain one.
inline trial drawn_trial(std::uint64_t number) {
  cca::sim::uniform_numbers draw(number * 104729 + 7);
  trial t;
  t.number = number;
  t.wanted.speed = draw.between(0.15, 0.7);
  t.wanted.turn = draw.between(-0.55, 0.55);
  if (number % 3 == 0) t.wanted.turn = 0;
  const double share = draw.between(0, 1);
  cca::sim::uncertainty& u = t.uncertain;
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
  return t;
}

// A run of a loaded controller whose robot is uncertain.
template <class Controller, class Between>
trot::recording attempt(Controller& c,
                        const trial& t,
                        double seconds,
                        Between between,
                        const cca::sim::terrain& like = cca::sim::terrain::flat()) {
  command_walk(c, t.wanted);
  c.template set<"robot.simulator">(t.uncertain);
  auto disturbance = cca::sim::disturbance::from_seed(t.number, seconds);
  const auto ground = cca::sim::drawn_ground(t.uncertain, like.with_friction(disturbance.friction));
  disturbance.friction = ground.friction();  // roll_out takes it from there
  return roll_out(c, ground, disturbance, seconds, between, cca::sim::drawn_settings(t.uncertain));
}

}  // namespace walking
