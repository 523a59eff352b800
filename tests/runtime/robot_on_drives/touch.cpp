// The architecture of examples/touch with the arm on virtual drives: it is led by hand, repeats the movement,
// wipes the table, yields and is stopped, within the bounds of the arm in the simulator.
#include <memory>

#include <doctest/doctest.h>

#include <cca/sim/compiled/plant.hpp>

#include "../../../examples/touch/on_drives.hpp"

namespace {

template <class Architecture, class Place>
void check() {
  const auto c = std::make_unique<cca::controller<Architecture>>();
  const auto place = std::make_unique<Place>(*c);
  c->load();
  const auto r = touch::roll_out(*c, 0, [](auto&, int) { return true; }, *place);
  const auto& stop = c->template get<"robot.emergency_stop">();
  CHECK(stop.first_cause().rule == cca::hardware::safety_rule::none);
  CHECK(c->template get<"recorder">().movement().size() > 500);
  CHECK(1000 * r.path_error < 5);
  CHECK(1000 * r.goal_error < 2);
  CHECK(r.force_error < 1.5);
  CHECK(r.max_force < 40);
  CHECK(r.energy_created < 1e-3);
  CHECK(r.recovered());
}

}  // namespace

TEST_SUITE("touch on drives") {
  TEST_CASE("CANopen drives in torque mode: the whole run, within all bounds") {
    check<touch::with_canopen, touch::behind_canopen>();
  }
  TEST_CASE("the same in compiled physics") {
    check<touch::with_canopen, touch::on_virtual_drives<touch::on_canopen::robot<cca::hardware::virtual_bus_end>,
                                                        cca::sim::compiled>>();
  }
  TEST_CASE("moteus: the whole run, within all bounds") { check<touch::with_moteus, touch::behind_moteus>(); }
}
