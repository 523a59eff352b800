// Where two boxes touch: corners, edges and faces.
//
// The axis along which they overlap least decides, of the normals of the faces and the products of the edges.
// Of a face, the other box's face that looks at it is cut off at its sides; up to eight points of that one
// are below it. Of two edges, their nearest points touch. `touches` as in box_form.hpp; the second box is the
// shape. Sources: Gottschalk, Lin and Manocha, OBBTree, 1996, section 5; cutting: Sutherland and Hodgman,
// Reentrant polygon clipping, 1974.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/around/box_form.hpp>

namespace cca::sim::detail {

template <class Real>
class box_on_box {
public:
  constexpr box_on_box(const box_form<Real>& fixed, const box_form<Real>& shape) : one(fixed), other(shape) {}

  template <class F>
  constexpr void touch(F touches) const {
    const triple<Real> way = one.inside(other.frame.at);
    triple<Real> axes[3];  // of the shape, along those of the other
    for (std::size_t j = 0; j < 3; ++j) axes[j] = along(one.frame, other.frame.axes[j]);
    overlap best{Real(1e300), -1, {}};
    const auto look = [&](const triple<Real>& axis, int kind, double worse) {
      const Real far = dot(way, axis);
      Real reach{};
      for (std::size_t k = 0; k < 3; ++k)
        reach = reach + size(axis[k]) * one.half[k] + size(dot(axis, axes[k])) * other.half[k];
      const Real depth = reach - size(far);
      if (Real(worse) * depth < best.depth)
        best = {depth, kind, select(far < Real(0.0), Real(-1.0), Real(1.0)) * axis};
      return depth > Real(0.0);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      triple<Real> axis;
      axis[k] = Real(1.0);
      if (!look(axis, static_cast<int>(k), 1)) return;
    }
    for (std::size_t j = 0; j < 3; ++j)
      if (!look(axes[j], static_cast<int>(3 + j), 1 + 1e-6)) return;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j) {
        triple<Real> edge;
        edge[k] = Real(1.0);
        const triple<Real> axis = cross(edge, axes[j]);
        const Real square = dot(axis, axis);
        if (!(square > Real(1e-6))) continue;  // parallel: a face is better
        if (!look((Real(1.0) / root(square)) * axis, static_cast<int>(6 + 3 * k + j), 1.05)) return;
      }
    if (best.kind < 3) at_face(one, other, static_cast<std::size_t>(best.kind), best.axis, false, touches);
    else if (best.kind < 6)
      at_face(other, one, static_cast<std::size_t>(best.kind - 3), Real(-1.0) * best.axis, true, touches);
    else at_edges(way, axes, best, touches);
  }

private:
  struct overlap {
    Real depth;
    int kind;           // 0 to 2: a face of the fixed box; 3 to 5: of the shape; from 6 on: edges
    triple<Real> axis;  // along the fixed box's axes, towards the shape
  };
  static constexpr Real size(const Real& x) { return larger(x, -x); }
  static constexpr Real sign(const Real& x) { return select(x < Real(0.0), Real(-1.0), Real(1.0)); }

  // The corners of a face, cut off.
  struct polygon {
    std::array<triple<Real>, 8> corner{};
    std::size_t count = 0;

    constexpr void add(const triple<Real>& p) {
      if (count < corner.size()) corner[count++] = p;
    }
    // What is not beyond `side * most` along an axis.
    constexpr polygon cut(std::size_t axis, const Real& side, const Real& most) const {
      polygon left;
      for (std::size_t i = 0; i < count; ++i) {
        const triple<Real>&p = corner[i], &q = corner[i + 1 < count ? i + 1 : 0];
        const Real a = side * p[axis] - most, b = side * q[axis] - most, zero(0.0);
        const bool stays = !(a > zero), next_stays = !(b > zero);
        if (stays) left.add(p);
        if (stays != next_stays) left.add(p + (a / (a - b)) * (q - p));
      }
      return left;
    }
  };

  // At the face `k` of `of`. `axis`: its normal, along the fixed box's axes, towards `to`.
  template <class F>
  constexpr void at_face(const box_form<Real>& of,
                         const box_form<Real>& to,
                         std::size_t k,
                         const triple<Real>& axis,
                         bool is_shape,
                         F& touches) const {
    const triple<Real> normal = one.frame.direction(axis);  // in the world
    const Real side = sign(dot(normal, of.frame.axes[k]));
    const triple<Real> middle = of.inside(to.frame.at);
    triple<Real> axes[3];
    std::size_t looks = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      axes[j] = along(of.frame, to.frame.axes[j]);
      if (size(axes[looks][k]) < size(axes[j][k])) looks = j;
    }
    const triple<Real> face = middle - (sign(side * axes[looks][k]) * to.half[looks]) * axes[looks];
    const std::size_t u = (looks + 1) % 3, v = (looks + 2) % 3;
    const triple<Real> across = to.half[u] * axes[u], up = to.half[v] * axes[v];
    polygon seen;
    seen.add(face + across + up), seen.add(face - across + up);
    seen.add(face - across - up), seen.add(face + across - up);
    for (std::size_t j = 0; j < 3; ++j) {
      if (j == k) continue;
      seen = seen.cut(j, Real(1.0), of.half[j]);
      seen = seen.cut(j, Real(-1.0), of.half[j]);
    }
    for (std::size_t i = 0; i < seen.count; ++i) {
      const Real depth = of.half[k] - side * seen.corner[i][k];
      if (!(depth > Real(0.0))) continue;
      const triple<Real> at = of.frame.at + of.frame.direction(seen.corner[i]);
      if (is_shape) touches(static_cast<int>(i), depth, at + depth * normal, Real(-1.0) * normal);
      else touches(static_cast<int>(i), depth, at, normal);
    }
  }

  template <class F>
  constexpr void at_edges(const triple<Real>& way,
                          const triple<Real>* axes,
                          const overlap& best,
                          F& touches) const {
    const auto k = static_cast<std::size_t>(best.kind - 6) / 3,
               j = static_cast<std::size_t>(best.kind - 6) % 3;
    triple<Real> on_shape = way, on_fixed, edge;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i != j) on_shape = on_shape - (sign(dot(axes[i], best.axis)) * other.half[i]) * axes[i];
      if (i != k) on_fixed[i] = sign(best.axis[i]) * one.half[i];
    }
    edge[k] = Real(1.0);
    const Real both = axes[j][k];
    const triple<Real> apart = on_fixed - on_shape;
    const Real along_edge = (dot(axes[j], apart) - both * dot(edge, apart)) / (Real(1.0) - both * both);
    touches(0, best.depth, one.frame.at + one.frame.direction(on_shape + along_edge * axes[j]),
            one.frame.direction(best.axis));
  }

  const box_form<Real>&one, &other;
};

}  // namespace cca::sim::detail
