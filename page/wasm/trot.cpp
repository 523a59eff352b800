// The trot of examples/trot on a page: the same controller, the same compiled physics.
#include <cca/cca.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "any_engine.hpp"

#include "live_graph.hpp"
#include "oncilla_scene.hpp"

namespace {

struct watched_trot : trot::architecture<cca::sim::compiled_oncilla>, cca::recordable {};
using trotting = cca::controller<watched_trot>;

struct scene : cca::page::oncilla_scene {
  static constexpr const char* title = "trot";

  void put_down(trotting& c) {
    const auto none = cca::sim::disturbance::none();
    c.get<"robot.simulator">().put_down(
        cca::sim::compiled_oncilla_world(cca::sim::terrain::flat().with_friction(none.friction),
                                         trot::put_down(c.get<"gait">().p, none)),
        none);
  }
  void after_beat(trotting&) {}
  void add_shapes(cca::page::json_text& json) { add_shapes_of(json, cca::sim::oncilla_defaults); }
  void extra(const trotting& c, double* to) { extra_of(c.get<"robot.simulator">().world(), to); }
  void poses(const trotting& c, double* to) { poses_of(c.get<"robot.simulator">().world(), to); }
  void push(trotting& c, double x, double y, double z, double seconds) {
    push_on(c.get<"robot.simulator">(), x, y, z, seconds);
  }
};

}  // namespace

cca::page::live_program& cca::page::program() {
  static live_graph<watched_trot, scene> trot;
  return trot;
}
