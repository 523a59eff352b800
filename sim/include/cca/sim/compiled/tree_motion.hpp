// Where the links of a described robot are and how they move: the state of a compiled world that a physics
// step changes, and how positions follow velocities.
//
// A plain value. The base is placed in the world, and its velocities are along the world's axes: those of its
// origin. Of a base that is held, they are zero. `change`: of the velocities in the last step, per second,
// and in the one before.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/math/roots.hpp>
#include <cca/mapping/placement.hpp>
#include <cca/robot/recorded/placed_ends.hpp>

namespace cca::sim::detail {

using cca::detail::placed_frame;
using cca::detail::triple;

template <class Real>
constexpr Real dot(const triple<Real>& a, const triple<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
// That of one lane, of a vector in lanes.
template <class Real>
constexpr triple<double> lane_of(const triple<Real>& v, int k) {
  return {v[0][k], v[1][k], v[2][k]};
}
template <class Real>
constexpr void set_lane(triple<Real>& v, int k, const triple<double>& of) {
  for (std::size_t r = 0; r < 3; ++r) v[r].set(k, of[r]);
}
// A direction in the frame's own axes.
template <class Real>
constexpr triple<Real> along(const placed_frame<Real>& f, const triple<Real>& v) {
  return {dot(f.axes[0], v), dot(f.axes[1], v), dot(f.axes[2], v)};
}

// A unit quaternion: x, y, z, w.
template <class Real>
struct attitude_of_base {
  std::array<Real, 4> q{Real(0.0), Real(0.0), Real(0.0), Real(1.0)};

  // Of a rotation of any length above 0.
  static attitude_of_base of(const std::array<double, 4>& rotation) {
    double square = 0;
    for (const double x : rotation) square += x * x;
    attitude_of_base a;
    for (std::size_t k = 0; k < 4; ++k) a.q[k] = Real(rotation[k] / math::sqrt(square));
    return a;
  }
  constexpr placed_frame<Real> frame(const triple<Real>& at) const {
    const Real two(2.0);
    const auto& [x, y, z, w] = q;
    placed_frame<Real> f;
    f.axes[0] = {Real(1.0) - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)};
    f.axes[1] = {two * (x * y - w * z), Real(1.0) - two * (x * x + z * z), two * (y * z + w * x)};
    f.axes[2] = {two * (x * z + w * y), two * (y * z - w * x), Real(1.0) - two * (x * x + y * y)};
    f.at = at;
    return f;
  }
  // By a small rotation about axes of the world: tan(angle / 4) by its series, to the fifth power.
  constexpr void turn(const triple<Real>& by) {
    const triple<Real> quarter = Real(0.25) * by;
    const Real square = dot(quarter, quarter);
    const triple<Real> t = (Real(1.0) + square * Real(1.0 / 3)) * quarter;
    const Real length = dot(t, t), share = Real(1.0) / (Real(1.0) + length);
    const triple<Real> v = (share + share) * t;
    const Real c = (Real(1.0) - length) * share;
    const auto [x, y, z, w] = q;
    q = {c * x + v[0] * w + v[1] * z - v[2] * y, c * y - v[0] * z + v[1] * w + v[2] * x,
         c * z + v[0] * y - v[1] * x + v[2] * w, c * w - v[0] * x - v[1] * y - v[2] * z};
    const Real size = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    const Real keep = Real(1.5) - Real(0.5) * size;  // its length drifts by rounding only
    for (Real& e : q) e = e * keep;
  }
};

template <class Real, int Coordinates, bool Floats>
struct tree_motion {
  static constexpr auto n = static_cast<std::size_t>(Coordinates);
  static constexpr std::size_t base = Floats ? 6 : 0;
  using vector = std::array<Real, base + n>;  // variables: the base's, then the coordinates'

  triple<Real> at{};
  attitude_of_base<Real> attitude{};
  triple<Real> angular_velocity{}, velocity{};
  std::array<Real, n> q{}, dq{};
  struct change_of_speeds {
    triple<Real> turning{};  // of the base
    std::array<Real, n> joints{};
  };
  change_of_speeds change{}, change_before{};

  constexpr placed_frame<Real> frame() const { return attitude.frame(at); }

  constexpr void drift(double time) {
    const Real h(time);
    if constexpr (Floats) {
      at = at + h * velocity;
      attitude.turn(h * angular_velocity);
    }
    for (std::size_t c = 0; c < n; ++c) q[c] = q[c] + h * dq[c];
  }
};

}  // namespace cca::sim::detail
