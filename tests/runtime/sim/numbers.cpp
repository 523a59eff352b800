// The table of docs/simulator.md has every number of the model, with the model's value.
#include <cstdio>
#include <fstream>
#include <map>
#include <string>

#include <doctest/doctest.h>

#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/robot/world/robot_world.hpp>
#include <cca/sim/oncilla/oncilla_model.hpp>

namespace {

namespace sim = cca::sim;
constexpr const sim::oncilla_model& m = sim::oncilla_defaults;
using built = cca::robots::oncilla::as_built;
const sim::robot_world_settings settings{};
const sim::engine_settings& engine = settings.engine;
const sim::contact_numbers contact{};

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
  char all[200];
  std::snprintf(all, sizeof all, format, numbers...);
  return all;
}
constexpr double mm(double length) { return 1000 * length; }
constexpr double deg(double angle) { return angle / sim::degrees(1); }

// The values on the page, from its table.
std::map<std::string, std::string> on_page() {
  std::ifstream page(CCA_DOCS "/simulator.md");
  std::map<std::string, std::string> rows;
  std::string line;
  for (bool inside = false; std::getline(page, line);) {
    if (line.starts_with("## ")) inside = line == "## Every number";
    if (!inside || !line.starts_with("| ") || line.starts_with("| what")) continue;
    const auto first = line.find(" | "), second = line.find(" | ", first + 3);
    const std::string what = line.substr(2, first - 2), chosen = line.substr(second + 3);
    rows[what] = line.substr(first + 3, second - first - 3);
    CHECK_MESSAGE((chosen.starts_with("chosen") || chosen.starts_with("published") || what == "gravity"),
                  what);
  }
  return rows;
}

}  // namespace

TEST_CASE("the table of all numbers on the page agrees with the model") {
  const std::map<std::string, std::string> of_model{
      {"total mass", text("%g kg", m.mass())},
      {"hip height, standing", "0.16 to 0.18 m"},  // tests/runtime/sim/world.cpp
      {"trunk: box", text("%g × %g × %g mm", mm(m.trunk_length), mm(m.trunk_width), mm(m.trunk_height))},
      {"trunk: mass, with the servos", text("%g kg", m.trunk_mass)},
      {"trunk: centre above the hips, ahead of their middle",
       text("%g mm, %g", mm(m.trunk_above_hips), mm(m.trunk_forward_of_hips))},
      {"hips: half distance front to hind, left to right", text("%g mm, %g mm", mm(m.hip_x), mm(m.hip_y))},
      {"upper, middle, lower segment",
       text("%g, %g, %g mm", mm(m.upper_length), mm(m.middle_length), mm(m.lower_length))},
      {"toe joint to centre of the foot", text("%g mm", mm(m.toe_length))},
      {"foot, knee, ankle: radius of the spheres that touch the ground",
       text("%g, %g, %g mm", mm(m.foot_radius), mm(m.knee_radius), mm(m.ankle_radius))},
      {"masses of upper, middle, lower segment, toe",
       text("%.2f, %.2f, %.2f, %.2f kg", m.upper_mass, m.middle_mass, m.lower_mass, m.toe_mass)},
      {"radius of the segments (for their inertia)", text("%g mm", mm(m.segment_radius))},
      {"hip range (of targets)", text("−%g to %g rad", -m.hip_range.low, m.hip_range.high)},
      {"knee range (stops)", text("%g° to %g°", deg(m.knee_range.low), deg(m.knee_range.high))},
      {"abduction range (of targets)", text("±%g°", deg(m.abduction_range.high))},
      {"toe range (stops)", text("±%g rad", m.toe_range.high)},
      {"knee friction", text("%g N m s/rad", m.joint_friction)},
      {"diagonal spring: rate", text("%g N/m", m.spring_rate)},
      {"diagonal spring: short arm", text("%g mm", mm(m.spring_arm))},
      {text("diagonal spring: stretch at %g°", deg(m.spring_reference)),
       text("−%g mm (slack below 83°)", -mm(m.spring_preload))},
      {"toe spring, its damping", text("%g N m/rad, %g N m s/rad", m.toe_stiffness, m.toe_damping)},
      {"hip motor", text("%g N m, %g rad/s", m.hip_motor.torque, m.hip_motor.no_load_speed)},
      {"knee motor", text("%g N m, %g rad/s", m.knee_motor.torque, m.knee_motor.no_load_speed)},
      {"abduction servo",
       text("%g N m, %g rad/s", m.abduction_motor.torque, m.abduction_motor.no_load_speed)},
      {"hip stiffness; damping / stiffness",
       text("%g N m/rad (at most %g); %g ms", built::hip.stiffness, m.stiffest_hip,
            1000 * built::hip.damping / built::hip.stiffness)},
      {"hip: fastest target that is fed forward", text("%g rad/s", m.hip_motor.no_load_speed)},
      {"cable: stiffness, damping",
       text("%g N m/rad, %g N m s/rad", built::knee.cable.stiffness, built::knee.cable.damping)},
      {"abduction: stiffness, damping",
       text("%g N m/rad, %g N m s/rad", built::abduction.stiffness, built::abduction.damping)},
      {"contact: stiffness, damping", text("%g kN/m, %g N s/m", contact.stiffness / 1000, contact.damping)},
      {"contact: surface layer, correcting speed",
       text("%g mm, %g m/s", mm(engine.surface_layer), engine.correcting_speed)},
      {"gravity", text("%g m/s²", engine.gravity)},
      {"physics step, steps a beat",
       text("%g ms, %d", 1.0 / settings.steps_per_beat, settings.steps_per_beat)},
      {"CFM, ERP", "1e-9, 0.2"},
  };
  CHECK(engine.cfm == 1e-9);
  CHECK(engine.erp == 0.2);
  const auto found = on_page();
  CHECK(found.size() == of_model.size());
  for (const auto& [what, value] : found)
    CHECK_MESSAGE((of_model.contains(what) && of_model.at(what) == value), what, ": ", value);
  // A new number in the model needs a row on the page.
  CHECK(sizeof(sim::oncilla_model) == 42 * sizeof(double));
}
