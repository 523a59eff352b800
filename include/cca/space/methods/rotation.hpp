// Rotations as unit quaternions (x, y, z, w): ordinary functions on Eigen vectors, without Eigen/Geometry.
//
// Preconditions: quaternions of unit length, to rounding; products keep it, to rounding. q and -q are the
// same rotation. Sources: Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985 (slerp); Sola,
// Deray, Atchuthan, A micro Lie theory for state estimation in robotics, 2018 (the exponential map, on S^3).
//
// Cost: all are templates, so a file without rotations compiles none of them (as plain functions they took
// 0.3 s per file).
#pragma once

#include <cmath>

#include <cca/base/eigen.hpp>

namespace cca::rotation {

template <class Scalar>
using vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using vector4 = Eigen::Matrix<Scalar, 4, 1>;

template <class Scalar = double>
inline vector3<Scalar> cross(const vector3<Scalar>& a, const vector3<Scalar>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Scalar = double>
inline vector4<Scalar> identity() {
  return {0, 0, 0, 1};
}
template <class Scalar = double>
inline vector4<Scalar> inverse(const vector4<Scalar>& q) {
  return {-q[0], -q[1], -q[2], q[3]};
}

// First b, then a.
template <class Scalar = double>
inline vector4<Scalar> product(const vector4<Scalar>& a, const vector4<Scalar>& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
          a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
          a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

template <class Scalar = double>
inline vector3<Scalar> rotate(const vector4<Scalar>& q, const vector3<Scalar>& v) {
  const vector3<Scalar> u = q.template head<3>();
  const vector3<Scalar> t = 2 * cross(u, v);
  return v + q[3] * t + cross(u, t);
}

// Scaled to unit length; the identity if the length is 0.
template <class Scalar = double>
inline vector4<Scalar> normalised(const vector4<Scalar>& q) {
  const Scalar length = std::sqrt(q.dot(q));
  return length > 0 ? vector4<Scalar>(q / length) : identity<Scalar>();
}

// q or -q, whichever has a positive w (at w = 0: a positive first coordinate that isn't 0).
template <class Scalar = double>
inline vector4<Scalar> canonical(const vector4<Scalar>& q) {
  for (const int i : {3, 0, 1, 2}) {
    if (q[i] > 0) return q;
    if (q[i] < 0) return -q;
  }
  return q;
}

// In [0, pi].
template <class Scalar = double>
inline Scalar angle(const vector4<Scalar>& q) {
  return 2 * std::atan2(std::sqrt(q.template head<3>().dot(q.template head<3>())), std::abs(q[3]));
}

// By `angle` rad about an axis of any length but 0.
template <class Scalar = double>
inline vector4<Scalar> about(const vector3<Scalar>& axis, Scalar angle) {
  const Scalar length = std::sqrt(axis.dot(axis));
  const Scalar s = std::sin(angle / 2) / length;
  return {s * axis[0], s * axis[1], s * axis[2], std::cos(angle / 2)};
}

// From a rotation vector: its direction is the axis, its length the angle.
template <class Scalar = double>
inline vector4<Scalar> exp(const vector3<Scalar>& v) {
  const Scalar square = v.dot(v), angle = std::sqrt(square);
  const Scalar s = angle < 1e-4 ? 0.5 - square / 48 : std::sin(angle / 2) / angle;
  return {s * v[0], s * v[1], s * v[2], std::cos(angle / 2)};
}

// The rotation vector, of length at most pi.
template <class Scalar = double>
inline vector3<Scalar> log(const vector4<Scalar>& q) {
  const Scalar w = q[3] < 0 ? -q[3] : q[3], sign = q[3] < 0 ? -1 : 1;
  const vector3<Scalar> v = q.template head<3>();
  const Scalar n = std::sqrt(v.dot(v));
  return (n < 1e-10 ? 2.0 : 2 * std::atan2(n, w) / n) * sign * v;
}

// Roll about x, then pitch about the old y, then yaw about the old z.
template <class Scalar = double>
inline vector4<Scalar> from_roll_pitch_yaw(Scalar roll, Scalar pitch, Scalar yaw) {
  const vector4<Scalar> r{std::sin(roll / 2), 0, 0, std::cos(roll / 2)},
      p{0, std::sin(pitch / 2), 0, std::cos(pitch / 2)}, y{0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
  return product(y, product(p, r));
}

// From the entries of the rotation matrix. At a pitch of +-pi/2 roll and yaw rotate about the same axis, and
// only their difference (at +pi/2) or sum (at -pi/2) is defined.
template <class Scalar = double>
inline Scalar roll(const vector4<Scalar>& q) {
  return std::atan2(2 * (q[3] * q[0] + q[1] * q[2]), 1 - 2 * (q[0] * q[0] + q[1] * q[1]));
}
template <class Scalar = double>
inline Scalar pitch(const vector4<Scalar>& q) {
  const Scalar s = 2 * (q[3] * q[1] - q[2] * q[0]);
  return std::asin(s > 1 ? 1 : s < -1 ? -1 : s);
}
template <class Scalar = double>
inline Scalar yaw(const vector4<Scalar>& q) {
  return std::atan2(2 * (q[3] * q[2] + q[0] * q[1]), 1 - 2 * (q[1] * q[1] + q[2] * q[2]));
}

// The shorter way at constant speed: a at t = 0, b at t = 1 (or -b, which is the same rotation).
template <class Scalar = double>
inline vector4<Scalar> slerp(const vector4<Scalar>& a, const vector4<Scalar>& b, Scalar t) {
  const Scalar sign = a.dot(b) < 0 ? -1 : 1;
  const vector4<Scalar> difference = a - sign * b, sum = a + sign * b;
  const Scalar angle = 2 * std::atan2(std::sqrt(difference.dot(difference)), std::sqrt(sum.dot(sum)));
  if (angle < 1e-6)
    return normalised(vector4<Scalar>(
        (1 - t) * a + t * sign * b));  // here sin(angle) is too small to divide by; the chord equals the arc
  const Scalar s = std::sin(angle);
  return (std::sin((1 - t) * angle) / s) * a + (sign * std::sin(t * angle) / s) * b;
}

template <class Scalar = double>
inline Eigen::Matrix<Scalar, 3, 3> matrix(const vector4<Scalar>& q) {
  Eigen::Matrix<Scalar, 3, 3> m;
  for (int i = 0; i < 3; ++i) {
    vector3<Scalar> e{0, 0, 0};
    e[i] = 1;
    m.col(i) = rotate(q, e);
  }
  return m;
}

}  // namespace cca::rotation
