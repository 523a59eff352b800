// Small descriptions with what real files have: placeholders, light and damped links, joints that follow
// others. In the simulator they are finite, stay within their stops, and rest where they are held, at any
// rate.
#include <cmath>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include <cca/sim/robot.hpp>

#include "../../laws/stable_robot_laws.hpp"

#include <written/inertia_2p6_percent_off.hpp>
#include <written/light_link_damped.hpp>
#include <written/mass_zero_with_inertia.hpp>
#include <written/mimic_limit_zero_velocity.hpp>
#include <written/mimic_no_limit.hpp>
#include <written/placeholder_on_camera.hpp>
#include <written/placeholder_on_fixed_base.hpp>
#include <written/series_gripper.hpp>
#include <written/velocity_zero.hpp>
#include <written/zero_box.hpp>

namespace {

template <class R>
void rests(std::string_view name) {
  for (const double hz : {50.0, 100.0, 250.0, 1000.0}) {
    CAPTURE(name);
    CAPTURE(hz);
    cca::sim::robot_model model = cca::sim::model_of<R>();
    model.beat = 1 / hz;
    const laws::rest free = laws::comes_to_rest(model);
    CHECK(free.trouble.empty());
    CHECK(free.beyond_stop < 0.02);
    // Where no weight pulls it, a held joint is in its place in the end.
    const double place = -0.2;
    const std::vector<cca::sim::joint_law> hold(model.drives.size(),
                                                {.position = place, .stiffness = 5, .damping = 1});
    const laws::rest held = laws::comes_to_rest(model, hold);
    CHECK(held.trouble.empty());
    CHECK(held.beyond_stop < 0.02);
    CHECK(held.speed < 1e-3);
    CHECK(held.chatter < 1e-3);
  }
}

}  // namespace

TEST_CASE("small robots are finite, within their stops, and rest where they are held") {
  rests<inertia_2p6_percent_off::description>("inertia_2p6_percent_off");
  rests<light_link_damped::description>("light_link_damped");
  rests<mass_zero_with_inertia::description>("mass_zero_with_inertia");
  rests<mimic_limit_zero_velocity::description>("mimic_limit_zero_velocity");
  rests<mimic_no_limit::description>("mimic_no_limit");
  rests<placeholder_on_camera::description>("placeholder_on_camera");
  rests<placeholder_on_fixed_base::description>("placeholder_on_fixed_base");
  rests<series_gripper::description>("series_gripper");
  rests<velocity_zero::description>("velocity_zero");
  rests<zero_box::description>("zero_box");
}
