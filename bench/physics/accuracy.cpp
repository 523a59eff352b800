// How exact both engines are where a formula, the library or rest says what is right: steps of 0.5 ms.
//
//   physics_accuracy
#define DOCTEST_CONFIG_DISABLE  // helpers of the tests are used, no test
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
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

// A disc that spins on a free base, and the axis of both nods: by the formula of a symmetric top.
struct hub_frame : cca::frame<"hub"> {};
struct disc_frame : cca::frame<"disc"> {};
struct spin : cca::dimension<"spin"> {};
struct disc_chain : cca::serial_chain<hub_frame, disc_frame, cca::axes<spin>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0, 0, 0);
  static constexpr std::array links{cca::link_inertia{1, {0, 0, 0}, {0.0025, 0.0025, 0.005}}};
};
struct disc_body : cca::body<hub_frame, cca::part<"disc", disc_chain>> {
  static constexpr cca::link_inertia base{2, {0, 0, 0}, {0.02, 0.02, 0.01}};
};
using disc = alone<disc_body, true>;

template <class World>
void nods(World w, const std::string& engine) {
  constexpr double across = 0.02 + 0.0025, turns = 0.005 * 500, nod = 2;  // kg m^2, N m s, rad/s
  // The momentum stays; the axis goes round it.
  const Eigen::Vector3d momentum(across * nod, 0, turns);
  const double angle = std::atan2(across * nod, turns), rate = momentum.norm() / across;
  double most = 0;
  for (int k = 0; k < 5000; ++k) w.advance(std::span<const sim::joint_law>{});
  const Eigen::Vector3d way = momentum.normalized(), begin = Eigen::Vector3d::UnitZ();
  for (int k = 0; k < 200 && !w.trouble(); ++k) {  // some turns: the worst of them
    w.advance(std::span<const sim::joint_law>{});
    const Eigen::Vector3d axis = w.frame(-1).where.turn.col(2);
    most = std::max(most, std::abs(std::acos(axis.dot(way)) / angle - 1));
  }
  const double time = 5.2;
  const Eigen::Vector3d right = Eigen::AngleAxisd(rate * time, way) * begin,
                        axis = w.frame(-1).where.turn.col(2);
  const auto flat = [&](const Eigen::Vector3d& v) { return (v - v.dot(way) * way).normalized(); };
  const double behind = std::acos(std::clamp(flat(right).dot(flat(axis)), -1.0, 1.0));
  figure((engine + " nutation").c_str(), w.trouble() ? 1 : most);
  figure((engine + " nutation, rate").c_str(),
         w.trouble() ? 1 : behind / (rate * time));  // up to whole turns
}
void disc_on_a_free_base() {
  sim::robot_world_settings weightless;
  weightless.engine.gravity = 0;
  weightless.plausible = sim::plausible_bounds::none();
  sim::compiled_world<disc> w({}, weightless);
  w.place({0}, {500}, cca::at(0, 0, 0), {2, 0, 0}, {});
  nods(w, "compiled");
  sim::robot_world e(sim::model_of<disc>(), {}, weightless);
  sim::moving_frame base;
  base.angular_velocity = {2, 0, 0};
  e.place(std::array{0.0}, std::array{500.0}, base);
  nods(std::move(e), "ode");
}

}  // namespace bench

int main() {
  bench::accelerations();
  bench::free_flight();
  bench::disc_on_a_free_base();
  bench::standing_load();
  bench::block_on_a_slope();
}
