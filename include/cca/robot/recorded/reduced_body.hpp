// The numbers of a body, prepared for recordings: as many as possible are 0 or 1.
//
//   reduced_body_of<Body>     links, base, and the joint values on which they depend
//
// The motion of a body does not change if the frame of a link is chosen differently, or if mass moves from a
// link to the one before it where the joint between them can't tell the difference. So here
//   - each joint turns about, or moves along, x, y or z of its own frame (`axis`), and its angle at zero is
//     part of the constant rotation
//   - the origin of a link behind a revolute joint lies on its axis where the offset from the link before has
//     the most zeros: of two axes that meet, at their intersection
//   - what a joint can't feel of a link is part of the link before it (base parameters; Khalil and Dombre,
//     Modeling, Identification and Control of Robots, 2002, section 9.4). Behind a revolute joint that is a
//     rod along the axis: all of the mass, the first and the second moment along the axis. Behind a prismatic
//     one all second moments.
//   - entries of rotations within 1e-14 of 0, 1 or -1 are these.
// Joints whose angles are the same but for their sign share a sine and a cosine.
#pragma once

#include <array>
#include <cstddef>

#include <cca/robot/body_tree.hpp>

namespace cca::detail {

using constant3 = std::array<double, 3>;
using constant33 = std::array<double, 9>;  // by columns

constexpr double size_of(double x) { return x < 0 ? -x : x; }
constexpr constant3 product(const constant33& m, const constant3& v) {
  constant3 u{};
  for (std::size_t r = 0; r < 3; ++r) u[r] = m[r] * v[0] + m[r + 3] * v[1] + m[r + 6] * v[2];
  return u;
}
constexpr constant33 transposed(const constant33& m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}
constexpr constant33 product(const constant33& a, const constant33& b) {
  constant33 m{};
  for (std::size_t c = 0; c < 3; ++c) {
    const constant3 column = product(a, constant3{b[3 * c], b[3 * c + 1], b[3 * c + 2]});
    for (std::size_t r = 0; r < 3; ++r) m[r + 3 * c] = column[r];
  }
  return m;
}

// Mass, mass times centre, and the second moments of the mass about the origin: xx, yy, zz, xy, xz, yz.
struct mass_moments {
  double mass = 0;
  constant3 first{};
  std::array<double, 6> second{};

  static constexpr std::size_t index(std::size_t r, std::size_t c) { return r == c ? r : r + c + 2; }
  constexpr double at(std::size_t r, std::size_t c) const { return second[index(r, c)]; }

  constexpr mass_moments() = default;
  constexpr explicit mass_moments(const link_inertia& of) : mass(of.mass) {
    const auto& i = of.about_centre;
    const double half = (i[0] + i[1] + i[2]) / 2;
    for (std::size_t r = 0; r < 3; ++r) {
      first[r] = mass * of.centre[r];
      for (std::size_t c = r; c < 3; ++c)
        second[index(r, c)] = (r == c ? half : 0) - i[index(r, c)] + mass * of.centre[r] * of.centre[c];
    }
  }
  // The same mass as a frame sees it in which its own frame is placed so.
  constexpr mass_moments seen_from(const constant33& turn, const constant3& origin) const {
    mass_moments m;
    m.mass = mass;
    const constant3 h = product(turn, first);
    for (std::size_t r = 0; r < 3; ++r) {
      m.first[r] = h[r] + mass * origin[r];
      for (std::size_t c = r; c < 3; ++c) {
        double sum = origin[r] * h[c] + h[r] * origin[c] + mass * origin[r] * origin[c];
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t l = 0; l < 3; ++l) sum += turn[r + 3 * k] * at(k, l) * turn[c + 3 * l];
        m.second[index(r, c)] = sum;
      }
    }
    return m;
  }
  constexpr mass_moments& operator+=(const mass_moments& b) {
    mass += b.mass;
    for (std::size_t k = 0; k < 3; ++k) first[k] += b.first[k];
    for (std::size_t k = 0; k < 6; ++k) second[k] += b.second[k];
    return *this;
  }
};

struct reduced_link {
  int parent = -1;
  bool revolute = true, straight = true;  // straight: `turn` is the identity
  int coordinate = 0;
  double ratio = 1;
  std::size_t axis = 2;
  int value = 0;      // its joint value
  bool back = false;  // turns by minus that angle
  constant3 at{};
  constant33 turn{1, 0, 0, 0, 1, 0, 0, 0, 1};
  mass_moments mass{};
};

// An angle of revolute joints, |ratio| times a coordinate; or ratio times that of a prismatic joint.
struct joint_value {
  bool revolute = true;
  int coordinate = 0;
  double ratio = 1;
};

template <std::size_t Count>
struct reduced_body {
  std::array<reduced_link, Count> links{};
  std::array<constant33, Count> own{};   // frames here in those of body_link: rotation,
  std::array<constant3, Count> shift{};  // and origin
  std::array<joint_value, Count> values{};
  int value_count = 0;
  mass_moments base{};
};

// A rotation about an axis: Rodrigues.
constexpr constant33 turn_about(const constant3& z, double angle) {
  const double s = constant_sine(angle), c = constant_cosine(angle), v = 1 - c;
  return {c + v * z[0] * z[0],        v * z[0] * z[1] + s * z[2], v * z[0] * z[2] - s * z[1],
          v * z[0] * z[1] - s * z[2], c + v * z[1] * z[1],        v * z[1] * z[2] + s * z[0],
          v * z[0] * z[2] + s * z[1], v * z[1] * z[2] - s * z[0], c + v * z[2] * z[2]};
}
// A frame whose z is this axis.
constexpr constant33 frame_with_z(const constant3& z) {
  constant3 x = size_of(z[0]) > 0.5 ? constant3{0, 1, 0} : constant3{1, 0, 0};
  const double along = x[0] * z[0] + x[1] * z[1] + x[2] * z[2];
  for (std::size_t k = 0; k < 3; ++k) x[k] -= along * z[k];
  const double length = constant_root(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  for (double& e : x) e /= length;
  return {x[0], x[1], x[2], z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0],
          z[0], z[1], z[2]};
}
constexpr constant33 cleaned(constant33 m) {
  for (double& x : m)
    for (const double whole : {-1.0, 0.0, 1.0})
      if (size_of(x - whole) < 1e-14) x = whole;
  return m;
}
constexpr constant3 cleaned(constant3 v) {
  for (double& x : v)
    if (size_of(x) < 1e-15) x = 0;
  return v;
}
constexpr void clean(mass_moments& m) {
  double most = 0;
  for (const double x : m.second)
    if (size_of(x) > most) most = size_of(x);
  for (double& x : m.second)
    if (size_of(x) < 1e-15 * most) x = 0;
  most = 0;
  for (const double x : m.first)
    if (size_of(x) > most) most = size_of(x);
  for (double& x : m.first)
    if (size_of(x) < 1e-15 * most) x = 0;
}

// How far along the axis of a joint to move its origin so that most of its offset is zero.
constexpr double best_shift(const constant3& at, const constant3& axis) {
  const auto zeros = [&](double shift) {
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k) count += size_of(at[k] + shift * axis[k]) < 1e-15;
    return count;
  };
  double best = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (size_of(axis[k]) > 0.1)
      if (const double shift = -at[k] / axis[k]; zeros(shift) > zeros(best)) best = shift;
  return best;
}

template <std::size_t Count>
constexpr reduced_body<Count> reduced(const std::array<body_link, Count>& given, const link_inertia& base) {
  reduced_body<Count> b;
  b.base = mass_moments(base);
  for (std::size_t i = 0; i < Count; ++i) {
    const body_link& g = given[i];
    reduced_link& l = b.links[i];
    l.parent = g.parent, l.coordinate = g.coordinate, l.ratio = g.ratio;
    l.revolute = g.kind == joint_kind::revolute;
    constant3 at = g.at;
    constant33 turn = g.turn;
    b.own[i] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (g.rest != 0) {
      const constant3 axis = product(turn, g.axis);
      if (l.revolute) turn = product(turn, turn_about(g.axis, g.rest));
      else
        for (std::size_t k = 0; k < 3; ++k) at[k] += g.rest * axis[k];
    }
    bool principal = false;
    for (std::size_t k = 0; k < 3; ++k)
      if (size_of(size_of(g.axis[k]) - 1) < 1e-14) {
        l.axis = k, principal = true;
        if (g.axis[k] < 0) l.ratio = -l.ratio;
      }
    if (!principal) b.own[i] = frame_with_z(g.axis), turn = product(turn, b.own[i]);
    if (g.parent >= 0) {
      const auto p = static_cast<std::size_t>(g.parent);
      for (std::size_t k = 0; k < 3; ++k) at[k] -= b.shift[p][k];
      at = product(transposed(b.own[p]), at), turn = product(transposed(b.own[p]), turn);
    }
    l.turn = cleaned(turn);
    l.straight = l.turn == constant33{1, 0, 0, 0, 1, 0, 0, 0, 1};
    l.at = cleaned(at);
    if (l.revolute) {
      const constant3 axis{l.turn[3 * l.axis], l.turn[3 * l.axis + 1], l.turn[3 * l.axis + 2]};
      const double by = best_shift(l.at, axis);
      for (std::size_t k = 0; k < 3; ++k)
        l.at[k] += by * axis[k], b.shift[i][k] = by * b.own[i][k + 3 * l.axis];
      l.at = cleaned(l.at);
    }
    constant3 moved = product(transposed(b.own[i]), b.shift[i]);
    for (double& x : moved) x = -x;
    l.mass = mass_moments(g.inertia).seen_from(transposed(b.own[i]), moved);

    l.back = l.revolute && l.ratio < 0;
    const double ratio = l.back ? -l.ratio : l.ratio;
    for (l.value = 0; l.value < b.value_count; ++l.value) {
      const joint_value& v = b.values[static_cast<std::size_t>(l.value)];
      if (v.revolute == l.revolute && v.coordinate == l.coordinate && v.ratio == ratio) break;
    }
    if (l.value == b.value_count)
      b.values[static_cast<std::size_t>(b.value_count++)] = {l.revolute, l.coordinate, ratio};
  }
  for (std::size_t i = Count; i-- > 0;) {
    reduced_link& l = b.links[i];
    mass_moments unfelt;
    if (l.revolute) {
      unfelt.mass = l.mass.mass;
      unfelt.first[l.axis] = l.mass.first[l.axis];
      unfelt.second[l.axis] = l.mass.second[l.axis];
      l.mass.mass = l.mass.first[l.axis] = l.mass.second[l.axis] = 0;
    } else {
      unfelt.second = l.mass.second;
      l.mass.second = {};
    }
    clean(l.mass);
    (l.parent < 0 ? b.base : b.links[static_cast<std::size_t>(l.parent)].mass) +=
        unfelt.seen_from(l.turn, l.at);
  }
  return b;
}

template <class Body>
inline constexpr auto reduced_body_of = reduced(body_tree_of<Body>.links, base_inertia_of<Body>());

}  // namespace cca::detail
