// What acts on one coordinate of a compiled world: the spring and the friction in the joint, its motor, the
// cable that the motor winds, its stops.
//
// A force depends on the change `dv` of the speed in the step: an answer is its value there, and how fast it
// falls with dv (`slope`). Each is a few straight pieces (a servo within its limits, the line of its motor, a
// cable that hangs slack). The world takes the pieces that hold at the end of its step (compiled_world.hpp),
// so every stiffness, damping and step is stable.
//
// Where in the step a spring or a damper acts, `theta`: in its middle (1/2: second order, no loss), unless it
// is so stiff that the step can't follow it; then as late as it takes not to swing past its rest. Stops do
// not bounce: a joint beyond one stops at once.
#pragma once

#include <limits>

#include <cca/robots/description.hpp>
#include <cca/robots/joint_law.hpp>
#include <cca/sim/compiled/scalar.hpp>

namespace cca::sim::detail {

template <class Real>
struct answer {
  Real force{}, slope{};
  Real side{};  // of what is limited: 1 at its upper limit, -1 at its lower one

  constexpr answer& operator+=(const answer& b) {
    force = force + b.force, slope = slope + b.slope;
    return *this;
  }
};

// A coordinate in the middle of a step.
template <class Real>
struct coordinate_in_step {
  double h = 0;    // s
  Real q{}, v{};   // rad where it is in the middle, rad/s at the beginning
  Real inertia{};  // kg m^2, of all that it moves

  constexpr Real theta(const Real& stiffness, const Real& damping) const {
    const Real ratio = Real(h) * (damping + Real(0.5 * h) * stiffness);
    return larger(Real(0.5), Real(1.0) - inertia / larger(ratio, Real(1e-100)));
  }
  constexpr Real position(const Real& theta, const Real& dv) const {
    return q + Real(h) * ((theta - Real(0.5)) * v + Real(0.5) * theta * dv);
  }
  constexpr Real speed(const Real& theta, const Real& dv) const { return v + theta * dv; }
  constexpr Real slope(const Real& theta, const Real& stiffness, const Real& damping) const {
    return theta * (Real(0.5 * h) * stiffness + damping);
  }
};

// stiffness (position - q) + damping (speed - v) + torque.
template <class Real>
struct soft_law {
  Real position{}, speed{}, torque{}, stiffness{}, damping{};

  constexpr answer<Real> at(const coordinate_in_step<Real>& c, const Real& dv) const {
    const Real t = c.theta(stiffness, damping);
    return {stiffness * (position - c.position(t, dv)) + damping * (speed - c.speed(t, dv)) + torque,
            c.slope(t, stiffness, damping)};
  }
};

template <class Real>
constexpr answer<Real> in_joint(const robots::joint_drive& d,
                                const coordinate_in_step<Real>& c,
                                const Real& dv) {
  return soft_law<Real>{Real(d.spring_rest), Real(0.0), Real(0.0), Real(d.spring), Real(d.friction)}.at(c,
                                                                                                        dv);
}

template <class Real>
constexpr answer<Real> limited(const answer<Real>& wanted,
                               const answer<Real>& low,
                               const answer<Real>& high) {
  const auto above = wanted.force > high.force, below = wanted.force < low.force;
  return {select(above, high.force, select(below, low.force, wanted.force)),
          select(above, high.slope, select(below, low.slope, wanted.slope)),
          select(above, Real(1.0), select(below, Real(-1.0), Real(0.0)))};
}

template <class Real>
constexpr answer<Real> between_sides(const answer<Real>& wanted,
                                     const answer<Real>& low,
                                     const answer<Real>& high,
                                     const Real& last) {
  const answer<Real> a = limited(wanted, low, high);
  const auto crosses = a.side * last < Real(0.0);
  return {select(crosses, wanted.force, a.force), select(crosses, wanted.slope, a.slope),
          select(crosses, Real(0.0), a.side)};
}

// The most that a motor gives at a speed: its torque, or what its line leaves. `way` -1: the other way.
template <class Real>
constexpr answer<Real> most_of(const robots::motor_line& m, const Real& v, const Real& theta, double way) {
  const double steep = 2 * m.torque / m.no_load_speed;
  const Real line = Real(2 * m.torque) - Real(steep * way) * v;
  const auto falls = line < Real(m.torque), ends = line < Real(0.0);
  const Real most = select(ends, Real(0.0), select(falls, line, Real(m.torque)));
  return {Real(way) * most, select(ends, Real(0.0), select(falls, Real(steep) * theta, Real(0.0)))};
}

// A motor that follows a law, within what its line leaves. One that winds a cable only pulls. `last`: the
// side of the last round. A stiff law that was at one limit and is beyond the other is taken without limits:
// what holds is between.
template <class Real>
constexpr answer<Real> by_motor(const robots::joint_drive& d,
                                const robots::joint_law& law,
                                const coordinate_in_step<Real>& c,
                                const Real& dv,
                                const Real& last) {
  const soft_law<Real> soft{Real(law.position), Real(law.velocity), Real(law.torque), Real(law.stiffness),
                            Real(law.damping)};
  const Real theta = c.theta(Real(0.0), Real(2 * d.motor.torque / d.motor.no_load_speed));
  const Real v = c.speed(theta, dv);
  const answer<Real> none{};
  return between_sides(soft.at(c, dv), d.cable.stiffness > 0 ? none : most_of(d.motor, v, theta, -1),
                       most_of(d.motor, v, theta, 1), last);
}

// A cable that is wound to `wound` in the middle of the step, at `winding` rad/s.
template <class Real>
constexpr answer<Real> by_cable(const robots::joint_drive& d,
                                const Real& wound,
                                const Real& winding,
                                const coordinate_in_step<Real>& c,
                                const Real& dv,
                                const Real& last) {
  const Real stiffness(d.cable.stiffness), damping(d.cable.damping);
  const Real theta = c.theta(stiffness, damping);
  const Real stretch = wound + Real(c.h) * ((theta - Real(0.5)) * winding) - c.position(theta, dv);
  const Real pull = stiffness * stretch + damping * (winding - c.speed(theta, dv));
  const answer<Real> none{}, most{Real(d.motor.torque)};
  const answer<Real> taut = between_sides({pull, c.slope(theta, stiffness, damping)}, none, most, last);
  const auto slack = !(stretch > Real(0.0));
  return {select(slack, Real(0.0), taut.force), select(slack, Real(0.0), taut.slope),
          select(slack, Real(-1.0), taut.side)};
}

// Range of a coordinate; infinite: no stops.
struct joint_range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  constexpr bool exists() const { return high - low < std::numeric_limits<double>::infinity(); }
};

// How far a coordinate is beyond its stops in the middle of the step; below 0: beyond the lower one.
template <class Real>
constexpr Real beyond(const joint_range& range, const Real& q) {
  return larger(q - Real(range.high), Real(0.0)) + smaller(q - Real(range.low), Real(0.0));
}
// The part of that way which each step takes back, without a speed.
inline constexpr double comes_back = 0.2;

template <class Real>
constexpr answer<Real> by_stops(const joint_range& range, const coordinate_in_step<Real>& c, const Real& dv) {
  constexpr double hard = 1e6;
  const Real damping = Real(hard / c.h) * c.inertia, push = -(damping * (c.v + dv));
  const auto holds = push * beyond(range, c.q) < Real(0.0);
  return {select(holds, push, Real(0.0)), select(holds, damping, Real(0.0))};
}

}  // namespace cca::sim::detail
