// Random joints and links with random inertia.
#pragma once

#include <array>
#include <cstddef>

#include <cca/mapping/serial_chain.hpp>

#include "../../laws/space_laws.hpp"

namespace body_test {

inline std::array<double, 3> array(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
inline cca::placement random_placement(laws::source& random) {
  const Eigen::Vector4d q = cca::rotation::exp(random.vector(2));
  return {array(random.vector(1)), {q[0], q[1], q[2], q[3]}};
}

// The inertia of four random point masses, so it is physically possible.
inline cca::link_inertia random_inertia(laws::source& random) {
  cca::link_inertia of;
  std::array<Eigen::Vector3d, 4> points;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  std::array<double, 4> masses;
  for (std::size_t i = 0; i < 4; ++i) {
    points[i] = random.vector(0.3), masses[i] = random(0.1, 2);
    of.mass += masses[i];
    centre += masses[i] * points[i];
  }
  centre /= of.mass;
  of.centre = array(centre);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d d = points[i] - centre;
    const Eigen::Matrix3d m = masses[i] * (d.dot(d) * Eigen::Matrix3d::Identity() - d * d.transpose());
    const std::array<double, 6> add{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
    for (std::size_t k = 0; k < 6; ++k) of.about_centre[k] += add[k];
  }
  return of;
}

// The link to which link i is attached: the one before it (a chain), or any before it or the base (a tree).
inline int random_parent(laws::source& random, std::size_t i, bool chain) {
  return chain ? static_cast<int>(i) - 1
               : static_cast<int>(random(-1, static_cast<double>(i) - 1e-9) + 1) - 1;
}

inline cca::joint random_joint(laws::source& random) {
  cca::joint j;
  j.kind = random(0, 1) < 0.75 ? cca::joint_kind::revolute : cca::joint_kind::prismatic;
  const double axis = random(0, 6);
  j.axis = axis < 1   ? cca::along_x
           : axis < 2 ? cca::along_y
           : axis < 3 ? cca::along_z
                      : array(random.vector(1).normalized());
  if (random(0, 1) < 0.8) j.where = random_placement(random);
  return j;
}

}  // namespace body_test
