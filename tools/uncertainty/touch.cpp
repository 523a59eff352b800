// How much uncertainty the arm that is guided, wipes and yields bears (sweep.hpp): its own bounds judge it.
// It runs on the Open Dynamics Engine only.
//
//   uncertainty_touch --seeds 4
#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/sim/uncertain/uncertain_robot.hpp>

#include "../../examples/touch/rollout.hpp"
#include "../../examples/touch/summary.hpp"
#include "sweep.hpp"

namespace {

struct arm : touch::architecture<cca::sim::robot<cca::robots::arm::description, cca::sim::uncertain<>>> {};

// In the room of the example, but with links and friction as drawn.
struct uncertain_place : touch::in_simulator {
  const uncertain::uncertainty& of;

  template <class Controller>
  void put_down(Controller& c, cca::sim::robot_world&& ideal) const {
    cca::sim::scene room = ideal.around();
    room.contact.friction = uncertain::ground_under(of, room.contact.friction).friction();
    c.template get<"robot.simulator">().put_down(
        cca::sim::robot_world(ideal.model(), room, cca::sim::drawn_settings(of)));
  }
};

int run(const uncertain::options& o) {
  cca::controller<arm> start;
  start.load();
  return uncertain::sweep(o, [&](const uncertain::uncertainty& u, std::uint64_t seed) {
    const auto c = std::make_unique<cca::controller<arm>>(start);
    c->set<"robot.simulator">(u);
    const touch::result r =
        touch::roll_out(*c, seed, [](const auto&, int) { return true; }, uncertain_place{{}, u});
    return uncertain::verdict{r.recovered(), touch::within(r)};
  });
}

}  // namespace

int main(int count, char** words) {
  uncertain::options o;
  o.engine = trot::engine::ode;
  cca::command_line line("how much uncertainty of each kind an arm bears that feels, on all cores");
  o.offer(line);
  return cca::run_program(count, words, line, [&] {
    if (o.engine != trot::engine::ode)
      throw cca::command_line_error(
          "--engine compiled: compiled physics has no table; leave out this option");
    return run(o);
  });
}
