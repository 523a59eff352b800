// What the solvers of inverse kinematics share: the error of the tip and the limits of the joints.
//
// `tip_task` is the error of a tip against a wanted position, orientation or pose, and the rows of the
// Jacobian that change it. `chain_limits` holds the limits of a chain's coordinates and its span. `readable`
// checks and scales a target: of NaN and infinity it returns false, and such a target is not solved. Source:
// Siciliano, Sciavicco, Villani, Oriolo, Robotics: Modelling, Planning and Control, 2009, section 3.7 (errors
// of position and orientation).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <cca/base/array_size.hpp>
#include <cca/mapping/forward_kinematics.hpp>
#include <cca/space/limits.hpp>

namespace cca {
namespace detail {

// The task of the tip: the rows of the Jacobian that count, and the error along them.
template <class Space, class Settings>
struct tip_task {
  static constexpr bool of_position = same_kind<typename Space::domain, cartesian_position<void>>;
  static constexpr bool of_pose = same_kind<typename Space::domain, pose<void>>;
  static constexpr int rows = of_position ? Space::size : of_pose ? 6 : 3;
  using vector = Eigen::Matrix<double, rows, 1>;

  static vector error(const typename Space::vector_type& wanted, const rigid& tip) {
    vector e;
    if constexpr (of_position) {
      e = wanted - tip_in<Space>(tip);
    } else {
      const vector4 q = wanted.template tail<4>();
      e.template tail<3>() =
          Settings::lever * rotation::log(rotation::product(q, rotation::inverse(quaternion_of(tip.turn))));
      if constexpr (of_pose) e.template head<3>() = wanted.template head<3>() - tip.at;
    }
    return e;
  }

  template <class Jacobian>
  static auto rows_of(const Jacobian& j) {
    Eigen::Matrix<double, rows, Jacobian::ColsAtCompileTime> r;
    if constexpr (of_position) {
      using part = cartesian_part<typename Space::axes>;
      for (int i = 0; i < rows; ++i) r.row(i) = j.row(3 + part::of[static_cast<std::size_t>(i)]);
    } else {
      r.template bottomRows<3>() = Settings::lever * j.template topRows<3>();
      if constexpr (of_pose) r.template topRows<3>() = j.template bottomRows<3>();
    }
    return r;
  }
};

// False if the target is not finite. Moves a target beyond a million spans of the chain to that distance:
// only its direction counts there. Normalises quaternions.
template <class Space>
inline bool readable(typename Space::vector_type& wanted, double span) {
  double largest = 0;
  for (int i = 0; i < Space::size; ++i) {
    if (!std::isfinite(wanted[i])) return false;
    if (i < 3) largest = std::max(largest, std::abs(wanted[i]));
  }
  constexpr bool turned = !same_kind<typename Space::domain, cartesian_position<void>>;
  constexpr bool placed = !same_kind<typename Space::domain, orientation<void>>;
  if constexpr (placed) {
    const double farthest = 1e6 * span;
    constexpr int part = turned ? 3 : Space::size;
    if (largest > farthest) wanted.template head<part>() *= farthest / largest;
  }
  if constexpr (turned) {
    const vector4 q = wanted.template tail<4>();
    wanted.template tail<4>() = rotation::normalised(vector4(q / std::max(1e-300, q.cwiseAbs().maxCoeff())));
  }
  return true;
}

// The limits of the coordinates of a chain: angles; of prismatic joints lengths.
template <class Chain, class Joints>
struct chain_limits {
  static constexpr int size = Chain::axes::count;
  using vector = Eigen::Matrix<double, size, 1>;

  static constexpr std::array<double, array_size(2 * size + 1)> bounds = []<class... Axes>(axes<Axes...>) {
    std::array<double, array_size(2 * size + 1)> all{};
    std::size_t i = 0;
    const auto add = [&](double angle_low, double angle_high, double length_low, double length_high) {
      bool slides = false;
      for (const auto& l : chain_links<Chain>)
        if (l.coordinate == static_cast<int>(i / 2)) slides = l.kind == joint_kind::prismatic;
      all[i++] = slides ? length_low : angle_low;
      all[i++] = slides ? length_high : angle_high;
    };
    (add(lower_limit_of<Axes, angle>, upper_limit_of<Axes, angle>, lower_limit_of<Axes, length>,
         upper_limit_of<Axes, length>),
     ...);
    return all;
  }(typename Chain::axes());

  static constexpr std::array<bool, array_size(size)> continuous = []<class... Axes>(axes<Axes...>) {
    return std::array<bool, array_size(size)>{cca::is_continuous<Axes>...};
  }(typename Chain::axes());
  static constexpr bool is_continuous(int i) { return continuous[static_cast<std::size_t>(i)]; }

  static constexpr double lower(int i) { return bounds[static_cast<std::size_t>(2 * i)]; }
  static constexpr double upper(int i) { return bounds[static_cast<std::size_t>(2 * i + 1)]; }
  static double clamped(int i, double q) { return q < lower(i) ? lower(i) : q > upper(i) ? upper(i) : q; }
  static vector clamped(vector q) {
    for (int i = 0; i < size; ++i) q[i] = clamped(i, q[i]);
    return q;
  }
  // The point at the fraction `part` between the limits; without limits between -3 and 3 rad, of a continuous
  // axis once around the circle.
  static double between(int i, double part) {
    if (is_continuous(i)) return (2 * part - 1) * std::numbers::pi;
    const double low = std::isfinite(lower(i)) ? lower(i) : std::isfinite(upper(i)) ? upper(i) - 3 : -3;
    const double high = std::isfinite(upper(i)) ? upper(i) : low + 6;
    return low + part * (high - low);
  }

  // m: the length of the stretched chain, with its prismatic joints at their limits.
  static constexpr double span = [] {
    double sum = 0;
    const auto add = [&](const std::array<double, 3>& v) {
      sum += constant_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    };
    for (const auto& l : chain_links<Chain>) {
      add(l.at);
      const double high = upper(l.coordinate), low = lower(l.coordinate), far = high > -low ? high : -low;
      if (l.kind == joint_kind::prismatic) sum += far < 1e3 ? far : 1.0;
    }
    add(Chain::tip.translation);
    return sum > 0 ? sum : 1.0;
  }();
};

}  // namespace detail
}  // namespace cca
