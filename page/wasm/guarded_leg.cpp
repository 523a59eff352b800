// The leg of examples/recordings, whose guard stops it: a page without a robot in 3D, with a fault.
#include <cca/cca.hpp>

#include "leg.hpp"

#include "live_graph.hpp"

namespace {

// [page]
struct watched_leg : leg_loop<difference> {};  // which is recordable
using swinging = cca::controller<watched_leg>;

struct scene {
  static constexpr const char* title = "guarded leg";
  static constexpr int extra_count = 0, pose_count = 0;
  void put_down(swinging&) {}
  void after_beat(swinging&) {}
  void add_shapes(cca::page::json_text&) {}
  void extra(const swinging&, double*) {}
  void poses(const swinging&, double*) {}
  void push(swinging&, double, double, double, double) {}
};

}  // namespace

cca::page::live_program& cca::page::program() {
  static live_graph<watched_leg, scene> leg;
  return leg;
}
// [page end]
