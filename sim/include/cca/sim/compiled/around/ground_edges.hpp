// Where the edge of a step, or the ridge where a slope turns down, touches a capsule or a box between its
// ends and corners.
//
// Seen along y, the edge is a point between two faces of the ground, and the shape a polygon, or a line with
// a radius. The side of the shape that the edge is least deep in decides, if its normal lies between those of
// the two faces, and if the shape is not less deep in one of the faces: there its ends or corners touch. Of
// the even and of the odd edges of a terrain the deepest one counts. It touches a capsule in a point, a box
// in one or two.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <cca/sim/compiled/around/ground.hpp>
#include <cca/sim/compiled/scalar.hpp>
#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

// Its part along x and up: what is seen along y.
template <class Real>
constexpr Real dot_in_profile(const triple<Real>& a, const triple<Real>& b) {
  return a[0] * b[0] + a[2] * b[2];
}

struct ground_edge {
  double x = 0, z = 0;             // m
  triple<double> left{}, right{};  // the normals of the faces on both sides
  bool sticks_out = false;

  static ground_edge between(const ground_strip& before, const ground_strip& after, double floor) {
    const auto normal = [](const ground_strip& s) {
      return s.pitch == 0 ? triple<double>{0, 0, 1}
                          : triple<double>{-math::sin(s.pitch), 0, math::cos(s.pitch)};
    };
    const double x = after.begin, low = before.height(x), high = after.height(x);
    ground_edge e{x, floor + (low < high ? high : low), normal(before), normal(after)};
    if (low < high) e.left = {-1, 0, 0};
    if (high < low) e.right = {1, 0, 0};
    e.sticks_out = turn(e.left, e.right) < 0;
    return e;
  }
  // Between both faces' normals?
  template <class Real>
  bool faces(const triple<Real>& n) const {
    const triple<double> plain_n{plain(n[0]), 0, plain(n[2])};
    return turn(left, plain_n) <= 0 && turn(plain_n, right) <= 0;
  }

private:
  static double turn(const triple<double>& a, const triple<double>& b) { return a[0] * b[2] - a[2] * b[0]; }
};

// A middle, and in each direction of `spans` as far to both sides, all with a radius: a box has three spans,
// a capsule one. In the world, m.
template <class Real, std::size_t Spans>
struct spanned_shape {
  triple<Real> middle{};
  std::array<triple<Real>, Spans> spans{};
  double radius = 0;

  // How deep this place is in the shape along a direction, which points into the shape.
  constexpr Real depth(const triple<Real>& place, const triple<Real>& n) const {
    Real d = dot_in_profile(place - middle, n) + Real(radius);
    for (const auto& s : spans) {
      const Real along = dot_in_profile(s, n);
      d = d + larger(along, -along);
    }
    return d;
  }
};

template <class Real>
struct edge_touch {
  static constexpr std::size_t at_edge = 2, most = 2 * at_edge;

  Real depth{-1.0};                                            // m; below 0: none
  triple<Real> normal{Real(0.0), Real(0.0), Real(1.0)}, at{};  // into the shape; of its surface; in the world
};
template <class Real>
using edge_touches = std::array<edge_touch<Real>, edge_touch<Real>::most>;

// `f(its number, the edge)` for each edge that sticks out, at most `reach` from x.
template <class F>
void each_edge(const ground& g, double x, double reach, F f) {
  g.profile.edges_between(x - reach, x + reach, [&](std::int64_t i, const auto& before, const auto& after) {
    const ground_edge e = ground_edge::between(before, after, g.floor);
    if (e.sticks_out) f(i, e);
  });
}
// Whether an edge is less than `reach` from this place.
template <class Real>
bool is_edge_near(const ground& g, const triple<Real>& at, double reach) {
  bool is = false;
  const double z = plain(at[2]);
  each_edge(g, plain(at[0]), reach,
            [&](std::int64_t, const ground_edge& e) { is = is || (z - e.z < reach && e.z - z < reach); });
  return is;
}
// In one lane, of its ground.
template <class Real>
bool is_edge_near(const ground_in_lanes<Real>& g, const triple<Real>& at, double reach) {
  for (int k = 0; k < Real::count; ++k)
    if (is_edge_near(g.lane(k), lane_of(at, k), reach)) return true;
  return false;
}

namespace edges {

// Along the line of the shape through `middle`, in the direction of a span.
template <class Real>
void touch_line(const triple<Real>& middle,
                const triple<Real>& span,
                const triple<Real>& edge,
                const triple<Real>& n,
                const Real& depth,
                edge_touch<Real>& to) {
  const Real share = dot_in_profile(edge - middle, span) / dot_in_profile(span, span);
  if (plain(depth) > 0 && plain(share) > -1 && plain(share) < 1) to = {depth, n, middle + share * span};
}

// The side in the direction of a span whose normal is `n`, and the line across the face that looks most along
// `n`: with the two a face lies flat.
template <class Real, std::size_t Spans>
void touch_side(const spanned_shape<Real, Spans>& s,
                const triple<Real>& edge,
                std::size_t span,
                const triple<Real>& n,
                const Real& depth,
                edge_touch<Real>* to) {
  triple<Real> middle = s.middle - Real(s.radius) * n;
  std::size_t across = Spans;
  Real flattest{};
  for (std::size_t j = 0; j < Spans; ++j) {
    if (j == span) continue;
    const Real along = dot_in_profile(s.spans[j], n), tilt = along * along / dot(s.spans[j], s.spans[j]);
    middle = plain(along) > 0 ? middle - s.spans[j] : middle + s.spans[j];
    if (across == Spans || plain(tilt) < plain(flattest)) across = j, flattest = tilt;
  }
  if (across == Spans) return touch_line(middle, s.spans[span], edge, n, depth, to[0]);
  const Real along = dot_in_profile(s.spans[across], n);
  const bool is_after = plain(along) > 0;  // the deep line is the one before the middle
  const triple<Real> over = (is_after ? Real(2.0) : Real(-2.0)) * s.spans[across];
  touch_line(middle, s.spans[span], edge, n, depth, to[is_after ? 0 : 1]);
  touch_line(middle + over, s.spans[span], edge, n, depth - Real(2.0) * larger(along, -along),
             to[is_after ? 1 : 0]);
}

template <class Real, std::size_t Spans>
void touch(const spanned_shape<Real, Spans>& s, const ground_edge& e, edge_touch<Real>* deepest) {
  constexpr double level = 1e-12;  // m^2: a span along y has no side; same: m, of two depths
  constexpr double same = 1e-9;
  const triple<Real> edge{Real(e.x), Real(0.0), Real(e.z)};
  Real least{};
  triple<Real> normal{};
  std::size_t span = Spans;
  for (std::size_t k = 0; k < Spans; ++k) {
    const Real square = dot_in_profile(s.spans[k], s.spans[k]);
    if (plain(square) < level) continue;
    const Real size = Real(1.0) / root(square);
    const triple<Real> n{-size * s.spans[k][2], Real(0.0), size * s.spans[k][0]};
    for (const triple<Real>& out : {n, Real(-1.0) * n}) {
      const Real depth = s.depth(edge, out);
      if (!(plain(depth) > 0)) return;  // the edge is outside
      if (!e.faces(out) || (span < Spans && !(plain(depth) < plain(least)))) continue;
      least = depth, normal = out, span = k;
    }
  }
  if (span == Spans) return;
  for (std::size_t line = 0; line < edge_touch<Real>::at_edge; ++line)
    if (!(plain(least) > plain(deepest[line].depth))) return;
  for (const triple<double>& face : {e.left, e.right}) {
    const triple<Real> n{Real(face[0]), Real(0.0), Real(face[2])};
    if (plain(s.depth(edge, n)) < plain(least) - same) return;
  }
  for (std::size_t line = 0; line < edge_touch<Real>::at_edge; ++line) deepest[line] = {};
  touch_side(s, edge, span, normal, least, deepest);
}

}  // namespace edges

// First those of the even edges, then of the odd ones. `reach`: of a sphere about the middle that holds the
// shape.
template <class Real, std::size_t Spans>
edge_touches<Real> touches_of_edges(const ground& g, const spanned_shape<Real, Spans>& s, double reach) {
  edge_touches<Real> found{};
  each_edge(g, plain(s.middle[0]), reach, [&](std::int64_t i, const ground_edge& e) {
    edges::touch(s, e, &found[i % 2 == 0 ? 0 : edge_touch<Real>::at_edge]);
  });
  return found;
}
template <class Real, std::size_t Spans>
edge_touches<Real> touches_of_edges(const ground_in_lanes<Real>& g,
                                    const spanned_shape<Real, Spans>& s,
                                    double reach) {
  edge_touches<Real> found{};
  for (int k = 0; k < Real::count; ++k) {
    spanned_shape<double, Spans> one{lane_of(s.middle, k), {}, s.radius};
    for (std::size_t j = 0; j < Spans; ++j) one.spans[j] = lane_of(s.spans[j], k);
    const auto alone = touches_of_edges(g.lane(k), one, reach);
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i].depth.set(k, alone[i].depth);
      set_lane(found[i].normal, k, alone[i].normal), set_lane(found[i].at, k, alone[i].at);
    }
  }
  return found;
}

}  // namespace cca::sim::detail
