// A box in the world at one moment, and what of it a point, a sphere or a capsule touches.
//
// Outside of it its nearest point decides, inside its nearest face. `touches(feature, depth, at, normal)` is
// called with what is less than `margin` away: where the shape's surface is deepest and the box's normal
// there, which points into the shape; along the world's axes, m.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/scalar.hpp>
#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

template <class Real>
struct nearest_on_box {
  Real distance{};        // m; below 0: it is inside
  triple<Real> normal{};  // along the box's axes
};

template <class Real>
struct box_form {
  placed_frame<Real> frame{};
  triple<Real> half{};

  constexpr triple<Real> inside(const triple<Real>& world) const { return along(frame, world - frame.at); }

  constexpr nearest_on_box<Real> nearest(const triple<Real>& p) const {
    const triple<Real> off = beyond(p);
    const Real square = dot(off, off), zero(0.0);
    if (square > zero) {
      const Real far = root(square);
      return {far, (Real(1.0) / far) * off};
    }
    nearest_on_box<Real> best;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real sign = select(p[k] < zero, Real(-1.0), Real(1.0)), deep = sign * p[k] - half[k];
      if (k > 0 && !(deep > best.distance)) continue;
      best = {deep, {}};
      best.normal[k] = sign;
    }
    return best;
  }
  // From the nearest point of the box; of a point inside zero.
  constexpr triple<Real> beyond(const triple<Real>& p) const {
    triple<Real> off;
    const Real zero(0.0);
    for (std::size_t k = 0; k < 3; ++k) off[k] = larger(p[k] - half[k], zero) + smaller(p[k] + half[k], zero);
    return off;
  }

  template <class F>
  constexpr void touch_sphere(const triple<Real>& centre,
                              const Real& radius,
                              F touches,
                              int feature = 0) const {
    const nearest_on_box<Real> n = nearest(inside(centre));
    if (!(n.distance < radius)) return;
    const triple<Real> normal = frame.direction(n.normal);
    touches(feature, radius - n.distance, centre - radius * normal, normal);
  }

  // A capsule touches at both ends of the piece of its line above the face that is nearest, or, where that is
  // deeper, at its deepest point: an end, or a place in its middle across an edge.
  template <class F>
  constexpr void touch_capsule(const triple<Real>& from,
                               const triple<Real>& to,
                               const Real& radius,
                               F touches) const {
    const triple<Real> p = inside(from), way = inside(to) - p;
    const Real deepest = deepest_of(p, way);
    const triple<Real> normal = nearest(p + deepest * way).normal;
    const Real zero(0.0), one(1.0);
    Real begin = zero, end = one;
    const std::size_t face = largest(normal);
    for (std::size_t k = 0; k < 3; ++k)
      if (k != face) clip(p[k], way[k], half[k], begin, end);
    if (end < begin) begin = end = deepest;
    begin = smaller(begin, deepest), end = larger(end, deepest);
    touch_sphere(from + begin * (to - from), radius, touches, 0);
    if (begin < end) touch_sphere(from + end * (to - from), radius, touches, 1);
  }

private:
  static constexpr std::size_t largest(const triple<Real>& v) {
    std::size_t most = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (v[most] * v[most] < v[k] * v[k]) most = k;
    return most;
  }
  // What of the line from `p` lies between two faces.
  static constexpr void clip(const Real& p, const Real& way, const Real& half, Real& begin, Real& end) {
    const Real zero(0.0), none(2.0);
    const auto is_level = way * way < Real(1e-24);
    const Real level_begin = select(p > half, none, select(p < -half, none, zero));
    const Real by = select(is_level, Real(1.0), way), a = (-half - p) / by, b = (half - p) / by;
    begin = larger(begin, select(is_level, level_begin, smaller(a, b)));
    end = smaller(end, select(is_level, Real(1.0), larger(a, b)));
  }
  // Where on the line from p the distance to the box is least: that is convex, and its square is made of
  // pieces of second order, which begin where the line crosses the plane of a face.
  constexpr Real deepest_of(const triple<Real>& p, const triple<Real>& way) const {
    const Real zero(0.0), one(1.0);
    const auto slope = [&](const Real& t) { return dot(beyond(p + t * way), way); };
    Real low = zero, high = one;
    for (std::size_t k = 0; k < 3; ++k)
      for (const Real& face : {half[k], -half[k]}) {
        const Real t = (face - p[k]) / select(way[k] * way[k] < Real(1e-24), Real(1e-12), way[k]);
        if (!(t > low) || !(t < high)) continue;
        if (slope(t) < zero) low = t;
        else high = t;
      }
    const Real falls = slope(low), rises = slope(high);
    if (!(falls < zero)) return low;
    if (!(rises > zero)) return high;
    return low + (high - low) * (falls / (falls - rises));
  }
};

}  // namespace cca::sim::detail
