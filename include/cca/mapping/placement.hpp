// A placement: the constant position and orientation of one frame in another. It is for built-in transforms
// of a robot, not for moving ones.
//
//   struct hip_in_trunk : cca::placed<hip, trunk> {
//     static constexpr auto where = cca::at(0.1175, 0.075, 0.0);
//   };
//
// A placement is a translation in m and a rotation, a unit quaternion x, y, z, w. It takes coordinates in the
// frame of the thing to coordinates in the other frame. `a * b` is b placed in a. `turned_about(axis, angle)`
// and `at(x, y, z)` make one, at compile time. Precondition: an axis has a length other than 0.
#pragma once

#include <array>
#include <numbers>

#include <cca/space/frame.hpp>
#include <cca/space/methods/rotation.hpp>

namespace cca {

struct placement {
  std::array<double, 3> translation{};
  std::array<double, 4> rotation{0, 0, 0, 1};

  friend constexpr bool operator==(const placement&, const placement&) = default;
};

inline constexpr std::array<double, 3> along_x{1, 0, 0}, along_y{0, 1, 0}, along_z{0, 0, 1};

namespace detail {

// The sine at compile time: quarter turns, and a Taylor series within [-pi/4, pi/4] with a remainder below
// 1e-19.
constexpr double series_of_sine(double x, bool cosine) {
  double term = cosine ? 1 : x, sum = term;
  for (int n = cosine ? 1 : 2; n < 20; n += 2) sum += term *= -x * x / (n * (n + 1));
  return sum;
}
constexpr double constant_sine(double x, int quarter = 0) {
  constexpr double quarter_turn = 1.57079632673412561417,
                   rest = 6.07710050650619224932e-11;  // quarter_turn has 33 bits: its multiples are exact
  const auto turns = static_cast<long long>(x / quarter_turn + (x < 0 ? -0.5 : 0.5));
  const double within = (x - static_cast<double>(turns) * quarter_turn) - static_cast<double>(turns) * rest;
  const auto q = ((turns + quarter) % 4 + 4) % 4;
  const double s = series_of_sine(within, q % 2 != 0);
  return q < 2 ? s : -s;
}
constexpr double constant_cosine(double x) { return constant_sine(x, 1); }

// The square root by Newton's method: starting above the root, it falls until it no longer changes.
constexpr double constant_root(double square) {
  if (square <= 0) return 0;
  double root = square > 1 ? square : 1;
  for (double next = (root + square / root) / 2; next < root; next = (root + square / root) / 2) root = next;
  return root;
}

constexpr std::array<double, 3> turned_by(const std::array<double, 4>& q, const std::array<double, 3>& v) {
  const double tx = 2 * (q[1] * v[2] - q[2] * v[1]), ty = 2 * (q[2] * v[0] - q[0] * v[2]),
               tz = 2 * (q[0] * v[1] - q[1] * v[0]);
  return {v[0] + q[3] * tx + q[1] * tz - q[2] * ty, v[1] + q[3] * ty + q[2] * tx - q[0] * tz,
          v[2] + q[3] * tz + q[0] * ty - q[1] * tx};
}

}  // namespace detail

constexpr placement at(double x, double y, double z) { return {{x, y, z}}; }

constexpr placement turned_about(const std::array<double, 3>& axis, double angle) {
  const double length = detail::constant_root(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  const double s = detail::constant_sine(angle / 2) / length;
  return {{}, {s * axis[0], s * axis[1], s * axis[2], detail::constant_cosine(angle / 2)}};
}

// b is given in the frame that a places; the result is in the frame in which a is given.
constexpr placement operator*(const placement& a, const placement& b) {
  const auto &p = a.rotation, &q = b.rotation;
  const auto moved = detail::turned_by(p, b.translation);
  return {{moved[0] + a.translation[0], moved[1] + a.translation[1], moved[2] + a.translation[2]},
          {p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
           p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
           p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3],
           p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]}};
}

constexpr placement inverse(const placement& a) {
  const std::array<double, 4> back{-a.rotation[0], -a.rotation[1], -a.rotation[2], a.rotation[3]};
  const auto moved = detail::turned_by(back, a.translation);
  return {{-moved[0], -moved[1], -moved[2]}, back};
}

// Base of a named struct with a constant `where`: the placement of the frame Thing in Frame.
template <class Thing, class Frame>
struct placed {
  using thing = Thing;
  using frame = Frame;
};

template <class Type> concept Placed = requires {
  typename Type::thing;
  typename Type::frame;
  { Type::where } -> std::convertible_to<placement>;
};

// The placement of Frame in Thing.
template <Placed Where>
struct inverse_of : placed<typename Where::frame, typename Where::thing> {
  static constexpr placement where = inverse(Where::where);
};

namespace detail {

inline vector3 as_vector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
inline vector4 as_vector(const std::array<double, 4>& a) { return {a[0], a[1], a[2], a[3]}; }

}  // namespace detail
}  // namespace cca
