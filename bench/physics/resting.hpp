#pragma once
// Robots at rest on the ground, and a block on a slope, in both engines.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <cca/robots/oncilla/description.hpp>
#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

#include "figures.hpp"

namespace bench {

namespace sim = cca::sim;
namespace robots = cca::robots;
using oncilla_description = robots::oncilla::description;

// The drives of R hold its posture of the start.
template <class R>
auto holding() {
  std::array<sim::joint_law, R::drives.size()> laws;
  for (std::size_t c = 0; c < laws.size(); ++c)
    laws[c] = {.position = R::start[c],
               .stiffness = R::drives[c].position_stiffness(),
               .damping = R::drives[c].damping};
  return laws;
}
inline sim::scene level() {
  sim::scene s;
  s.floor = 0;
  return s;
}
template <class R>
sim::compiled_world<R> compiled_at(const cca::placement& base,
                                   const sim::scene& around,
                                   const sim::robot_world_settings& s = {}) {
  sim::compiled_world<R> w(around, s);
  std::array<double, R::drives.size()> q{};
  if constexpr (requires { R::start; }) q = R::start;
  w.place(q, {}, base, {}, {});
  return w;
}
template <class R>
sim::robot_world engine_at(const cca::placement& base,
                           const sim::scene& around,
                           const sim::robot_world_settings& s = {}) {
  sim::robot_world w(sim::model_of<R>(), around, s);
  std::array<double, R::drives.size()> q{}, still{};
  if constexpr (requires { R::start; }) q = R::start;
  sim::moving_frame frame;
  frame.where = cca::rigid{} * base;
  w.place(q, still, frame);
  return w;
}

// After 10 s.
template <class World>
double error_of_load(World w) {
  const auto laws = holding<oncilla_description>();
  for (int k = 0; k < 10000; ++k) w.advance(laws);
  double sum = 0;
  for (std::size_t part = 0; part < 4; ++part) sum += w.force_on_end(part)[2];
  return std::abs(sum / (w.mass() * 9.81) - 1);
}
inline void standing_load() {
  const cca::placement above = cca::at(0, 0, 0.17);
  figure("compiled load", error_of_load(compiled_at<oncilla_description>(above, level())));
  figure("ode load", error_of_load(engine_at<oncilla_description>(above, level())));
}

struct block_frame : cca::frame<"block"> {};
struct rotor_frame : cca::frame<"rotor"> {};
struct rotor_spin : cca::dimension<"rotor"> {};
struct rotor_chain : cca::serial_chain<block_frame, rotor_frame, cca::axes<rotor_spin>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0, 0, 0);
  static constexpr std::array links{cca::link_inertia{0.001, {}, {1e-6, 1e-6, 1e-6}}};
};
struct block_body : cca::body<block_frame, cca::part<"rotor", rotor_chain>> {
  static constexpr cca::link_inertia base{
      2, {}, {2 * (0.01 + 0.0025) / 12, 2 * (0.01 + 0.0025) / 12, 2 * 0.02 / 12}};
};
struct block {
  using body = block_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr bool floats = true;
  static constexpr std::array drives{robots::joint_drive{.friction = 0.01, .stops = false}};
  static constexpr std::array shapes{robots::on_base(robots::box(0.1, 0.1, 0.05))};
};

// m/s down the slope, after so many beats; it is put down as deep as it takes to carry it.
template <class World>
std::array<double, 2> speeds_down(World w, double pitch, int first, int second) {
  const Eigen::Vector3d down(-std::cos(pitch), 0, -std::sin(pitch));
  const std::array<sim::joint_law, 1> none{};
  std::array<double, 2> speeds{};
  for (int k = 0; k < first; ++k) w.advance(none);
  speeds[0] = down.dot(w.frame(-1).velocity);
  for (int k = 0; k < second; ++k) w.advance(none);
  speeds[1] = down.dot(w.frame(-1).velocity);
  return speeds;
}
inline cca::placement on_slope_of(double pitch) {
  const double above = 0.025 - 0.0005 - 2.001 * 9.81 * std::cos(pitch) / 4 / 40e3;
  return cca::at(-above * std::sin(pitch), 0, 10 * std::tan(pitch) + above * std::cos(pitch)) *
         cca::turned_about(cca::along_y, -pitch);
}
inline void block_on_a_slope() {
  constexpr double degree = 0.017453292519943295, friction = 0.75;
  const auto hill = [](double pitch) {
    sim::scene s;
    s.ground = sim::terrain::slope(pitch, -10).with_friction(friction);
    return s;
  };
  std::array<double, 2> slides{}, creeps{};  // compiled, ode
  for (const double degrees : {0.0, 20.0, 30.0, 36.0, 38.0, 45.0, 60.0}) {
    const double pitch = degrees * degree, wanted = 9.81 * (std::sin(pitch) - friction * std::cos(pitch));
    const auto judge = [&](auto world, std::size_t engine) {
      const auto [from, to] = wanted > 0 ? speeds_down(std::move(world), pitch, 200, 300)
                                         : speeds_down(std::move(world), pitch, 3000, 1000);
      if (wanted > 0) slides[engine] = std::max(slides[engine], std::abs((to - from) / 0.3 / wanted - 1));
      else creeps[engine] = std::max(creeps[engine], std::abs(to));
    };
    judge(compiled_at<block>(on_slope_of(pitch), hill(pitch)), 0);
    judge(engine_at<block>(on_slope_of(pitch), hill(pitch)), 1);
  }
  figure("compiled slides", slides[0]), figure("ode slides", slides[1]);
  figure("compiled creeps", creeps[0]), figure("ode creeps", creeps[1]);
}

}  // namespace bench
