// Whether the motion of a compiled world can still be right: bounds of plausible.hpp.
//
// Looked at: that all numbers are finite; the speed of the base, and of each prismatic joint; how fast the
// base and each revolute joint turn; how far a joint is beyond a stop. The bound of the energy is not looked
// at: M is not at hand where the step ends.
#pragma once

#include <cstddef>

#include <cca/sim/compiled/tree_step.hpp>
#include <cca/sim/robot/model/plausible.hpp>

namespace cca::sim::detail {

template <class R, class Real>
constexpr world_trouble trouble_of(
    const tree_motion<Real, compiled_tree<R>::coordinates, compiled_tree<R>::floats>& m,
    const plausible_bounds& bounds,
    double step) {
  using tree = compiled_tree<R>;
  const auto is_beyond = [](const Real& x, double bound) { return !everywhere(x <= Real(bound)); };
  const auto number = [](const Real& x) {
    if constexpr (requires { x.value; }) return static_cast<double>(x.value);
    else if constexpr (requires { x[0]; }) return static_cast<double>(x[0]);
    else return static_cast<double>(x);
  };
  const auto size = [](const Real& x) { return larger(x, -x); };
  if constexpr (tree::floats) {
    const Real speed = root(dot(m.velocity, m.velocity)),
               turning = root(dot(m.angular_velocity, m.angular_velocity)), sum = m.at[0] + m.at[1] + m.at[2];
    if (is_beyond(sum - sum + speed - speed + turning - turning, 0))
      return {implausible::number, world_trouble::base};
    if (is_beyond(speed, bounds.speed))
      return {implausible::speed, world_trouble::base, number(speed), bounds.speed};
    if (is_beyond(Real(step) * turning, bounds.turn))
      return {implausible::turning, world_trouble::base, number(turning), bounds.turn / step};
  }
  for (std::size_t i = 0; i < tree::links; ++i) {
    const auto& l = tree::reduced.links[i];
    const auto c = static_cast<std::size_t>(l.coordinate);
    const int body = static_cast<int>(i);
    const double ratio = l.ratio < 0 ? -l.ratio : l.ratio;
    const Real speed = Real(ratio) * size(m.dq[c]);
    if (is_beyond(m.q[c] - m.q[c] + speed - speed, 0)) return {implausible::number, body};
    if (!l.revolute && is_beyond(speed, bounds.speed))
      return {implausible::speed, body, number(speed), bounds.speed};
    if (l.revolute && is_beyond(Real(step) * speed, bounds.turn))
      return {implausible::turning, body, number(speed), bounds.turn / step};
    const joint_range& range = tree::ranges[c];
    if (!range.exists()) continue;
    const double bound = l.revolute ? bounds.stop : bounds.stop_way;
    const Real beyond = Real(ratio) * larger(m.q[c] - Real(range.high), Real(range.low) - m.q[c]);
    if (is_beyond(beyond, bound)) return {implausible::stop, body, number(beyond), bound};
  }
  return {};
}

}  // namespace cca::sim::detail
