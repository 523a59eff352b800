// The Combination of Skills of examples/combination_of_skills on a page: the robot trots, stops, reaches for
// a ball, is pushed, and trots on.
#include <cca/cca.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "any_engine.hpp"

#include "live_graph.hpp"
#include "oncilla_scene.hpp"

namespace {

struct watched_skills : skills::architecture<cca::sim::compiled_oncilla>, cca::recordable {};
using combined = cca::controller<watched_skills>;

// The referee shows the ball to the camera and pushes, as in the program. It ends a run, but not the page's.
struct scene : cca::page::oncilla_scene {
  static constexpr const char* title = "combination of skills";
  using plan = skills::plan;

  void put_down(combined& c) {
    if (!c.get<"dmp.module">().p.files.load.assign("trot.shape"))
      throw cca::refused("trot.shape: this name is too long");
    skills::simulated_stage<combined> stage{c};
    run = skills::noted_run(skills::circumstances{});
    run.begin(stage);
  }
  void after_beat(combined& c) {
    skills::simulated_stage<combined> stage{c};
    run.note(stage);
  }
  void add_shapes(cca::page::json_text& json) { add_shapes_of(json, cca::sim::oncilla_defaults); }
  void extra(const combined& c, double* to) { extra_of(c.get<"robot.simulator">().world(), to); }
  void poses(const combined& c, double* to) { poses_of(c.get<"robot.simulator">().world(), to); }
  void push(combined& c, double x, double y, double z, double seconds) {
    push_on(c.get<"robot.simulator">(), x, y, z, seconds);
  }

  skills::noted_run run{skills::circumstances{}};
};

}  // namespace

cca::page::live_program& cca::page::program() {
  static live_graph<watched_skills, scene> all_skills;
  return all_skills;
}
