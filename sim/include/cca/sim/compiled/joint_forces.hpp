// What acts on one coordinate of a compiled world: the spring and the friction in the joint, viscous and dry,
// its motor, the cable that the motor winds, its stops.
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
#include <cca/sim/compiled/lanes/laws_in_lanes.hpp>
#include <cca/sim/compiled/scalar.hpp>

namespace cca::sim::detail {

template <class Real>
struct answer {
  Real force{}, slope{};
  Real side{};  // 0: not limited. Upper limit: above 0, lower limit: below. 1: a constant limit; 2: a motor's
                // falling line; 3: beyond the end of that line

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

// What of a drive its condition changes (drive_condition.hpp).
template <class Number>
struct drive_numbers {
  Number torque{}, no_load_speed{};   // of the motor
  Number friction{}, dry_friction{};  // in the joint

  constexpr drive_numbers() = default;
  constexpr explicit drive_numbers(const robots::joint_drive& d)
      : torque(d.motor.torque),
        no_load_speed(d.motor.no_load_speed),
        friction(d.friction),
        dry_friction(d.dry_friction) {}
};

// A force that falls with dv along a straight line.
template <class Real>
struct straight_force {
  Real force{}, slope{};  // force: at dv = 0

  constexpr answer<Real> at(const Real& dv) const { return {force - slope * dv, slope, Real(0.0)}; }
};

// stiffness (position - q) + damping (speed - v) + torque.
template <class Real>
struct soft_law {
  Real position{}, speed{}, torque{}, stiffness{}, damping{};

  constexpr straight_force<Real> in(const coordinate_in_step<Real>& c) const {
    const Real t = c.theta(stiffness, damping), zero(0.0);
    return {stiffness * (position - c.position(t, zero)) + damping * (speed - c.v) + torque,
            c.slope(t, stiffness, damping)};
  }
};

template <class Real>
constexpr answer<Real> limited(const answer<Real>& wanted,
                               const answer<Real>& low,
                               const answer<Real>& high) {
  const auto above = wanted.force > high.force, below = wanted.force < low.force;
  return {select(above, high.force, select(below, low.force, wanted.force)),
          select(above, high.slope, select(below, low.slope, wanted.slope)),
          select(above, high.side, select(below, low.side, wanted.side))};
}

// What is left of a motor's torque at a line that falls by `slope`: at most `most`, at least 0. `way` -1: the
// other way.
template <class Real>
constexpr answer<Real> left_of(const Real& line, const Real& slope, const Real& most, double way) {
  const auto falls = line < most, ends = line < Real(0.0);
  const Real left = select(ends, Real(0.0), select(falls, line, most));
  return {Real(way) * left, select(ends, Real(0.0), select(falls, slope, Real(0.0))),
          Real(way) * select(ends, Real(3.0), select(falls, Real(2.0), Real(1.0)))};
}

// The motor of a joint in one step. `last`: the side of the last round. What holds is between the pieces of
// two rounds where one leads to the other and back, so it is taken next: the law, without limits, if it was
// at one limit and is beyond the other; the falling line, if its end was reached from before it, or left for
// that.
template <class Real>
class motor_in_step {
  using number = number_of<Real>;

public:
  constexpr motor_in_step() = default;

  // It follows a law, within what its line leaves. One that winds a cable only pulls.
  constexpr motor_in_step(const robots::joint_drive& d,
                          const drive_numbers<number>& now,
                          const law_of<Real>& law,
                          const coordinate_in_step<Real>& c)
      : kind_(kind::law), only_pulls_(d.cable.stiffness > 0), most_(now.torque) {
    wanted_ = soft_law<Real>{Real(law.position), Real(law.velocity), Real(law.torque), Real(law.stiffness),
                             Real(law.damping)}
                  .in(c);
    const number twice = number(2.0) * now.torque, steep = twice / now.no_load_speed;
    const Real whole(twice), lost = Real(steep) * c.v;
    high_ = whole - lost, low_ = whole + lost;
    falls_ = Real(steep) * c.theta(Real(0.0), Real(steep));
  }
  // It winds a cable, which is wound to `wound` in the middle of the step, at `winding` rad/s.
  constexpr motor_in_step(const robots::joint_drive& d,
                          const drive_numbers<number>& now,
                          const Real& wound,
                          const Real& winding,
                          const coordinate_in_step<Real>& c)
      : kind_(kind::cable), only_pulls_(true), most_(now.torque) {
    const Real stiffness(d.cable.stiffness), damping(d.cable.damping), zero(0.0);
    const Real theta = c.theta(stiffness, damping);
    high_ = wound + Real(c.h) * ((theta - Real(0.5)) * winding) - c.position(theta, zero);
    falls_ = Real(0.5 * c.h) * theta;
    wanted_ = {stiffness * high_ + damping * (winding - c.v), c.slope(theta, stiffness, damping)};
  }

  constexpr answer<Real> at(const Real& dv) const {
    if (kind_ == kind::none) return {};
    answer<Real> wanted = wanted_.at(dv);
    const answer<Real> none{Real(0.0), Real(0.0), Real(-1.0)};
    const Real& f = wanted.force;
    const Real lost = falls_ * dv, high = high_ - lost, low = low_ + lost;
    if (kind_ == kind::cable) {
      const answer<Real> taut = limited(wanted, none, {most_, Real(0.0), Real(1.0)});
      const auto slack = !(high > Real(0.0));
      return {select(slack, Real(0.0), taut.force), select(slack, Real(0.0), taut.slope),
              select(slack, Real(-1.0), taut.side)};
    }
    // Beyond the end of a line it brakes: then the line is not between this and the end.
    wanted.side = select(high < Real(0.0), Real(2.0), select(low < Real(0.0), Real(-2.0), Real(0.0)));
    const auto in_high = f <= most_, in_line = f <= high;
    const auto in_low = (only_pulls_ ? Real(0.0) : -most_) <= f, in_other = (only_pulls_ ? f : -low) <= f;
    if (everywhere(in_high & in_line & in_low & in_other)) return wanted;
    return limited(wanted, only_pulls_ ? none : left_of(low, falls_, most_, -1),
                   left_of(high, falls_, most_, 1));
  }
  constexpr answer<Real> at(const Real& dv, const Real& last) const {
    const answer<Real> a = at(dv);
    const Real now = a.side * a.side, before = last * last;
    const auto is_past = now > Real(8.0), was_past = before > Real(8.0), is_far = now < Real(2.0),
               was_far = before < Real(2.0);
    const Real skips = select(is_past & was_far, Real(1.0), select(was_past & is_far, Real(1.0), Real(0.0)));
    const Real off = select(a.side * last < Real(0.0), Real(2.0), skips);  // 2: from one limit to the other
    if (everywhere(off < Real(0.5))) return a;
    const answer<Real> wanted = wanted_.at(dv);
    const Real way = select(a.side + last > Real(0.0), Real(1.0), Real(-1.0));
    const Real line = select(way > Real(0.0), high_, low_) - way * falls_ * dv;
    const auto crosses = off > Real(1.5), is_off = off > Real(0.5);
    return {select(crosses, wanted.force, select(is_off, way * line, a.force)),
            select(crosses, wanted.slope, select(is_off, falls_, a.slope)),
            select(crosses, Real(0.0), select(is_off, Real(2.0) * way, a.side))};
  }

private:
  enum class kind { none, law, cable };
  kind kind_ = kind::none;
  bool only_pulls_ = false;
  Real most_{};                    // N m
  straight_force<Real> wanted_{};  // by the law; by the cable
  Real high_{}, low_{}, falls_{};  // lines of the motor, both ways; high: of a cable, its stretch
};

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
constexpr answer<Real> by_stops(const Real& way_beyond, const coordinate_in_step<Real>& c, const Real& dv) {
  constexpr double hard = 1e6;
  const Real damping = Real(hard / c.h) * c.inertia, push = -(damping * (c.v + dv));
  const auto holds = push * way_beyond < Real(0.0);
  return {select(holds, push, Real(0.0)), select(holds, damping, Real(0.0))};
}

// Dry friction stops the joint in this step, within its torque. `last`: the side of the last round; between
// both limits is the piece in which the joint stands.
template <class Real>
constexpr answer<Real> by_dry_friction(const Real& most,
                                       const coordinate_in_step<Real>& c,
                                       const Real& dv,
                                       const Real& last) {
  constexpr double hard = 1e6;
  const Real damping = Real(hard / c.h) * c.inertia;
  const answer<Real> stands{-(damping * (c.v + dv)), damping, Real(0.0)};
  const answer<Real> a =
      limited(stands, answer<Real>{-most, Real(0.0), Real(-1.0)}, {most, Real(0.0), Real(1.0)});
  const auto skips = a.side * last < Real(0.0);
  return {select(skips, stands.force, a.force), select(skips, stands.slope, a.slope),
          select(skips, stands.side, a.side)};
}

// What acts on one coordinate in one step.
template <class Real>
struct joint_in_step {
  coordinate_in_step<Real> now{};
  motor_in_step<Real> motor{};
  straight_force<Real> soft{};  // the spring and the friction in the joint
  Real way_beyond{};            // its stops

  // With that of its motor.
  constexpr answer<Real> at(const Real& dv, answer<Real> sum) const {
    sum += soft.at(dv);
    if (!everywhere(way_beyond == Real(0.0))) sum += by_stops(way_beyond, now, dv);
    return sum;
  }
};

}  // namespace cca::sim::detail
