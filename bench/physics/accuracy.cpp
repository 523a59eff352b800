// How exact both engines are where a formula, the library or rest says what is right: steps of 0.5 ms.
//
//   physics_accuracy
#define DOCTEST_CONFIG_DISABLE  // helpers of the tests are used, no test
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <cca/sim/robot/world/robot_world.hpp>

#include <body/bodies.hpp>
#include <body/recorded_bodies.hpp>
#include <compiled_world/accelerations.hpp>
#include <compiled_world/flights.hpp>

#include "figures.hpp"
#include "resting.hpp"

namespace bench {

using namespace compiled_test;

void accelerations() {
  const std::array all{worst_acceleration<limp_arm>(),
                       worst_acceleration<flying_oncilla>(),
                       worst_acceleration<alone<body_test::hound, true>>(),
                       worst_acceleration<alone<body_test::star_of_arms, true>>(),
                       worst_acceleration<alone<body_test::random_tree_body, true>>(),
                       worst_acceleration<alone<body_test::humanoid, true>>()};
  figure("accelerations", *std::max_element(all.begin(), all.end()));
}

template <class R>
sim::robot_world thrown_in_engine(int steps) {
  sim::robot_world_settings s;
  s.steps_per_beat = steps;
  sim::robot_world w(sim::model_of<R>(), {}, s);
  const throwing<R> t = random_throw<R>();
  sim::moving_frame base;
  base.where = cca::rigid{} * t.place, base.angular_velocity = t.turning, base.velocity = t.velocity;
  w.place(t.q, t.dq, base);
  return w;
}
void free_flight() {
  for (const auto& [steps, name] : {std::pair{2, "flight"}, {4, "flight, half the step"}}) {
    figure((std::string("compiled ") + name).c_str(),
           largest_change_of_energy(thrown<flying_oncilla>(steps)));
    figure((std::string("ode ") + name).c_str(),
           largest_change_of_energy(thrown_in_engine<flying_oncilla>(steps)));
  }
}

void disc_on_a_free_base() {
  const auto show = [](const std::string& engine, const nutation& n) {
    figure((engine + " nutation").c_str(), n.error);
    figure((engine + " nutation, rate").c_str(), n.error_of_rate);
  };
  show("compiled", nutation_of(spinning_disc()));
  sim::robot_world e(sim::model_of<disc>(), {}, weightless());
  sim::moving_frame base;
  base.angular_velocity = {spin_of_disc::nod, 0, 0};
  e.place(std::array{0.0}, std::array{spin_of_disc::speed}, base);
  show("ode", nutation_of(std::move(e)));
}

}  // namespace bench

int main() {
  bench::accelerations();
  bench::free_flight();
  bench::disc_on_a_free_base();
  bench::standing_load();
  bench::block_on_a_slope();
}
