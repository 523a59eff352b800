// Masses and inertias: where they lie, the sum of what is fixed together, and what no body can have.
//
// Source of the triangle inequality: Wensing, Kim, Slotine, "Linear Matrix Inequalities for Physically-
// Consistent Inertial Parameter Identification", IEEE Robotics and Automation Letters 3(1), 2018.
#pragma once

#include <algorithm>
#include <array>
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

// What is wrong with an inertia, or nothing. Published inertias are rounded; a thousandth is allowed for
// that.
inline std::string fault_of(const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  const std::string are = "its principal moments are " + rounded(principal[0]) + ", " +
                          rounded(principal[1]) + " and " + rounded(principal[2]) + " kg m^2";
  if (!(principal[0] >= -1e-12 * std::abs(principal[2]))) return are + ", and none may be negative";
  if (principal[2] > (principal[0] + principal[1]) * 1.001)
    return are + ": the largest is above the sum of the others, which no body has";
  return "";
}

// Whether it resists a turn about every axis, as a body of the simulator must.
inline bool is_positive_definite(const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  return principal[0] > 1e-12 * principal[2];
}

}  // namespace cca_urdf
