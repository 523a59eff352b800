// Whether the motion of a compiled world can still be right: the bounds of plausible.hpp, of the bodies that
// the engine has, in the same order.
//
// A sum of the speeds of all joints bounds the motion of every body. Only where it is too large, the bodies
// are looked at one by one.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/tree_step.hpp>
#include <cca/sim/compiled/whole_robot.hpp>
#include <cca/sim/robot/model/plausible.hpp>

namespace cca::sim::detail {

template <class R, class Real>
struct look_at_motion {
  using tree = compiled_tree<R>;
  using motion = tree_motion<Real, tree::coordinates, tree::floats>;
  using links = on_links<R, Real>;

  // The first body that can't be right: the base, if it floats, then the links.
  static constexpr world_trouble at_bodies(const motion& m, const plausible_bounds& bounds, double step) {
    if (is_surely_right(m, bounds, step)) return {};
    const auto base = m.frame();
    const typename links::twist motion_of_base{along(base, m.angular_velocity), along(base, m.velocity)};
    const auto places = whole_robot<R, Real>::at(m).only_places();
    Real energy{};
    const auto judge = [&](int body, const link_inertia& of) -> world_trouble {
      const placed_frame<Real> frame = links::end_frame(places, {body, {}});
      const auto& c = of.centre;
      const triple<Real> centre = frame.at + frame.direction({Real(c[0]), Real(c[1]), Real(c[2])});
      const auto t = links::motion(places, body, centre, motion_of_base, m.dq);
      const Real speed = root(dot(t.velocity, t.velocity)), turning = root(dot(t.turning, t.turning)),
                 own = kinetic(of, speed, along(frame, t.turning));
      energy = energy + own;
      if (!is_finite(speed + turning + own + (centre[0] + centre[1] + centre[2]) +
                     (base.at[0] + base.at[1] + base.at[2])))
        return {implausible::number, body};
      if (is_beyond(speed, bounds.speed)) return {implausible::speed, body, number(speed), bounds.speed};
      if (is_beyond(Real(step) * turning, bounds.turn))
        return {implausible::turning, body, number(turning), bounds.turn / step};
      if (is_beyond(energy, bounds.energy)) return {implausible::energy, body, number(energy), bounds.energy};
      return {};
    };
    if constexpr (tree::floats)
      if (const auto found = judge(world_trouble::base, base_inertia)) return found;
    for (std::size_t i = 0; i < tree::links; ++i) {
      const link_inertia& of = tree::described.links[i].inertia;
      if (!(of.mass > 0)) continue;
      if (const auto found = judge(static_cast<int>(i), of)) return found;
    }
    return {};
  }

  // The first joint whose number is none, or that is too far beyond a stop.
  static constexpr world_trouble at_joints(const motion& m, const plausible_bounds& bounds) {
    for (std::size_t i = 0; i < tree::links; ++i) {
      const auto& l = tree::reduced.links[i];
      const auto c = static_cast<std::size_t>(l.coordinate);
      if (!is_finite(m.q[c] + m.dq[c])) return {implausible::number, static_cast<int>(i)};
      const joint_range& range = tree::ranges[c];
      if (!range.exists()) continue;
      const double bound = l.revolute ? bounds.stop : bounds.stop_way;
      const Real beyond =
          Real(size_of(l.ratio)) * larger(m.q[c] - Real(range.high), Real(range.low) - m.q[c]);
      if (is_beyond(beyond, bound)) return {implausible::stop, static_cast<int>(i), number(beyond), bound};
    }
    return {};
  }

private:
  static constexpr link_inertia base_inertia = cca::detail::base_inertia_of<typename R::body>();

  static constexpr double size_of(double x) { return x < 0 ? -x : x; }
  // At least the length of a vector.
  static constexpr double span_of(const std::array<double, 3>& v) {
    return size_of(v[0]) + size_of(v[1]) + size_of(v[2]);
  }
  static constexpr Real size(const Real& x) { return larger(x, -x); }
  static constexpr Real span(const triple<Real>& v) { return size(v[0]) + size(v[1]) + size(v[2]); }
  static constexpr bool is_beyond(const Real& x, double bound) { return !everywhere(x <= Real(bound)); }
  static constexpr bool is_finite(const Real& x) { return everywhere(x - x == Real(0.0)); }
  static constexpr double number(const Real& x) {
    if constexpr (requires { x.value; }) return static_cast<double>(x.value);
    else if constexpr (requires { x[0]; }) return static_cast<double>(x[0]);
    else return static_cast<double>(x);
  }

  // `turning` along the axes of the link.
  static constexpr Real kinetic(const link_inertia& of, const Real& speed, const triple<Real>& turning) {
    const auto& i = of.about_centre;
    const Real &x = turning[0], &y = turning[1], &z = turning[2];
    return Real(0.5 * of.mass) * speed * speed + Real(0.5 * i[0]) * x * x + Real(0.5 * i[1]) * y * y +
           Real(0.5 * i[2]) * z * z + Real(i[3]) * x * y + Real(i[4]) * x * z + Real(i[5]) * y * z;
  }

  // Of the whole robot: how far a body's centre can be from the base, but for sliders; its mass, and of the
  // moments of its bodies at least the largest. Of each coordinate: what its joints turn and slide together.
  struct bounds_of_robot {
    double reach = 0, mass = 0, inertia = 0;
    std::array<double, static_cast<std::size_t>(tree::coordinates)> turns{}, slides{};
  };
  static constexpr bounds_of_robot whole = [] {
    bounds_of_robot all;
    const auto add = [&](double reach, const link_inertia& of) {
      const double far = reach + span_of(of.centre);
      if (all.reach < far) all.reach = far;
      all.mass += of.mass, all.inertia += of.about_centre[0] + of.about_centre[1] + of.about_centre[2];
    };
    if (tree::floats) add(0, base_inertia);
    std::array<double, tree::links> reach{};
    for (std::size_t i = 0; i < tree::links; ++i) {
      const auto& l = tree::described.links[i];
      const bool turns = l.kind == joint_kind::revolute;
      reach[i] = span_of(l.at) + (turns ? 0 : size_of(l.rest)) +
                 (l.parent < 0 ? 0 : reach[static_cast<std::size_t>(l.parent)]);
      add(reach[i], l.inertia);
      (turns ? all.turns : all.slides)[static_cast<std::size_t>(l.coordinate)] += size_of(l.ratio);
    }
    return all;
  }();

  // What is not a number is not surely right.
  static constexpr bool is_surely_right(const motion& m, const plausible_bounds& bounds, double step) {
    Real turning = span(m.angular_velocity), speed = span(m.velocity), reach(whole.reach),
         places = m.at[0] + m.at[1] + m.at[2];
    for (std::size_t c = 0; c < m.q.size(); ++c) {
      places = places + m.q[c];
      turning = turning + Real(whole.turns[c]) * size(m.dq[c]);
      if (!(whole.slides[c] > 0)) continue;
      speed = speed + Real(whole.slides[c]) * size(m.dq[c]);
      reach = reach + Real(whole.slides[c]) * size(m.q[c]);
    }
    speed = speed + reach * turning;
    const Real energy =
        Real(0.5 * whole.mass) * speed * speed + Real(0.5 * whole.inertia) * turning * turning;
    return is_finite(places + energy) && !is_beyond(speed, bounds.speed) &&
           !is_beyond(Real(step) * turning, bounds.turn) && !is_beyond(energy, bounds.energy);
  }
};

template <class R, class Real>
constexpr world_trouble trouble_of(
    const tree_motion<Real, compiled_tree<R>::coordinates, compiled_tree<R>::floats>& m,
    const plausible_bounds& bounds,
    double step) {
  using look = look_at_motion<R, Real>;
  if (const auto found = look::at_bodies(m, bounds, step)) return found;
  return look::at_joints(m, bounds);
}

}  // namespace cca::sim::detail
