// The architecture of examples/touch with the arm on virtual drives: it is led by hand, learns the movement and
// repeats it.
#include <memory>

#include <doctest/doctest.h>

#include "../../../examples/touch/on_drives.hpp"

namespace {

template <class Architecture, class Place>
void check() {
  const auto c = std::make_unique<cca::controller<Architecture>>();
  const auto place = std::make_unique<Place>();
  c->load();
  const auto r = touch::roll_out(
      *c, 0, [](auto&, int step) { return step <= touch::plan::at<"repeat elsewhere">; }, *place);
  const auto& stop = c->template get<"robot.emergency_stop">();
  CHECK(stop.mode() == cca::hardware::motion_mode::run);
  CHECK(stop.first_cause().rule == cca::hardware::safety_rule::none);
  CHECK(r.last_step > touch::plan::at<"repeat elsewhere">);
  CHECK(c->template get<"recorder">().movement().size() > 500);
  CHECK(1000 * r.path_error < 5);
  CHECK(1000 * r.goal_error < 2);
  CHECK(r.energy_created < 1e-3);
}

}  // namespace

TEST_SUITE("touch on drives") {
  TEST_CASE("CANopen drives in torque mode: led by hand, and repeated within 5 mm") {
    check<touch::with_canopen, touch::behind_canopen>();
  }
  TEST_CASE("moteus: led by hand, and repeated within 5 mm") {
    check<touch::with_moteus, touch::behind_moteus>();
  }
}
