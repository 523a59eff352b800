// An Oncilla's world: that of a described robot (robot/world/robot_world.hpp), put down in a posture on a
// terrain, with the questions that programs of an Oncilla ask, by leg: left front, right front, left hind,
// right hind (asked_by_leg.hpp).
//
//   cca::sim::world w(cca::sim::terrain::slope(0.1), cca::sim::standing_posture());
//   w.trunk_position(), w.foot(0).slip, w.fallen()
//
// A value, as every world. It has no state besides that of the robot's world.
#pragma once

#include <array>
#include <stdexcept>

#include <cca/sim/engine/terrain.hpp>
#include <cca/sim/oncilla/asked_by_leg.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

namespace cca::sim {

class world : public asked_by_leg<robot_world> {
public:
  explicit world(const terrain& ground = terrain::flat(),
                 const initial_posture& posture = {},
                 const robot_world_settings& settings = {})
      : asked_by_leg(robot_world(model_of<robots::oncilla::as_built>(), on(ground), settings)) {
    moving_frame base;
    base.where.at[2] = height_of(posture);
    base.velocity = Eigen::Vector3d::Map(posture.trunk_velocity.data());
    const auto q = angles_of(posture);
    place(q, decltype(q){}, base);
  }
  // The numbers are the robot's: to change them, change a robot_model.
  world(const oncilla_model& numbers, const terrain& ground, const initial_posture& posture = {})
      : world(ground, posture) {
    if (&numbers != &oncilla_defaults)
      throw std::invalid_argument(
          "cca::sim::world: other numbers than oncilla_defaults change nothing here; change a copy of "
          "cca::sim::model_of<cca::robots::oncilla::as_built>() and make a cca::sim::robot_world of it");
  }

  // Of a simulator that is not told where: it stands on flat ground.
  static world at_start() { return world(terrain::flat(), standing_posture()); }

  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a world always has a ground
  const terrain& ground_shape() const { return *around().ground; }
};

}  // namespace cca::sim
