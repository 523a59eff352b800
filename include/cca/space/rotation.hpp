// Rotations as unit quaternions (x, y, z, w), as ordinary functions on Eigen vectors; made without Eigen/Geometry.
//
// Preconditions: the quaternions are of unit length, to rounding; products keep that to rounding. q and -q are the same
// rotation. Sources: Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985 (slerp); the exponential map is
// that of Sola, Deray, Atchuthan, A micro Lie theory for state estimation in robotics, 2018, on S^3.
#pragma once

#include <cmath>

#include <cca/space/eigen.hpp>

namespace cca::rotation {

using detail::vector3;
using detail::vector4;

inline vector3 cross(const vector3& a, const vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline vector4 identity() { return {0, 0, 0, 1}; }
inline vector4 inverse(const vector4& q) { return {-q[0], -q[1], -q[2], q[3]}; }

// First b, then a.
inline vector4 product(const vector4& a, const vector4& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
          a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
          a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

inline vector3 rotate(const vector4& q, const vector3& v) {
  const vector3 u = q.head<3>();
  const vector3 t = 2 * cross(u, v);
  return v + q[3] * t + cross(u, t);
}

// Of unit length; the identity if the length is 0.
inline vector4 normalised(const vector4& q) {
  const double length = std::sqrt(q.dot(q));
  return length > 0 ? vector4(q / length) : identity();
}

// The one of q and -q whose w is positive (at w = 0: whose first coordinate that isn't 0 is).
inline vector4 canonical(const vector4& q) {
  for (const int i : {3, 0, 1, 2}) {
    if (q[i] > 0) return q;
    if (q[i] < 0) return -q;
  }
  return q;
}

// In [0, pi].
inline double angle(const vector4& q) { return 2 * std::atan2(std::sqrt(q.head<3>().dot(q.head<3>())), std::abs(q[3])); }

// By so many rad about an axis, of any length but 0.
inline vector4 about(const vector3& axis, double angle) {
  const double length = std::sqrt(axis.dot(axis));
  const double s = std::sin(angle / 2) / length;
  return {s * axis[0], s * axis[1], s * axis[2], std::cos(angle / 2)};
}

// Of a rotation vector: its direction is the axis, its length the angle.
inline vector4 exp(const vector3& v) {
  const double square = v.dot(v), angle = std::sqrt(square);
  const double s = angle < 1e-4 ? 0.5 - square / 48 : std::sin(angle / 2) / angle;
  return {s * v[0], s * v[1], s * v[2], std::cos(angle / 2)};
}

// The rotation vector, of length at most pi.
inline vector3 log(const vector4& q) {
  const double w = q[3] < 0 ? -q[3] : q[3], sign = q[3] < 0 ? -1 : 1;
  const vector3 v = q.head<3>();
  const double n = std::sqrt(v.dot(v));
  return (n < 1e-10 ? 2.0 : 2 * std::atan2(n, w) / n) * sign * v;
}

// Roll about x, then pitch about the old y, then yaw about the old z.
inline vector4 from_roll_pitch_yaw(double roll, double pitch, double yaw) {
  const vector4 r{std::sin(roll / 2), 0, 0, std::cos(roll / 2)}, p{0, std::sin(pitch / 2), 0, std::cos(pitch / 2)},
      y{0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
  return product(y, product(p, r));
}

// From the entries of the rotation matrix. At a pitch of +-pi/2 roll and yaw turn about one axis, and only their
// difference (sum) means something.
inline double roll(const vector4& q) { return std::atan2(2 * (q[3] * q[0] + q[1] * q[2]), 1 - 2 * (q[0] * q[0] + q[1] * q[1])); }
inline double pitch(const vector4& q) {
  const double s = 2 * (q[3] * q[1] - q[2] * q[0]);
  return std::asin(s > 1 ? 1 : s < -1 ? -1 : s);
}
inline double yaw(const vector4& q) { return std::atan2(2 * (q[3] * q[2] + q[0] * q[1]), 1 - 2 * (q[1] * q[1] + q[2] * q[2])); }

// The shorter way at constant speed: a at t = 0, b at t = 1 (or -b, which is the same rotation).
inline vector4 slerp(const vector4& a, const vector4& b, double t) {
  const double sign = a.dot(b) < 0 ? -1 : 1;
  const vector4 difference = a - sign * b, sum = a + sign * b;
  const double angle = 2 * std::atan2(std::sqrt(difference.dot(difference)), std::sqrt(sum.dot(sum)));
  if (angle < 1e-6) return normalised((1 - t) * a + t * sign * b);  // sin would cancel; the chord is the arc
  const double s = std::sin(angle);
  return (std::sin((1 - t) * angle) / s) * a + (sign * std::sin(t * angle) / s) * b;
}

inline Eigen::Matrix<double, 3, 3> matrix(const vector4& q) {
  Eigen::Matrix<double, 3, 3> m;
  for (int i = 0; i < 3; ++i) {
    vector3 e{0, 0, 0};
    e[i] = 1;
    m.col(i) = rotate(q, e);
  }
  return m;
}

}  // namespace cca::rotation
