// Whether springs and dampers that act once a beat are slow enough for the inertia that they move.
//
//   const double share = cca::detail::stable_share<7>(mass, damping, stiffness, dt);
//
// A torque that holds for a beat answers a motion that it has already changed. With M, D and K symmetric, the
// motion between beats is stable where, for every direction, dt D < 2 M and D > dt K / 2. The second is a
// matter of the damping alone. This asks for
//
//   2 M - dt (D + dt K)   positive definite
//
// which is the first, and a stiffness that a beat does not overshoot. `IsDamped` asks for the second too, but
// for a growth of a hundredth a beat, so that slow springs need no damping:
//
//   0.02 M + dt D - dt^2 K / 2   positive definite
//
// `share` is 1 where that holds, else the largest s, to 1e-6, with which s^2 K and s D do: the same damping
// ratio, and softer. Where a coordinate moves no mass there is nothing to compare with, and it is 1. Source:
// Colgate and Schenkel, Passivity of a Class of Sampled-Data Systems, J. Robotic Systems 14(1), 1997 (dampers
// that are sampled and held). Cost: a decomposition of n x n; where it does not hold, 20 more.
//
// NaN and infinity give 1; nothing is kept.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/base/eigen.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/space/limits.hpp>
#include <cca/space/space.hpp>

namespace cca::detail {

template <int Size>
bool positive_definite(Eigen::Matrix<double, Size, Size> a) {
  for (int j = 0; j < Size; ++j) {
    for (int k = 0; k < j; ++k) a(j, j) -= a(j, k) * a(j, k);
    if (!(a(j, j) > 0)) return false;
    a(j, j) = math::sqrt(a(j, j));
    for (int i = j + 1; i < Size; ++i) {
      for (int k = 0; k < j; ++k) a(i, j) -= a(i, k) * a(j, k);
      a(i, j) /= a(j, j);
    }
  }
  return true;
}

template <int Size, bool IsDamped = true>
double stable_share(const Eigen::Matrix<double, Size, Size>& mass,
                    const Eigen::Matrix<double, Size, Size>& damping,
                    const Eigen::Matrix<double, Size, Size>& stiffness,
                    double dt) {
  using matrix = Eigen::Matrix<double, Size, Size>;
  const auto holds = [&](double s) {
    return positive_definite<Size>(matrix(2 * mass - (s * dt) * damping - (s * s * dt * dt) * stiffness)) &&
           (!IsDamped || positive_definite<Size>(
                             matrix(0.02 * mass + (s * dt) * damping - (0.5 * s * s * dt * dt) * stiffness)));
  };
  if (holds(1)) [[likely]]
    return 1;
  if (!holds(0)) return 1;
  double share = 0, beyond = 1;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (share + beyond);
    (holds(middle) ? share : beyond) = middle;
  }
  return share;
}

// The coordinates in the middle of their limits; without limits, 0.
template <class... Axes>
Eigen::Matrix<double, static_cast<int>(sizeof...(Axes)), 1> middle_of(axes<Axes...>) {
  const auto middle = [](double low, double high) {
    return std::isfinite(low + high) ? 0.5 * (low + high) : 0;
  };
  return Eigen::Matrix<double, static_cast<int>(sizeof...(Axes)), 1>(
      std::array{middle(lower_limit_of<Axes, angle>, upper_limit_of<Axes, angle>)...}.data());
}

// For check_at(step): what is too stiff or too damped, and what would do.
inline std::string beyond_beat(
    std::string_view axis, double stiffness, double damping, double share, double step) {
  const bool springs = stiffness > 0;
  const std::string name = std::string(springs ? "stiffness` of `" : "damping` of `").append(axis);
  return rate_text(name, springs ? stiffness : damping, "at most",
                   springs ? share * share * stiffness : share * damping, step);
}

}  // namespace cca::detail
