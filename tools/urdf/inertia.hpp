// Masses and inertias: where they lie, the sum of what is fixed together, what no body can have, and the
// nearest that one can.
//
// Source of the triangle inequality: Wensing, Kim, Slotine, "Linear Matrix Inequalities for Physically-
// Consistent Inertial Parameter Identification", IEEE Robotics and Automation Letters 3(1), 2018.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "numbers.hpp"

namespace cca_urdf {

struct mass_of_link {
  double mass = 0;                                         // kg
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();        // m
  Eigen::Matrix3d about_centre = Eigen::Matrix3d::Zero();  // kg m^2, along the axes of the frame

  // The same in another frame, in which this one is placed.
  mass_of_link seen_from(const Eigen::Isometry3d& placed) const {
    const Eigen::Matrix3d turn = placed.linear();
    return {mass, placed * centre, turn * about_centre * turn.transpose()};
  }

  mass_of_link operator+(const mass_of_link& other) const {
    if (mass == 0) return other;
    if (other.mass == 0) return *this;
    mass_of_link sum{mass + other.mass, Eigen::Vector3d::Zero(), about_centre + other.about_centre};
    sum.centre = (mass * centre + other.mass * other.centre) / sum.mass;
    for (const mass_of_link* each : {this, &other}) {
      const Eigen::Vector3d d = each->centre - sum.centre;
      sum.about_centre += each->mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
    }
    return sum;
  }
};

inline Eigen::Vector3d principal_moments(const Eigen::Matrix3d& inertia) {  // the smallest first
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
}

inline std::string moments_text(const Eigen::Vector3d& p) {
  const double least = 1e-12 * p.cwiseAbs().maxCoeff();  // below it is rounding
  const auto text = [&](double m) { return rounded(std::abs(m) < least ? 0 : m); };
  return text(p[0]) + ", " + text(p[1]) + " and " + text(p[2]) + " kg m^2";
}

// What is wrong with an inertia, or nothing. Published inertias are rounded; a thousandth is allowed for
// that.
inline std::string fault_of(const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d principal = principal_moments(inertia);
  const std::string are = "its principal moments are " + moments_text(principal);
  if (!(principal[0] >= -1e-12 * std::abs(principal[2]))) return are + ", and none may be negative";
  if (principal[2] > (principal[0] + principal[1]) * 1.001)
    return are + ": the largest is above the sum of the others, which no body has";
  return "";
}

// Whether it resists a turn about every axis, as a body of the simulator must.
inline bool is_positive_definite(const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d principal = principal_moments(inertia);
  return principal[0] > 1e-12 * principal[2];
}

inline double inertia_of_water(double mass) {  // of a ball, kg m^2
  const double radius = std::cbrt(mass / 1000 * 3 / (4 * std::numbers::pi));
  return 0.4 * mass * radius * radius;
}
// So little for its mass that nothing was meant by it: zeros, or what rounding has left of them. A body like
// that can't be simulated.
inline bool is_next_to_nothing(const Eigen::Matrix3d& inertia, double mass) {
  return !(principal_moments(inertia).cwiseAbs().maxCoeff() > 1e-6 * inertia_of_water(mass));
}

// The nearest one (in the Frobenius norm) that a body can have and that resists a turn about every axis: each
// principal moment is below the sum of the others by a thousandth of the largest. If all are next to nothing,
// it is a ball of water of this mass.
//
// The principal axes stay. The allowed moments are a cone of three sides, x + y >= z and so on: the nearest
// point of it lies on a side, else on an edge, else in the corner.
inline Eigen::Matrix3d nearest_sound(const Eigen::Matrix3d& inertia, double mass) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> of(inertia);
  const double largest = of.eigenvalues().cwiseAbs().maxCoeff();
  if (is_next_to_nothing(inertia, mass)) return inertia_of_water(mass) * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(largest / 1000), p = of.eigenvalues() - margin;
  const auto lies_within = [&](const Eigen::Vector3d& m) {
    return m.sum() - 2 * m.maxCoeff() >= -1e-12 * largest;
  };
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  const auto offer = [&](const Eigen::Vector3d& m) {
    if (lies_within(m) && (m - p).squaredNorm() < (best - p).squaredNorm()) best = m;
  };
  offer(p);
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d side = Eigen::Vector3d::Ones(), edge = side;
    side[k] = -1, edge[k] = 0;
    offer(p - p.dot(side) / 3 * side);
    offer(std::max(0.0, p.dot(edge) / 2) * edge);
  }
  return of.eigenvectors() * (best + margin).asDiagonal() * of.eigenvectors().transpose();
}

}  // namespace cca_urdf
