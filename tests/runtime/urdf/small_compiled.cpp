// The same small descriptions in compiled physics: at each rate they are finite, within their stops, at rest
// where they are held, and there where the engine's robot is.
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

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

namespace sim = cca::sim;

// The rate is part of a description's type. A held drive asks for the same in each beat, so a beat of 20 ms
// has the steps of another rate where it is divided into more of them: two a beat is the default.
template <class R>
struct slow : R {
  using rate = cca::rate<50>;
};
constexpr int slowest = 50;

template <class R>
laws::rest held(int hz, bool compiled) {
  const sim::robot_model model = sim::model_of<slow<R>>();
  const std::vector<sim::joint_law> hold(model.drives.size(),
                                         {.position = -0.2, .stiffness = 5, .damping = 1});
  sim::robot_world_settings steps;
  steps.steps_per_beat = steps.steps_per_beat * hz / slowest;
  if (compiled) return laws::comes_to_rest_in(sim::compiled_world<slow<R>>(steps), hold);
  return laws::comes_to_rest(model, hold, 10, steps);
}

template <class R>
void rests(std::string_view name) {
  CAPTURE(name);
  for (const int hz : {50, 100, 500, 1000}) {
    CAPTURE(hz);
    const laws::rest here = held<R>(hz, true), engine = held<R>(hz, false);
    CHECK(here.trouble.empty());
    CHECK(here.beyond_stop < 0.02);
    CHECK(here.speed < 1e-9);
    CHECK(here.chatter < 1e-9);
    double apart = 0;
    for (std::size_t c = 0; c < here.pose.size(); ++c)
      apart = std::fmax(apart, std::abs(here.pose[c] - engine.pose[c]));
    CHECK(apart < 1e-9);
    MESSAGE(name, " at ", hz, " Hz: speed ", here.speed, " (engine ", engine.speed, "), beyond a stop ",
            here.beyond_stop, " (", engine.beyond_stop, "), poses apart ", apart);
  }
}

}  // namespace

TEST_CASE("small robots in compiled physics rest where they are held, as in the engine, at any rate") {
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
