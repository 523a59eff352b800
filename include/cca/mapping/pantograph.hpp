// A pantograph leg, as Oncilla's: three segments, of which the lower stays parallel to the upper. Its
// kinematics are solved in closed form.
//
//   struct left_front_leg
//       : cca::pantograph_leg<
//             trunk, paw, cca::axes<abduction, hip, knee>,
//             cca::pantograph{.upper = 0.078, .middle = 0.095, .lower = 0.06, .side = 1}> {};
//
// Frame: x forward, y left, z up; its origin is the hip, placed in the base by `hip`. The plane of the leg is
// that of x and z, turned about x by the abduction (positive outward: to +y on side +1, the left one). In
// this plane a segment at angle t points to (sin t, -cos t): the upper one at `hip`, the middle one at `hip -
// knee`, the lower one at `hip` again. So it is a leg of two links with the lengths upper + lower and middle.
// With axes<hip, knee> it stays in its plane: positions are over axes<x, z>. If `hip` turns that plane out of
// the base's plane of x and z, the leg is solved like any serial chain.
//
// Its inverse gives the nearest point within the joint limits, of all that exist. The reachable points of the
// plane are bounded by arcs on which one joint is at its limit or the leg is straight or folded, and the
// nearest point of an arc is known (law of cosines; compare Siciliano et al., Robotics, 2009, chapter 2).
// A target that is NaN or infinite does not come here: inverse_kinematics.hpp answers it.
// Preconditions: lengths are positive; the range of the abduction is less than a turn.
// Cost: about 10 sines and arc tangents.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include <cca/base/math.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/mapping/reaching.hpp>
#include <cca/mapping/tip_task.hpp>

namespace cca {

struct pantograph {
  double upper = 0, middle = 0, lower = 0;  // m; the lower one ends where the foot touches the ground
  double side = 1;                          // +1: abduction leads to +y, -1: to -y
  placement hip{};                          // in the base
};

namespace detail {

template <class Axes>
struct no_leg_axes {
  static constexpr void tell(text& m) {
    m << "mapping.bad_chain: a cca::pantograph_leg has " << Axes::count
      << (Axes::count == 1 ? " axis (" : " axes (") << axes_in_words<Axes>()
      << "), and it moves by abduction, hip and knee, or by hip and knee: name these";
  }
};

}  // namespace detail

template <class Base, class Tip, class Axes, pantograph Geometry>
struct pantograph_leg : serial_chain<Base, Tip, Axes> {
  static_assert(
      detail::holds_or_tells<(Axes::count == 2 || Axes::count == 3), detail::no_leg_axes<Axes>>::value);
  static constexpr pantograph geometry = Geometry;
  static constexpr placement tip = at(0, 0, -Geometry.lower);
  static constexpr auto joints = [] {
    constexpr std::size_t abducted = Axes::count == 3;
    constexpr int hip = abducted, knee = hip + 1;
    std::array<joint, 3 + abducted> all{};
    if constexpr (abducted) all[0] = revolute(along_x, Geometry.hip).driven_by(0, Geometry.side);
    all[abducted] = revolute(along_y, abducted ? placement{} : Geometry.hip).driven_by(hip, -1);
    all[abducted + 1] = revolute(along_y, at(0, 0, -Geometry.upper)).driven_by(knee);
    all[abducted + 2] = revolute(along_y, at(0, 0, -Geometry.middle)).driven_by(knee, -1);
    return all;
  }();
};

template <class Type> concept PantographLeg = SerialChain<Type> && requires {
  requires std::is_same_v<std::remove_cvref_t<decltype(Type::geometry)>, pantograph>;
};

namespace detail {

// The angle in the range that is nearest to the given one, up to whole turns.
inline double nearest_in(double angle, double low, double high) {
  if (std::isfinite(low) && std::isfinite(high))
    angle -= 2 * std::numbers::pi * math::round((angle - (low + high) / 2) / (2 * std::numbers::pi));
  return angle < low ? low : angle > high ? high : angle;
}

// The leg in its plane.
struct plane_leg {
  double a, b;  // upper + lower, middle
  double hip_low, hip_high, knee_low, knee_high;

  struct answer {
    double hip = 0, knee = 0, square = std::numeric_limits<double>::infinity(), change = 0;
  };

  // always_inline, here and below: a leg is constant, which is seen only where it is inlined
  // (docs/compilers.md).
  [[gnu::always_inline]] answer solve(double x, double z, double hip_before, double knee_before) const {
    search one{*this, x, z, hip_before, knee_before};
    const double cosine = (x * x + z * z - a * a - b * b) / (2 * a * b);
    if (std::abs(cosine) <= 1)
      for (const double knee : {math::acos(cosine), -math::acos(cosine)}) one.try_knee(knee);
    if (one.best.square > 1e-24)
      for (const double knee : {knee_low, knee_high, 0.0, std::numbers::pi, -std::numbers::pi})
        if (std::isfinite(knee)) one.try_knee(knee);
    if (one.best.square > 1e-24)
      for (const double hip : {hip_low, hip_high}) one.try_hip(hip);
    return one.best;
  }

private:
  // Tries angles and keeps the best answer.
  struct search {
    const plane_leg& leg;
    double x, z, hip_before, knee_before;
    double towards = math::atan2(x, -z);
    answer best{};

    // With this knee, the hip that turns the foot to the target.
    [[gnu::always_inline]] void try_knee(double knee) {
      if (knee < leg.knee_low || knee > leg.knee_high) return;
      const auto bent = math::sine_and_cosine(knee);
      keep_better(nearest_in(towards + math::atan2(leg.b * bent.sine, leg.a + leg.b * bent.cosine),
                             leg.hip_low, leg.hip_high),
                  knee);
    }
    // With this hip, the knee that turns the middle segment to the target.
    [[gnu::always_inline]] void try_hip(double hip) {
      if (!std::isfinite(hip)) return;
      const auto upper = math::sine_and_cosine(hip);
      keep_better(hip, nearest_in(hip - math::atan2(x - leg.a * upper.sine, -(z + leg.a * upper.cosine)),
                                  leg.knee_low, leg.knee_high));
    }

    [[gnu::always_inline]] void keep_better(double hip, double knee) {
      const auto upper = math::sine_and_cosine(hip), middle = math::sine_and_cosine(hip - knee);
      const double dx = leg.a * upper.sine + leg.b * middle.sine - x,
                   dz = -leg.a * upper.cosine - leg.b * middle.cosine - z;
      const double square = dx * dx + dz * dz,
                   change = std::abs(hip - hip_before) + std::abs(knee - knee_before);
      constexpr double same = 1e-24;  // m^2: then the answer that moves the joints less
      if (square < best.square - same || (square <= best.square + same && change < best.change))
        best = {hip, knee, square, change};
    }
  };
};

// The solver of a pantograph leg, with the interface of many_starts.
template <class Leg, class Joints, class Tip, class Settings>
class pantograph_solver {
  using limits = chain_limits<Leg, Joints>;
  static constexpr bool abducted = Leg::axes::count == 3;
  static constexpr int hip = abducted, knee = hip + 1;
  static constexpr pantograph geometry = Leg::geometry;
  static constexpr plane_leg leg{geometry.upper + geometry.lower,
                                 geometry.middle,
                                 limits::lower(hip),
                                 limits::upper(hip),
                                 limits::lower(knee),
                                 limits::upper(knee)};

public:
  using vector = typename limits::vector;
  struct answer {
    vector q;
    double distance;
    reaching status;
  };

  [[gnu::always_inline]] static answer solve(const typename Tip::vector_type& wanted, const vector& near) {
    answer best{near, std::numeric_limits<double>::infinity(), reaching::nearest};
    if constexpr (abducted) {
      const vector3 p = in_hip(wanted);
      const double radius = math::hypot(p[1], p[2]);
      // The tilt that turns the plane to the target, for a foot below the hip and above it.
      const double first = radius > 0 ? math::atan2(p[1], -p[2]) : 0,
                   second = radius > 0 ? math::atan2(-p[1], p[2]) : 0;
      const double side = geometry.side < 0 ? -1 : 1;
      const double low = side > 0 ? limits::lower(0) : -limits::upper(0),
                   high = side > 0 ? limits::upper(0) : -limits::lower(0);
      for (const double towards : {first, second}) {
        const double tilt = nearest_in(towards, low, high);
        const auto turn = math::sine_and_cosine(tilt);
        const double across = p[1] * turn.cosine + p[2] * turn.sine,
                     up = p[2] * turn.cosine - p[1] * turn.sine;
        const auto found = leg.solve(p[0], up, near[hip], near[knee]);
        const double distance = math::sqrt(found.square + across * across);
        if (distance < best.distance - 1e-12)
          best = {vector(side * tilt, found.hip, found.knee), distance, reaching::nearest};
      }
    } else {
      const vector3 p = in_hip(wanted);
      const auto found = leg.solve(p[0], p[2], near[hip], near[knee]);
      best = {vector(found.hip, found.knee), math::sqrt(found.square), reaching::nearest};
    }
    if (best.distance <= Settings::tolerance) best.status = reaching::reached;
    return best;
  }

private:
  static vector3 in_hip(const typename Tip::vector_type& wanted) {
    constexpr placement back = inverse(geometry.hip);
    vector3 p = vector3::Zero();
    using part = cartesian_part<typename Tip::axes>;
    for (int i = 0; i < Tip::size; ++i) p[part::of[static_cast<std::size_t>(i)]] = wanted[i];
    return rotation::rotate(as_vector(back.rotation), p) + as_vector(back.translation);
  }
};

}  // namespace detail
}  // namespace cca
