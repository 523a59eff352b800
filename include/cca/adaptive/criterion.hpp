// A criterion measures how far the feedback is from the target, and judges it with hysteresis (the source
// document, chapter 3, *Criterion*). It is a component with
//
//   in  "target", "feedback"     of matching spaces
//   out "error"                  criterion_error, in the unit of the space; at most 1e12
//   out "state"                  criterion_port: a criterion_state
//
// and two constants for the adaptive component around it:
//
//   compares     criterion_target::command or ::reference: which of them is the target
//   at_rest      true if `reached` also requires that the ode has converged
//
// Its other inputs become inputs of the adaptive component. While an input is NaN or infinite, the error is
// 1e12 and the state `lost`, which is the status of a criterion for `unreadable` (input_status.hpp).
// Rule: criterion.spaces.
// Laws: tests/laws/criterion_laws.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <string_view>

#include <cca/component/input_status.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/field_types.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/space/domain.hpp>

namespace cca {

enum class criterion_state : std::uint8_t { open, fulfilled, lost };
enum class criterion_target : std::uint8_t { command, reference };

struct error_axis : dimension<"error"> {};
struct criterion_error : space<number, axes<error_axis>> {};
struct criterion_axis : dimension<"criterion"> {};
struct criterion_port : space<status, axes<criterion_axis>> {};

template <class Type> concept Criterion = detail::HasProcess<Type> && requires {
  { Type::compares } -> std::convertible_to<criterion_target>;
  { Type::at_rest } -> std::convertible_to<bool>;
};

namespace detail {

// The largest absolute value; NaN if any is NaN. (Eigen's maxCoeff may skip a NaN.)
template <class Vector>
inline double furthest(const Vector& v) {
  double most = 0;
  for (int i = 0; i < v.size(); ++i) {
    if (std::isnan(v[i])) return v[i];
    most = std::max(most, std::abs(v[i]));
  }
  return most;
}

}  // namespace detail

// The error to publish: `largest_input` if it is larger or NaN.
constexpr double error_to_publish(double error) { return error <= largest_input ? error : largest_input; }

// The distance of two samples, in the unit of the domain type: of positions the Euclidean distance, of
// orientations the angle between them, of poses the larger of both (m, rad), of phases the shorter way round,
// else the largest difference along an axis.
template <Space S>
inline double apart(const sample<S>& a, const sample<S>& b) {
  if constexpr (detail::is_pose<typename S::domain>)
    return std::max(a.position().distance(b.position()), a.orientation().angle_to(b.orientation()));
  else if constexpr (requires { a.distance(b); }) return a.distance(b);
  else if constexpr (requires { a.angle_to(b); }) return a.angle_to(b);
  else if constexpr (std::same_as<typename S::domain, phase>) return detail::furthest(a.difference(b));
  else return detail::furthest(typename S::vector_type(a.vector() - b.vector()));
}

namespace detail {

template <class Domain>
struct distance_quantity {
  using type = typename Domain::quantity;
};
template <class Frame>
struct distance_quantity<orientation<Frame>> {
  using type = angle;
};
template <class Frame>
struct distance_quantity<pose<Frame>> {
  using type = length;
};

}  // namespace detail

// Thresholds of an error. Fulfilled: at most `within` for `hold` s; open again above `until`. Lost: above
// `lost` for `hold` s, or NaN or infinite; open again at `until` or below.
template <Quantity Unit>
struct error_limits {
  using bound = quantity<Unit, 0, infinity>;
  using period = quantity<duration, 0, infinity>;
  BOOST_HANA_DEFINE_STRUCT(error_limits, (bound, within), (bound, until), (bound, lost), (period, hold));
  constexpr error_limits(double near = 0.05, double leave = 0.1, double far = infinity, double seconds = 0)
      : within(near), until(leave), lost(far), hold(seconds) {}
  std::string_view check() const {
    return within > until ? "`within` is above `until`" : until > lost ? "`until` is above `lost`" : "";
  }
};

// Keeps the state from one error to the next.
class error_monitor {
public:
  template <Quantity Unit>
  criterion_state update(double error, const error_limits<Unit>& limits, double dt) {
    const bool near = error <= limits.within, far = !(error <= limits.lost) || std::isinf(error);
    for_near = near ? for_near + dt : 0;
    for_far = far ? for_far + dt : 0;
    constexpr double rounding = 1e-9;
    if (far && (for_far + rounding >= limits.hold || !std::isfinite(error))) now = criterion_state::lost;
    else if (near && for_near + rounding >= limits.hold) now = criterion_state::fulfilled;
    else if (now == criterion_state::fulfilled ? error > limits.until : error <= limits.until)
      now = criterion_state::open;
    return now;
  }
  criterion_state get() const { return now; }

private:
  double for_near = 0, for_far = 0;
  criterion_state now = criterion_state::open;
};

}  // namespace cca
