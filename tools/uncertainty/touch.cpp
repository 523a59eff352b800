// How much uncertainty the arm that is guided, wipes and yields bears (sweep.hpp): its own bounds judge it.
//
//   uncertainty_touch --seeds 4 --engine compiled
#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/sim/compiled/robot.hpp>
#include <cca/sim/uncertain/uncertain_robot.hpp>

#include "../../examples/touch/rollout.hpp"
#include "../../examples/touch/summary.hpp"
#include "sweep.hpp"

namespace {

template <class World>
struct arm : touch::architecture<cca::sim::robot<cca::robots::arm::description, cca::sim::uncertain<World>>> {
};

// In the room of the example, but with links and friction as drawn.
struct uncertain_place : touch::in_simulator {
  const uncertain::uncertainty& of;

  template <class Controller, class World>
  void put_down(Controller& c, const World&) const {
    cca::sim::scene room = touch::scene::room();
    room.contact.friction = uncertain::ground_under(of, room.contact.friction).friction();
    c.template get<"robot.simulator">().put_down(
        touch::scene::arm_in_room<World>(room, cca::sim::drawn_settings(of)));
  }
};

template <class World>
int run(const uncertain::options& o) {
  cca::controller<arm<World>> start;
  start.load();
  return uncertain::sweep(o, [&](const uncertain::uncertainty& u, std::uint64_t seed) {
    const auto c = std::make_unique<cca::controller<arm<World>>>(start);
    c->template set<"robot.simulator">(u);
    const touch::result r =
        touch::roll_out(*c, seed, [](const auto&, int) { return true; }, uncertain_place{{}, u});
    return uncertain::verdict{r.recovered(), touch::within(r)};
  });
}

}  // namespace

int main(int count, char** words) {
  uncertain::options o;
  cca::command_line line("how much uncertainty of each kind an arm bears that feels, on all cores");
  o.offer(line);
  return cca::run_program(count, words, line, [&] {
    return o.engine == trot::engine::compiled ? run<cca::sim::compiled>(o) : run<cca::sim::robot_world>(o);
  });
}
