// Angles on the circle, as ordinary functions, and differences of angles along axes of which some are
// continuous (space/dimension.hpp).
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include <cca/base/compiler.hpp>
#include <cca/base/eigen.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/space/limits.hpp>

namespace cca {

inline constexpr double pi = std::numbers::pi;

namespace detail {

// Of angles more than a turn away, which are rare.
[[gnu::noinline]] inline double wrap_far_signed(double angle) {
  const double wrapped = angle - 2 * pi * math::ceil((angle - pi) / (2 * pi));
  return wrapped > pi ? wrapped - 2 * pi : wrapped <= -pi ? wrapped + 2 * pi : wrapped;
}
[[gnu::noinline]] inline double wrap_far_turn(double angle) {
  const double wrapped = angle - 2 * pi * math::floor(angle / (2 * pi));
  return wrapped >= 2 * pi || wrapped < 0 ? 0.0 : wrapped;  // only rounding leads here
}

}  // namespace detail

// Into (-pi, pi]. An angle inside the range keeps every bit. NaN for an infinity.
inline double wrap_signed(double angle) {
  if (angle > -pi && angle <= pi) return angle;
  const double nearer = angle > 0 ? angle - 2 * pi : angle + 2 * pi;
  return nearer > -pi && nearer <= pi ? nearer : detail::wrap_far_signed(angle);
}

// Into [0, 2 pi). An angle inside the range keeps every bit. NaN for an infinity.
inline double wrap_turn(double angle) {
  if (angle >= 0 && angle < 2 * pi) return angle;
  const double nearer = angle > 0 ? angle - 2 * pi : angle + 2 * pi;
  return nearer >= 0 && nearer < 2 * pi ? nearer : detail::wrap_far_turn(angle);
}

namespace detail {

// to - from: along continuous axes the shortest way around the circle. `Limits` is the limits_along of the
// numbers' axes and quantity.
template <class Limits, class Vector>
inline Vector shortest_way(const Vector& from, const Vector& to) {
  Vector way = to - from;
  if constexpr (Limits::any_continuous)
    for (int i = 0; i < static_cast<int>(Limits::continuous.size()); ++i)
      if (Limits::continuous[static_cast<std::size_t>(i)]) way[i] = wrap_signed(way[i]);
  return way;
}

// The angle that means the same as `angle` and is nearest to `near`; every bit of `angle` if that is it.
inline double same_turn(double angle, double near) {
  const double way = angle - near;
  return way > -pi && way <= pi ? angle : near + wrap_signed(way);
}

}  // namespace detail

// to - from of two vectors over the axes of Space: the shortest way around the circle for the angles of
// continuous axes, the plain difference for all others.
template <class Space>
typename Space::vector_type difference_of(const typename Space::vector_type& to,
                                          const typename Space::vector_type& from) {
  if constexpr (Space::size == Space::axes::count)
    return detail::shortest_way<detail::limits_along<typename Space::axes, typename Space::domain::quantity>>(
        from, to);
  else return to - from;
}

}  // namespace cca
