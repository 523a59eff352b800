// Spatial vectors and inertias, all about the origin of the base of a body and along its axes.
//
// A motion is angular velocity, then the velocity of the point at the base's origin; a load or a momentum is
// the moment about the base's origin, then the force. In one common frame the inertia of a composite body is
// the sum of those of its links, with no transform between links: Featherstone, Rigid Body Dynamics
// Algorithms, 2008, chapter 2 and section 6.3. Units: SI.
// NaN and infinity make results that are not finite; nothing is kept.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/math/reductions.hpp>
#include <cca/robot/body_dynamics.hpp>

namespace cca {
namespace detail {

using vector6 = Eigen::Matrix<double, 6, 1>;
using matrix6 = Eigen::Matrix<double, 6, 6>;

inline vector3 cross(const vector3& a, const vector3& b) { return rotation::cross<double>(a, b); }
inline vector6 spatial(const vector3& angular, const vector3& linear) {
  vector6 v;
  v.head<3>() = angular;
  v.tail<3>() = linear;
  return v;
}
inline vector3 angular(const vector6& v) { return v.head<3>(); }
inline vector3 linear(const vector6& v) { return v.tail<3>(); }

// The power of a load along a motion. Added in pairs of lanes, which all machines have or imitate: in halves,
// three and three, it would take twice the instructions.
inline double power(const vector6& motion, const vector6& load) {
  using pair = some_lanes<2>::vector;
  const auto part = [](const vector6& v, int i) { return math::detail::loaded<pair>(v.data() + i); };
  const pair sum =
      part(motion, 0) * part(load, 0) + part(motion, 2) * part(load, 2) + part(motion, 4) * part(load, 4);
  return sum[0] + sum[1];
}

// The change of a motion, and of a load, that moves along with v (Featherstone 2008, section 2.9).
inline vector6 cross_motion(const vector6& v, const vector6& m) {
  const vector3 w = angular(v);
  return spatial(cross(w, angular(m)), cross(w, linear(m)) + cross(linear(v), angular(m)));
}
inline vector6 cross_load(const vector6& v, const vector6& f) {
  const vector3 w = angular(v);
  return spatial(cross(w, angular(f)) + cross(linear(v), linear(f)), cross(w, linear(f)));
}

// The cross product as a matrix: skew(a) b = a x b.
inline matrix3 skew(const vector3& a) {
  matrix3 m;
  m << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return m;
}

// The motion of a joint per unit of its coordinate.
inline vector6 motion_of(const body_link& l, const placed_link& at) {
  const vector3 a = l.ratio * at.axis;
  if (l.kind == joint_kind::prismatic) return spatial(vector3::Zero(), a);
  return spatial(a, cross(at.frame.at, a));
}

// A rigid body, or several that move as one: mass, mass times centre, inertia about the base's origin.
struct spatial_inertia {
  double mass = 0;
  vector3 moment = vector3::Zero();
  matrix3 about = matrix3::Zero();

  spatial_inertia() = default;
  spatial_inertia(const link_inertia& of, const rigid& where) : mass(of.mass) {
    const vector3 c = where.at + math::product(where.turn, as_vector(of.centre));
    moment = mass * c;
    about = math::product(where.turn, math::product(matrix_of(of.about_centre), where.turn.transpose())) -
            moment * c.transpose();
    about.diagonal().array() += math::dot(moment, c);
  }
  explicit spatial_inertia(const link_inertia& of)
      : mass(of.mass), moment(of.mass * as_vector(of.centre)), about(matrix_of(of.about_centre)) {
    about -= moment * as_vector(of.centre).transpose();
    about.diagonal().array() += math::dot(moment, as_vector(of.centre));
  }

  spatial_inertia& operator+=(const spatial_inertia& b) {
    mass += b.mass;
    moment += b.moment;
    about += b.about;
    return *this;
  }

  // Momentum from a motion, load from an acceleration.
  vector6 operator*(const vector6& v) const {
    const vector3 w = angular(v), u = linear(v);
    return spatial(math::product(about, w) + cross(moment, u), mass * u - cross(moment, w));
  }

  matrix6 matrix() const {
    matrix6 m;
    const matrix3 h = skew(moment);
    m.topLeftCorner<3, 3>() = about;
    m.topRightCorner<3, 3>() = h;
    m.bottomLeftCorner<3, 3>() = -h;
    m.bottomRightCorner<3, 3>() = mass * matrix3::Identity();
    return m;
  }
};

// For each link: the motion of its joint, and the load that gives the link and all links behind it a unit of
// that motion (Featherstone 2008, section 6.2). `all` is the inertia of the whole body with its base.
template <std::size_t Count>
struct composite_bodies {
  std::array<vector6, Count> motion, load;
  spatial_inertia all;

  composite_bodies(const std::array<body_link, Count>& links,
                   const std::array<placed_link, Count>& placed,
                   const link_inertia& base)
      : all(base) {
    std::array<spatial_inertia, Count> composite;
    for (std::size_t i = 0; i < Count; ++i) composite[i] = {links[i].inertia, placed[i].frame};
    for (std::size_t i = Count; i-- > 0;) {
      motion[i] = motion_of(links[i], placed[i]);
      load[i] = composite[i] * motion[i];
      (links[i].parent < 0 ? all : composite[static_cast<std::size_t>(links[i].parent)]) += composite[i];
    }
  }
};

// The motion of each link; `root` is that of the base.
template <std::size_t Count, class Vector>
std::array<vector6, Count> motions_of(const std::array<body_link, Count>& links,
                                      const std::array<placed_link, Count>& placed,
                                      const Vector& dq,
                                      const vector6& root = vector6::Zero()) {
  std::array<vector6, Count> v;
  for (std::size_t i = 0; i < Count; ++i)
    v[i] = (links[i].parent < 0 ? root : v[static_cast<std::size_t>(links[i].parent)]) +
           dq[links[i].coordinate] * motion_of(links[i], placed[i]);
  return v;
}

}  // namespace detail
}  // namespace cca
