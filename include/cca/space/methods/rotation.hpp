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

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
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
  const Scalar length = math::sqrt(math::dot(q, q));
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
CCA_INLINE Scalar angle(const vector4<Scalar>& q) {
  return 2 * math::atan2(math::sqrt(math::dot(q.template head<3>(), q.template head<3>())), std::abs(q[3]));
}

// By `angle` rad about an axis of any length but 0.
template <class Scalar = double>
inline vector4<Scalar> about(const vector3<Scalar>& axis, Scalar angle) {
  const Scalar length = math::sqrt(math::dot(axis, axis));
  const auto half = math::sine_and_cosine(angle / 2);
  const Scalar s = half.sine / length;
  return {s * axis[0], s * axis[1], s * axis[2], half.cosine};
}

// From a rotation vector: its direction is the axis, its length the angle.
template <class Scalar = double>
inline vector4<Scalar> exp(const vector3<Scalar>& v) {
  const Scalar square = math::dot(v, v), angle = math::sqrt(square);
  const auto half = math::sine_and_cosine(angle / 2);
  const Scalar s = angle < 1e-4 ? 0.5 - square / 48 : half.sine / angle;
  return {s * v[0], s * v[1], s * v[2], half.cosine};
}

// The rotation vector, of length at most pi.
template <class Scalar = double>
inline vector3<Scalar> log(const vector4<Scalar>& q) {
  const Scalar w = q[3] < 0 ? -q[3] : q[3], sign = q[3] < 0 ? -1 : 1;
  const vector3<Scalar> v = q.template head<3>();
  const Scalar n = math::sqrt(math::dot(v, v));
  return (n < 1e-10 ? 2.0 : 2 * math::atan2(n, w) / n) * sign * v;
}

// Roll about x, then pitch about the old y, then yaw about the old z.
template <class Scalar = double>
inline vector4<Scalar> from_roll_pitch_yaw(Scalar roll, Scalar pitch, Scalar yaw) {
  const auto x = math::sine_and_cosine(roll / 2), y = math::sine_and_cosine(pitch / 2),
             z = math::sine_and_cosine(yaw / 2);
  const vector4<Scalar> r{x.sine, 0, 0, x.cosine}, p{0, y.sine, 0, y.cosine}, w{0, 0, z.sine, z.cosine};
  return product(w, product(p, r));
}

// From the entries of the rotation matrix. At a pitch of +-pi/2 roll and yaw rotate about the same axis, and
// only their difference (at +pi/2) or sum (at -pi/2) is defined.
template <class Scalar = double>
CCA_INLINE Scalar roll(const vector4<Scalar>& q) {
  return math::atan2(2 * (q[3] * q[0] + q[1] * q[2]), 1 - 2 * (q[0] * q[0] + q[1] * q[1]));
}
template <class Scalar = double>
CCA_INLINE Scalar pitch(const vector4<Scalar>& q) {
  const Scalar s = 2 * (q[3] * q[1] - q[2] * q[0]);
  return math::asin(s > 1 ? 1 : s < -1 ? -1 : s);
}
template <class Scalar = double>
CCA_INLINE Scalar yaw(const vector4<Scalar>& q) {
  return math::atan2(2 * (q[3] * q[2] + q[0] * q[1]), 1 - 2 * (q[1] * q[1] + q[2] * q[2]));
}

// The shorter way at constant speed: a at t = 0, b at t = 1 (or -b, which is the same rotation).
template <class Scalar = double>
inline vector4<Scalar> slerp(const vector4<Scalar>& a, const vector4<Scalar>& b, Scalar t) {
  const Scalar sign = math::dot(a, b) < 0 ? -1 : 1;
  const vector4<Scalar> difference = a - sign * b, sum = a + sign * b;
  const Scalar angle =
      2 * math::atan2(math::sqrt(math::dot(difference, difference)), math::sqrt(math::dot(sum, sum)));
  if (angle < 1e-6)
    return normalised(vector4<Scalar>(
        (1 - t) * a + t * sign * b));  // here sin(angle) is too small to divide by; the chord equals the arc
  const Scalar s = math::sin(angle);
  return (math::sin((1 - t) * angle) / s) * a + (sign * math::sin(t * angle) / s) * b;
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

// Of a rotation matrix. Divides by the largest of the four squares, for precision (Shepperd 1978).
template <class Scalar = double>
inline vector4<Scalar> from_matrix(const Eigen::Matrix<Scalar, 3, 3>& m) {
  const Scalar trace = m(0, 0) + m(1, 1) + m(2, 2);
  int largest = 3;
  Scalar most = trace;
  for (int i = 0; i < 3; ++i)
    if (m(i, i) > most) largest = i, most = m(i, i);
  vector4<Scalar> q;
  if (largest == 3) {
    q << m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1), 1 + trace;
  } else {
    const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
    q[i] = 1 + 2 * m(i, i) - trace;
    q[j] = m(j, i) + m(i, j);
    q[k] = m(k, i) + m(i, k);
    q[3] = m(k, j) - m(j, k);
  }
  return normalised(q);
}

}  // namespace cca::rotation
