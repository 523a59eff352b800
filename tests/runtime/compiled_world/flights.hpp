#pragma once
// Robots that are thrown, in a compiled world or in the engine: the tests and the table of docs/physics.md.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>

#include <Eigen/Dense>

#include "robots.hpp"

namespace compiled_test {

template <class R>
struct throwing {
  cca::placement place;
  numbers<R> q, dq;
  Eigen::Vector3d turning, velocity;
};
// With speeds of up to 2 rad/s and 2 m/s.
template <class R>
throwing<R> random_throw() {
  laws::source random{std::mt19937_64{7}};
  throwing<R> t;
  t.place = random_place(random);
  t.q = random_numbers<R>(random, 0.3), t.dq = random_numbers<R>(random, 2);
  t.turning = random.vector(2), t.velocity = random.vector(2);
  return t;
}

// `steps`: in a beat of 1 ms.
template <class R>
sim::compiled_world<R> thrown(int steps) {
  sim::robot_world_settings s;
  s.steps_per_beat = steps;
  sim::compiled_world<R> w(s);
  const throwing<R> t = random_throw<R>();
  if constexpr (R::floats)
    w.place(t.q, t.dq, t.place, {t.turning[0], t.turning[1], t.turning[2]},
            {t.velocity[0], t.velocity[1], t.velocity[2]});
  else w.place(t.q, t.dq);
  return w;
}

// After each beat of 0.3 s.
template <class World>
double largest_change_of_energy(World w) {
  const double before = w.energy();
  double most = 0;
  for (int i = 0; i < 300; ++i) {
    w.advance(std::span<const sim::joint_law>{});
    most = std::max(most, std::abs(w.energy() - before));
  }
  return most;
}

// A disc that spins on a free base: the axis of both goes round the momentum, by the formula of a symmetric
// top.
struct hub_frame : cca::frame<"hub"> {};
struct disc_frame : cca::frame<"disc"> {};
struct spin_of_disc : cca::dimension<"spin_of_disc"> {
  static constexpr double speed = 500, nod = 2;            // rad/s, of the disc and of the base
  static constexpr double across = 0.0225, along = 0.005;  // kg m^2, of both and of the disc
};
struct disc_chain : cca::serial_chain<hub_frame, disc_frame, cca::axes<spin_of_disc>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0, 0, 0);
  static constexpr std::array links{cca::link_inertia{
      1, {0, 0, 0}, {spin_of_disc::along / 2, spin_of_disc::along / 2, spin_of_disc::along}}};
};
struct disc_body : cca::body<hub_frame, cca::part<"disc", disc_chain>> {
  static constexpr double own = spin_of_disc::across - spin_of_disc::along / 2;
  static constexpr cca::link_inertia base{2, {0, 0, 0}, {own, own, 0.01}};
};
using disc = alone<disc_body, true>;

inline sim::robot_world_settings weightless() {
  sim::robot_world_settings s;
  s.engine.gravity = 0;
  return s;
}
inline sim::compiled_world<disc> spinning_disc() {
  sim::compiled_world<disc> w({}, weightless());
  w.place({0}, {spin_of_disc::speed}, cca::at(0, 0, 0), {spin_of_disc::nod, 0, 0}, {});
  return w;
}

// After 5 s: of the angle between axis and momentum the worst error of the next 0.2 s, and the error of how
// fast the axis goes round (up to whole turns); relative. 1 if the world stands still.
struct nutation {
  double error = 1, error_of_rate = 1;
};
template <class World>
nutation nutation_of(World w) {
  constexpr double turns = spin_of_disc::along * spin_of_disc::speed;
  const Eigen::Vector3d momentum(spin_of_disc::across * spin_of_disc::nod, 0, turns);
  const Eigen::Vector3d way = momentum.normalized();
  const double angle = std::atan2(momentum[0], turns), rate = momentum.norm() / spin_of_disc::across;
  nutation n{0, 0};
  for (int k = 0; k < 5200; ++k) {
    w.advance(std::span<const sim::joint_law>{});
    if (k < 5000) continue;
    const Eigen::Vector3d axis = w.frame(-1).where.turn.col(2);
    n.error = std::max(n.error, std::abs(std::acos(axis.dot(way)) / angle - 1));
  }
  if (w.trouble()) return {};
  const auto flat = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return (v - v.dot(way) * way).normalized();
  };
  const Eigen::Vector3d right = Eigen::AngleAxisd(rate * 5.2, way) * Eigen::Vector3d::UnitZ(),
                        axis = w.frame(-1).where.turn.col(2);
  n.error_of_rate = std::acos(std::clamp(flat(right).dot(flat(axis)), -1.0, 1.0)) / (rate * 5.2);
  return n;
}

}  // namespace compiled_test
