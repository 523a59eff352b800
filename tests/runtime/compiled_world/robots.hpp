#pragma once
// Robots for the tests of compiled worlds: bodies without drives, and states of them.
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <cca/robot/dynamics/momentum.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/robots/oncilla/description.hpp>
#include <cca/sim/compiled/compiled_world.hpp>

#include "../../laws/space_laws.hpp"

namespace compiled_test {

namespace robots = cca::robots;
namespace sim = cca::sim;

// A body, and nothing that acts on its joints.
template <class Body, bool Floats>
struct alone {
  using body = Body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr bool floats = Floats;
  static constexpr auto drives = [] {
    std::array<robots::joint_drive, static_cast<std::size_t>(cca::axes_of<Body>::count)> all{};
    for (auto& d : all) d.stops = false;
    return all;
  }();
};
using flying_oncilla = alone<robots::oncilla::walking_body, true>;
using limp_arm = alone<robots::arm::body, false>;

template <class R>
constexpr std::size_t coordinates = static_cast<std::size_t>(cca::axes_of<typename R::body>::count);
template <class R>
using numbers = std::array<double, coordinates<R>>;

template <class R>
numbers<R> random_numbers(laws::source& random, double size) {
  numbers<R> all;
  for (double& x : all) x = random(-size, size);
  return all;
}
inline cca::placement random_place(laws::source& random) {
  cca::placement p = cca::at(random(-1, 1), random(-1, 1), random(-1, 1));
  const Eigen::Vector4d q =
      Eigen::Vector4d(random(-1, 1), random(-1, 1), random(-1, 1), random(-1, 1)).normalized();
  p.rotation = {q[0], q[1], q[2], q[3]};
  return p;
}

template <class R>
auto pose_of(const sim::compiled_world<R>& w) {
  using pose = cca::body_pose<typename R::body>;
  return pose(pose::vector_type::Map(w.save().motion.q.data()));
}
template <class R>
auto speeds_of(const sim::compiled_world<R>& w) {
  return Eigen::Matrix<double, static_cast<int>(coordinates<R>), 1>(
      Eigen::Matrix<double, static_cast<int>(coordinates<R>), 1>::Map(w.save().motion.dq.data()));
}

// A sledge on three round feet; a rod on it is held by a stiff spring.
struct sledge_frame : cca::frame<"sledge"> {};
struct rod_frame : cca::frame<"rod"> {};
struct sway : cca::dimension<"sway"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}};
};
struct rod_chain : cca::serial_chain<sledge_frame, rod_frame, cca::axes<sway>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0, 0, 0.05);
  static constexpr std::array links{cca::link_inertia{0.1, {0, 0, 0}, {1e-4, 1e-4, 1e-4, 0, 0, 0}}};
};
inline constexpr double radius = 0.01, mass = 2.1, gravity = 9.81;
struct sledge {
  struct body : cca::body<sledge_frame, cca::part<"rod", rod_chain>> {
    static constexpr cca::link_inertia base{2, {0, 0, 0}, {0.01, 0.01, 0.02, 0, 0, 0}};
  };
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr bool floats = true;
  static constexpr std::array drives{robots::joint_drive{.spring = 10}};
  static constexpr std::array shapes{robots::on_base(robots::sphere(radius), cca::at(0.2, 0, -0.05)),
                                     robots::on_base(robots::sphere(radius), cca::at(-0.1, 0.15, -0.05)),
                                     robots::on_base(robots::sphere(radius), cca::at(-0.1, -0.15, -0.05))};
};

// On a slope from x = -10 on, or on level ground, with its feet as deep as it takes to carry them.
inline sim::scene hill_of(double pitch, double friction) {
  sim::scene hill;
  hill.ground = sim::terrain::slope(pitch, -10).with_friction(friction);
  return hill;
}
inline cca::placement on_hill(double pitch) {
  const double deep = 0.0005 + mass * gravity * std::cos(pitch) / 3 / 40e3, above = 0.05 + radius - deep;
  return cca::at(-above * std::sin(pitch), 0, 10 * std::tan(pitch) + above * std::cos(pitch)) *
         cca::turned_about(cca::along_y, -pitch);
}
inline sim::compiled_world<sledge> on_slope(double pitch, double friction) {
  sim::compiled_world<sledge> w(hill_of(pitch, friction));
  w.place({0}, {0}, on_hill(pitch), {}, {});
  return w;
}
inline double speed(const sim::compiled_world<sledge>& w) { return w.frame(-1).velocity.norm(); }

// The same on a box, and on a capsule.
inline constexpr double half_turn = 3.14159265358979323846;

struct crate : sledge {
  static constexpr std::array shapes{robots::on_base(robots::box(0.3, 0.2, 0.1))};
};
struct roller : sledge {  // along x
  static constexpr std::array shapes{
      robots::on_base(robots::capsule(0.02, 0.4), cca::turned_about(cca::along_y, half_turn / 2))};
};

template <class World>
void run(World& w, int beats) {
  for (int i = 0; i < beats; ++i) w.advance({});
}
// The depth at which `points` contacts carry their mass.
inline double deep(double points) { return 0.0005 + mass * gravity / points / 40e3; }

}  // namespace compiled_test
