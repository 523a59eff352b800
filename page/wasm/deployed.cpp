// The Combination of Skills of examples/deployed on a page: drawn with its environments. Here they run as one
// loop, whose bits each of its other forms gives, too.
#include <cca/cca.hpp>

#include "architecture.hpp"

#include "live_graph.hpp"
#include "oncilla_scene.hpp"

namespace {

struct watched_split : deployed::split, cca::recordable {};
using played = cca::controller<watched_split>;

// The stage plays the whole run by itself: the ball, the pushes, the referee.
struct scene : cca::page::oncilla_scene {
  static constexpr const char* title = "deployed";
  using plan = skills::plan;

  void put_down(played& c) {
    if (!c.get<"dmp.module">().p.files.load.assign("trot.shape"))
      throw cca::refused("trot.shape: this name is too long");
    c.get<"robot.simulator">().set_scene({.where = skills::target::inside});
  }
  void after_beat(played&) {}
  void add_shapes(cca::page::json_text& json) { add_shapes_of(json, cca::sim::oncilla_defaults); }
  void extra(const played& c, double* to) { extra_of(c.get<"robot.simulator">().world(), to); }
  void poses(const played& c, double* to) { poses_of(c.get<"robot.simulator">().world(), to); }
  void push(played& c, double x, double y, double z, double seconds) {
    push_on(c.get<"robot.simulator">(), x, y, z, seconds);
  }
};

}  // namespace

cca::page::live_program& cca::page::program() {
  static live_graph<watched_split, scene> skills_in_environments;
  return skills_in_environments;
}
