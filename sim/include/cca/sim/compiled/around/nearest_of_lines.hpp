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

}  // namespace cca::sim::detail
