// The compliant arm of examples/touch on a page: somebody shows it a movement, it finds a table and wipes it,
// and yields to pushes. The operator's stop is the user's.
#include <cca/cca.hpp>
#include <cca/sim/compiled/robot.hpp>

#include "any_engine.hpp"

#include "arm_scene.hpp"
#include "live_graph.hpp"

namespace {

using arm_world = cca::sim::compiled_world<touch::arm::description>;
struct watched_arm
    : touch::architecture<cca::sim::robot<touch::arm::description, cca::sim::compiled>>, cca::recordable {};
using touching = cca::controller<watched_arm>;

struct scene : cca::page::arm_scene {
  static constexpr const char* title = "touch";
  static constexpr std::array buttons{"operator's stop"};
  static constexpr std::array plots{cca::page::first_curve{0, "feel.force", 0},
                                    cca::page::first_curve{1, "leader.reference", 2},
                                    cca::page::first_curve{1, "flange.pose", 2}};
  using plan = touch::plan;

  // The goal of the second repetition is that of the run, unless somebody has set it.
  void put_down(touching& c) {
    const auto given = c.get<"orders">().p.shift;
    c.get<"robot.simulator">().put_down(touch::scene::arm_in_room<arm_world>());
    if (given == touch::orders().p.shift) c.get<"orders">().p.shift = run.around.shift;
  }
  void before_beat(touching& c) {
    if (world_of(c).time() > pulled_until) run.around.another.setZero();
    run.before_beat(c.get<"robot.simulator">().world());
  }
  void after_beat(touching& c) { run.after_beat(c); }
  void add_shapes(cca::page::json_text& json) {
    add_shapes_of(json, bodies, touch::scene::room(), "leader.reference");
  }
  void extra(const touching& c, double* to) { extra_of(world_of(c), to); }
  void poses(const touching& c, double* to) {
    poses_of(world_of(c), bodies, touch::scene::room().boxes.size(), touch::arm::description::tool_radius, to);
  }
  void push(touching& c, double x, double y, double z, double seconds) {
    run.around.another = {x, y, z};
    pulled_until = world_of(c).time() + seconds;
  }
  void press(touching& c, int, bool down) { c.get<"operator">().pressed = down; }
  bool is_pressed(const touching& c, int) { return c.get<"operator">().pressed; }

  static const arm_world& world_of(const touching& c) { return c.get<"robot.simulator">().world(); }

  touch::course run{0};
  double pulled_until = 0;
  std::vector<drawn_body> bodies = bodies_of(arm_world::model());
};

}  // namespace

cca::page::live_program& cca::page::program() {
  static live_graph<watched_arm, scene> arm;
  return arm;
}
