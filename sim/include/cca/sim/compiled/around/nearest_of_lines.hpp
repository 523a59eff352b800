// Where two lines with ends are nearest to each other. Source: Ericson, Real-Time Collision Detection, 2005,
// section 5.1.9.
#pragma once

#include <cca/sim/compiled/scalar.hpp>
#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

template <class Real>
struct nearest_points {
  triple<Real> here{}, there{};
};

// Each from its middle by `half` to both sides; a half of 0 is a point.
template <class Real>
constexpr nearest_points<Real> nearest_of_lines(const triple<Real>& middle,
                                                const triple<Real>& half,
                                                const triple<Real>& other_middle,
                                                const triple<Real>& other_half) {
  const Real zero(0.0), one(1.0), small(1e-18);
  const triple<Real> off = middle - other_middle;
  const Real a = dot(half, half), b = dot(half, other_half), e = dot(other_half, other_half),
             c = dot(half, off), f = dot(other_half, off), det = a * e - b * b;
  const auto share = [&](const Real& above, const Real& below) {
    return below > small ? between(-one, above / below, one) : zero;
  };
  // Of parallel lines any place would do that both have: the middle of what they share.
  Real s = det > Real(1e-12) * a * e ? between(-one, (b * f - c * e) / det, one) : share(-c, a);
  const Real t = share(b * s + f, e);
  s = share(b * t - c, a);
  return {middle + s * half, other_middle + t * other_half};
}

// Where two lines with ends that run side by side have their last place in common, towards the end of the
// first one: the end of one of them, and the nearest point of the other one.
template <class Real>
constexpr nearest_points<Real> last_of_lines(const triple<Real>& middle,
                                             const triple<Real>& half,
                                             const triple<Real>& other_middle,
                                             const triple<Real>& other_half) {
  const Real one(1.0);
  const bool is_same_way = dot(half, other_half) > Real(0.0);
  const triple<Real> end = middle + half,
                     other_end = is_same_way ? other_middle + other_half : other_middle - other_half;
  const Real along = dot(other_end - middle, half), length = dot(half, half);
  if (!(along > length) && !(Real(-1.0) * length > along))
    return {middle + (along / length) * half, other_end};
  const Real share = dot(end - other_middle, other_half) / dot(other_half, other_half);
  return {end, other_middle + between(-one, share, one) * other_half};
}

// Across both lines: where they meet, each is pushed out this way.
template <class Real>
constexpr triple<Real> across_lines(const triple<Real>& half, const triple<Real>& other_half) {
  const triple<Real> both = cross(half, other_half);
  if (const Real size = dot(both, both); size > Real(1e-9) * dot(half, half) * dot(other_half, other_half))
    return (Real(1.0) / root(size)) * both;
  const triple<Real>& line = dot(half, half) > dot(other_half, other_half) ? half : other_half;
  const triple<Real> x{Real(1.0), Real(0.0), Real(0.0)}, y{Real(0.0), Real(1.0), Real(0.0)};
  const bool is_along_x = line[0] * line[0] > line[1] * line[1];
  const triple<Real> aside = cross(line, is_along_x ? y : x);
  const Real size = dot(aside, aside);
  return size > Real(0.0) ? (Real(1.0) / root(size)) * aside : x;
}

}  // namespace cca::sim::detail
