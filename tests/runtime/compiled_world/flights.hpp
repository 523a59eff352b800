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

}  // namespace compiled_test
