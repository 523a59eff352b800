// The last guards before the drives: in every mode they keep each set point within what its joint may do.
//
//   act   in "wanted" set_points, "joints" joint_states; out "safe" set_points
//   rate_guard    positions change at most as fast as the axis' `velocity`. The first one begins where the
//                 joint is measured; until it has reached the command it moves at most with the parameter
//                 `approach`, so a start makes no jump. Outside of its range it moves with half of that: a
//                 joint may be faster than its set point, and must not be faster than `approach`. The torque
//                 of a set point, which is fed forward, changes by the axis' `torque_rate`. What stiffness
//                 and damping make has no rate: it must follow a joint that is pushed. A joint without
//                 stiffness begins with the torque that is measured, others without any. The servos of
//                 `oncilla` feed no torque forward, so there `torque_rate` bounds nothing
//   limit_guard   a joint that begins outside of its range enters it from where it is: until then its range
//                 reaches to its last set point, and torque that brakes passes; in a soft stop to
//                 where it is. Position, velocity, stiffness
//                 and damping stay within their limits. The torque that the drive will make, at the present
//                 angle and speed, stays within the torque limits: else stiffness, damping and torque are
//                 scaled down by one factor. Beyond an end of the range only torque that leads back passes;
//                 above the speed limit only torque that brakes
//
// Each change is counted, and the first one is kept: rule, joint, beat. Cost: about ten operations a joint.
// Source: limits by the previous command and one-sided efforts as in ros2_control's joint_limits.
// Example: tests/runtime/drive_chain; docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/component/parameters.hpp>
#include <cca/base/reflect.hpp>
#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/drives/set_points.hpp>

namespace cca::hardware {

template <class Joints, class Rate = cca::rate<1000>>
class rate_guard {
public:
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::quantity<cca::velocity, 0.01, 100>, approach));
  };
  parameters p{2.0};

  auto act(in<"wanted", set_points<Joints>> wanted, in<"joints", joint_states<Joints>> joints, beat now)
      -> out<"safe", set_points<Joints>> {
    auto v = wanted.vector();
    const double dt = std::min(now.dt(), 1 / Rate::hz);
    for (std::size_t i = 0; i < Joints::count; ++i) {
      set_point s = set_point::of(v, i);
      const joint_state q = joint_state::of(joints.vector(), i);
      approach_state& j = sent[i];
      if (s.mode() != motion_mode::run || q.phase < motion_phase::begins) {
        j = {Joints::angle[i].nearest(q.known() ? q.angle : s.position), 0, true};
        continue;
      }
      if (q.phase == motion_phase::begins || q.phase == motion_phase::resumes)
        j = {q.known() ? q.angle : j.position, s.stiffness == 0 ? first_torque(i, q) : 0, true};
      const joint_bounds speed = Joints::speed[i], range = Joints::angle[i];
      if (j.approaching) s.position = range.nearest(s.position);
      const double slow = p.approach * (range.holds(j.position) ? 1 : 0.5);
      const double down = j.approaching ? -std::min(slow, -speed.lower) : speed.lower;
      const double up = j.approaching ? std::min(slow, speed.upper) : speed.upper;
      const double position = joint_bounds{j.position + down * dt, j.position + up * dt}.nearest(s.position);
      if (position != s.position) {
        if (!j.approaching) noted.note(safety_rule::rate, static_cast<int>(i), now.index());
        s.velocity = joint_bounds{down, up}.nearest((position - j.position) / dt);
        s.position = position;
      } else {
        j.approaching = false;
      }
      const double most = Joints::torque_rate[i] * dt;
      // Within the limits, so that it turns round at once when the command does.
      const double torque =
          Joints::torque[i].nearest(joint_bounds{j.torque - most, j.torque + most}.nearest(s.torque));
      if (torque != s.torque) noted.note(safety_rule::rate, static_cast<int>(i), now.index());
      s.torque = torque;
      j.position = position;
      j.torque = torque;
      s.put(v, i);
    }
    return v;
  }
  bool approaching() const {
    return std::any_of(sent.begin(), sent.end(), [](const approach_state& j) { return j.approaching; });
  }
  const safety_record& record() const { return noted; }
  std::string summary() const { return noted.template summary<Joints>(); }
  void on_start() { sent = {}, noted = {}; }

private:
  struct approach_state {
    double position = 0, torque = 0;
    bool approaching = true;
  };
  // A drive that holds its joint up until motion begins is not dropped.
  static double first_torque(std::size_t i, const joint_state& q) {
    return q.torque - q.torque == 0 ? Joints::torque[i].nearest(q.torque) : 0;
  }

  std::array<approach_state, Joints::count> sent{};
  safety_record noted{};
};

template <class Joints>
class limit_guard {
public:
  auto act(in<"wanted", set_points<Joints>> wanted, in<"joints", joint_states<Joints>> joints, beat now)
      -> out<"safe", set_points<Joints>> {
    auto v = wanted.vector();
    for (std::size_t i = 0; i < Joints::count; ++i) {
      set_point s = set_point::of(v, i);
      const joint_state q = joint_state::of(joints.vector(), i);
      const auto keep = [&](double& number, joint_bounds within, safety_rule rule) {
        const double kept = number - number == 0 ? within.nearest(number) : within.nearest(0);
        if (kept == number) return;
        noted.note(rule, static_cast<int>(i), now.index());
        number = kept;
      };
      const joint_bounds range = Joints::angle[i];
      if ((q.phase == motion_phase::begins || q.phase == motion_phase::resumes) && q.known())
        entered[i] = q.angle;
      // A soft stop holds the joint where it is, outside too: the end of the range would be a jump.
      if (q.phase < motion_phase::begins || s.mode() != motion_mode::run)
        entered[i] = s.mode() == motion_mode::soft && q.known() ? q.angle : range.lower;
      const bool entering = !range.holds(entered[i]);
      keep(s.position,
           entering ? joint_bounds{std::min(range.lower, entered[i]), std::max(range.upper, entered[i])}
                    : range,
           safety_rule::range);
      entered[i] = s.position;
      keep(s.velocity, Joints::speed[i], safety_rule::range);
      keep(s.stiffness, {0, Joints::servo[i].most_stiff}, safety_rule::range);
      keep(s.damping, {0, Joints::servo[i].most_damping}, safety_rule::range);
      keep(s.torque, Joints::torque[i], safety_rule::torque);
      if (q.known()) {
        const double law = law_of(s, q);
        const bool brakes = entering && law * q.velocity < 0;
        const double allowed = (brakes ? Joints::torque[i] : window(i, q)).nearest(law);
        // A joint that can only be pulled gives no torque where a push is wanted: that is no violation.
        if (allowed != law && !(Joints::torque[i].lower >= 0 && law < 0))
          noted.note(is_at_stop(i, q) ? safety_rule::stop : safety_rule::torque, static_cast<int>(i),
                     now.index());
        scale(s, law, allowed);
      }
      s.put(v, i);
    }
    return v;
  }
  const safety_record& record() const { return noted; }
  std::string summary() const { return noted.template summary<Joints>(); }
  void on_start() { noted = {}, entered = lower_ends; }

  // The set point with no more torque than the joint may have at its present angle and speed.
  static set_point scaled(std::size_t i, const joint_state& q, set_point s) {
    if (!q.known()) return s;
    const double law = law_of(s, q);
    scale(s, law, window(i, q).nearest(law));
    return s;
  }

  // The torques that a joint may get at its present angle and speed.
  static constexpr joint_bounds window(std::size_t i, const joint_state& q) {
    joint_bounds w = Joints::torque[i];
    const joint_bounds range = Joints::angle[i], speed = Joints::speed[i];
    if (q.angle >= range.upper || q.velocity > speed.upper) w.upper = std::clamp(0.0, w.lower, w.upper);
    if (q.angle <= range.lower || q.velocity < speed.lower) w.lower = std::clamp(0.0, w.lower, w.upper);
    return w;
  }

private:
  static constexpr bool is_at_stop(std::size_t i, const joint_state& q) {
    return q.angle >= Joints::angle[i].upper || q.angle <= Joints::angle[i].lower;
  }
  static double law_of(const set_point& s, const joint_state& q) {
    return s.stiffness * (s.position - q.angle) + s.damping * (s.velocity - q.velocity) + s.torque;
  }
  // 0 is always allowed, so `allowed` has the sign of `law` and is smaller.
  static void scale(set_point& s, double law, double allowed) {
    if (allowed == law) return;
    const double part = allowed / law;
    s.stiffness *= part, s.damping *= part, s.torque *= part;
  }

  static constexpr std::array<double, Joints::count> lower_ends = [] {
    std::array<double, Joints::count> all{};
    for (std::size_t i = 0; i < Joints::count; ++i) all[i] = Joints::angle[i].lower;
    return all;
  }();
  std::array<double, Joints::count> entered = lower_ends;  // the last position that went to the drive
  safety_record noted{};
};

}  // namespace cca::hardware
