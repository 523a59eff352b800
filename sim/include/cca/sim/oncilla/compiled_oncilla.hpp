// The simulated Oncilla in compiled physics, as a graph to be used in any other:
// `cca::node<"robot", cca::sim::compiled_oncilla>`. Its ports and questions are those of cca::sim::oncilla
// (cca/sim/oncilla.hpp), so a program takes either; no engine is needed.
//
//   controller.get<"robot.simulator">().put_down(cca::sim::compiled_oncilla_world(ground, posture), pushes);
//
// Errors: as cca/sim/oncilla.hpp. Cost, and what is not in this physics: docs/physics.md.
#pragma once

#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/compiled/robot.hpp>
#include <cca/sim/oncilla/asked_by_leg.hpp>
#include <cca/sim/oncilla/disturbance.hpp>

namespace cca::sim {

// A trivially copyable value: world.hpp, compiled.
class compiled_oncilla_world : public asked_by_leg<compiled_world<robots::oncilla::as_built>> {
public:
  explicit compiled_oncilla_world(const terrain& ground = terrain::flat(),
                                  const initial_posture& posture = {},
                                  const robot_world_settings& settings = {})
      : asked_by_leg(compiled_world<robots::oncilla::as_built>(on(ground), settings)) {
    place(angles_of(posture), {}, at(0, 0, height_of(posture)), {}, posture.trunk_velocity);
  }

  static compiled_oncilla_world at_start() {
    return compiled_oncilla_world(terrain::flat(), standing_posture());
  }
};

struct compiled_oncilla : robot<robots::oncilla::as_built, compiled_oncilla_world> {};

}  // namespace cca::sim
