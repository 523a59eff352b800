// What the drives of a robot's joints report, how old it is, and what is wrong with it.
//
//   hear<J, I>(bus, frame, offset, moving)
//                  decodes a frame for joint I, in the joint's dimension with its offset. While the robot
//                  moves, a position that is farther from the last one than the joint can have turned is a
//                  jump, and is not taken
//   begin_beat(), check()
//                  before and after the frames of a beat. A drive trips if it has been silent for three
//                  beats or three of its own periods, and at least 3 ms (beats.hpp); if it still sends, but
//                  no angle, no velocity or, where it has reported one, no torque for that time, or no state
//                  for 350 ms; if it has jumped in three reports in a row, or in every second report (two
//                  drives under one id); if it is not alone (sender_check.hpp); if its velocity is not the
//                  change of its angle (velocity_check.hpp); if it reports a fault, or that it is disabled
//   is_ready(i)     angle and velocity of joint i have been measured since `restart`, and agree; so has its
//                  torque, if its drive must report it (torque_period in drives/drive.hpp) or has done so
//   angle_now(i), speed_now(i), torque_now(i)
//                  what is measured; not a number where it is too old
//   can_be_damped(i)
//                  a drive that takes torque alone is damped by the velocity that it reports: it is enabled,
//                  and that velocity is known and has not been found wrong
//   trip(i, rule)  keeps the first rule of joint i; forget_trips() when motion begins; restart() for a new
//                  start: everything must be measured again
//
// joint_monitor<cca::rate<Hz>, J...> is for a robot of another rate than 1 kHz. Used by
// drive_synchronizer.hpp. Cost: some operations a frame and a joint. docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <cca/hardware/bus/can_bus.hpp>
#include <cca/hardware/drives/position_unwrap.hpp>
#include <cca/hardware/drives/set_points.hpp>
#include <cca/hardware/robot/joint_frames.hpp>
#include <cca/hardware/robot/sender_check.hpp>
#include <cca/hardware/robot/velocity_check.hpp>
#include <cca/hardware/safety/beats.hpp>

namespace cca::hardware {

template <class... J>
struct joint_monitor;

template <auto Hz, class... J>
struct joint_monitor<cca::rate<Hz>, J...> {
  using time = beats<cca::rate<Hz>>;
  static constexpr std::size_t count = sizeof...(J);
  static constexpr int silent_beats = time::patience(0);
  static constexpr int state_beats = time::lasting(350'000'000);  // an ODrive reports its state every 100 ms
  static constexpr int most_jumps = 3;

  std::array<drive_report, count> reports{};
  std::array<double, count> angle = unknown(), speed{}, torque{};  // of the joint: rad, rad/s, N m
  std::array<safety_rule, count> trips{};

  template <class One, std::size_t I>
  bool hear(std::size_t bus, const received_frame& f, double offset, bool moving) {
    if (One::bus != bus) return false;
    drive_report heard = reports[I];
    if (!One::drive::decode(f.frame, heard)) {
      if (moving && is_command<typename One::drive>(f.frame)) senders[I].commanded();
      return false;
    }
    if (moving && report_period_of<typename One::drive> == 0 && (heard.told & of_position))
      senders[I].answered(f.frame);  // CANopen drives send further frames in a cycle
    if ((heard.told & of_velocity) && !std::isfinite(heard.velocity)) return note_jump(I), true;
    position_unwrap unwrapped = unwraps[I];
    const double position =
        One::mounted.wraps > 0 && (heard.told & of_position) ? unwrapped(heard.position) : heard.position;
    const double now = One::angle_of(position) + offset;
    if (heard.told & of_position) {
      const double pause = static_cast<double>(f.time - reported_at[I]) * 1e-9;
      const double fastest = 1.5 * std::max(One::speed.upper, -One::speed.lower);
      if (moving && std::isfinite(angle[I]) &&
          !(std::abs(now - angle[I]) <= 0.05 + fastest * (pause + 1e-3))) {
        note_jump(I);
        return true;
      }
      jumps[I] = std::max(0, jumps[I] - 1);  // not to 0: of two drives under one id every second one jumps
      unwraps[I] = unwrapped;
      reported_at[I] = f.time;
    }
    ages& age = since[I];
    age.frame = 0;
    if (heard.told & of_activity) age.state = 0;
    // A drive that has no number for its torque has not reported one.
    if ((heard.told & of_torque) && std::isfinite(heard.torque))
      torque[I] = One::torque_of(heard.torque), age.torque = 0;
    if (heard.told & of_velocity) speed[I] = One::speed_of(heard.velocity), age.speed = 0;
    if (heard.told & of_position) {
      angle[I] = now, age.angle = 0;
      if (age.speed < untold && std::isfinite(now)) velocities[I].compare(now, speed[I], f.time);
    }
    reports[I] = heard;
    return true;
  }

  void begin_beat() {
    for (ages& a : since)
      for (int* age : {&a.frame, &a.angle, &a.speed, &a.torque, &a.state}) *age += *age < untold - 1;
  }
  void check() {
    for (std::size_t i = 0; i < count; ++i) {
      const ages& a = since[i];
      senders[i].begin_beat();
      if (jumps[i] >= 2 * most_jumps || senders[i].too_many() || senders[i].has_stranger() ||
          velocities[i].disagrees())
        trip(i, safety_rule::implausible);
      if (a.frame >= silent_after[i]) trip(i, safety_rule::silent);
      if (is_old(i, a.angle) || is_old(i, a.speed) || has_lost_torque(i) ||
          (a.state >= state_beats && a.state < untold))
        trip(i, safety_rule::implausible);
      if (reports[i].fault != drive_fault::none || reports[i].activity == drive_activity::disabled)
        trip(i, safety_rule::drive_fault);
    }
  }

  bool is_ready(std::size_t i) const {
    return std::isfinite(angle[i]) && knows_angle(i) && knows_speed(i) && knows_torque(i) &&
           velocities[i].passed();
  }
  bool knows_angle(std::size_t i) const { return std::isfinite(angle[i]) && !is_old(i, since[i].angle); }
  bool knows_speed(std::size_t i) const { return !is_old(i, since[i].speed); }
  // True for a drive that need not report its torque, and has not yet.
  bool knows_torque(std::size_t i) const {
    return since[i].torque == untold ? !must_report_torque[i] : !has_lost_torque(i);
  }
  const velocity_check& velocity(std::size_t i) const { return velocities[i]; }

  double angle_now(std::size_t i) const {
    return is_old(i, since[i].angle) ? drive_report::untold : angle[i];
  }
  double speed_now(std::size_t i) const {
    return is_old(i, since[i].speed) ? drive_report::untold : speed[i];
  }
  double torque_now(std::size_t i) const {
    return since[i].torque >= torque_lost_after[i] ? drive_report::untold : torque[i];
  }

  bool can_be_damped(std::size_t i) const {
    return reports[i].activity == drive_activity::enabled && knows_speed(i) && std::isfinite(speed[i]) &&
           !velocities[i].disagrees() && trips[i] != safety_rule::implausible;
  }

  void trip(std::size_t i, safety_rule rule) {
    if (trips[i] == safety_rule::none) trips[i] = rule;
  }
  // How far the unwrapped angle of joint I is from the one that its drive counts: take this off a command, so
  // that it never leads across the end of the range.
  template <class One>
  double turned(std::size_t i) const {
    return One::mounted.wraps > 0 && std::isfinite(angle[i]) ? One::speed_of(unwraps[i].turned()) : 0;
  }

  // Beats without a frame of its drive.
  int silent_for(std::size_t i) const { return since[i].frame; }

  void forget_trips() { trips.fill(safety_rule::none), senders.fill({}); }
  void restart() {
    forget_trips();
    jumps.fill(0);
    since.fill({});
    velocities.fill({});
  }

private:
  void note_jump(std::size_t i) { jumps[i] += 2; }
  static constexpr int untold = 1 << 30;
  // Beats since the drive reported this.
  struct ages {
    int frame = untold, angle = untold, speed = untold, torque = untold, state = untold;
  };
  static constexpr std::array<double, count> unknown() { return {(sizeof(J) ? drive_report::untold : 0)...}; }
  static constexpr std::array<int, count> silent_after{
      time::patience(report_period_of<typename J::drive>)...};
  static constexpr std::array<int, count> torque_lost_after{
      time::patience(torque_period_of<typename J::drive>)...};
  static constexpr std::array<bool, count> must_report_torque{requires {J::drive::torque_period;
}...
};  // namespace cca::hardware
static bool is_old(std::size_t i, int age) { return age >= silent_after[i]; }
bool has_lost_torque(std::size_t i) const {
  return since[i].torque >= torque_lost_after[i] && since[i].torque < untold;
}

std::array<ages, count> since{};
std::array<velocity_check, count> velocities{};
std::array<std::int64_t, count> reported_at{};
std::array<position_unwrap, count> unwraps{position_unwrap(J::mounted.wraps)...};
std::array<sender_check, count> senders{};
std::array<int, count> jumps{};
}
;

template <class... J>
struct joint_monitor : joint_monitor<cca::rate<1000>, J...> {};

}  // namespace cca::hardware
