// What the drives of a robot's joints report, and what is wrong with it.
//
//   hear<J, I>(bus, frame, offset, moving)
//                  decodes a frame for joint I, in the joint's dimension with its offset. While the robot
//                  moves, a position that is farther from the last one than the joint can have turned is a
//                  jump, and is not taken
//   begin_beat(), check()
//                  before and after the frames of a beat. A drive trips if it has been silent for
//                  `silent_beats` or three of its own periods, has jumped as often in a row, or in every
//                  second report (two drives under one id), is not alone (sender_check.hpp), reports a fault,
//                  or is disabled
//   trip(i, rule)  keeps the first rule of joint i; forget_trips() before a new start
//
// Used by can_synchronizer.hpp. Cost: some operations a frame and a joint. docs/hardware.md.
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

namespace cca::hardware {

template <class... J>
struct joint_monitor {
  static constexpr std::size_t count = sizeof...(J);
  static constexpr int silent_beats = 3;

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
    position_unwrap unwrapped = unwraps[I];
    if ((heard.told & of_velocity) && !std::isfinite(heard.velocity)) return note_jump(I), true;
    if (heard.told & of_position) {
      const double position = One::mounted.wraps > 0 ? unwrapped(heard.position) : heard.position;
      const double now = One::angle_of(position) + offset;
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
      angle[I] = now;
    }
    if (heard.told & of_velocity) speed[I] = One::speed_of(heard.velocity);
    if (heard.told & of_torque) torque[I] = One::torque_of(heard.torque);
    reports[I] = heard;
    return true;
  }

  void begin_beat() { before = frames(); }
  void check() {
    const auto now = frames();
    for (std::size_t i = 0; i < count; ++i) {
      quiet[i] = now[i] == before[i] ? quiet[i] + 1 : 0;
      senders[i].begin_beat();
      if (jumps[i] >= 2 * silent_beats || senders[i].too_many() || senders[i].has_stranger())
        trip(i, safety_rule::implausible);
      if (quiet[i] >= silent_after[i]) trip(i, safety_rule::silent);
      if (reports[i].fault != drive_fault::none || reports[i].activity == drive_activity::disabled)
        trip(i, safety_rule::drive_fault);
    }
  }

  void trip(std::size_t i, safety_rule rule) {
    if (trips[i] == safety_rule::none) trips[i] = rule;
  }
  void forget_trips() { trips.fill(safety_rule::none), quiet.fill(0), senders.fill({}); }
  void forget_jumps() { jumps.fill(0); }

  // How far the unwrapped angle of joint I is from the one that its drive counts: take this off a command, so
  // that it never leads across the end of the range.
  template <class One>
  double turned(std::size_t i) const {
    return One::mounted.wraps > 0 && std::isfinite(angle[i]) ? One::speed_of(unwraps[i].turned()) : 0;
  }

private:
  void note_jump(std::size_t i) { jumps[i] += 2; }
  static constexpr std::array<double, count> unknown() { return {(sizeof(J) ? drive_report::untold : 0)...}; }
  static constexpr std::array<int, count> silent_after{patience<J>(silent_beats, 1'000'000)...};

  std::array<std::uint64_t, count> frames() const {
    std::array<std::uint64_t, count> all;
    std::ranges::transform(reports, all.begin(), &drive_report::frames);
    return all;
  }

  std::array<std::uint64_t, count> before{};
  std::array<std::int64_t, count> reported_at{};
  std::array<position_unwrap, count> unwraps{position_unwrap(J::mounted.wraps)...};
  std::array<sender_check, count> senders{};
  std::array<int, count> quiet{}, jumps{};
};

}  // namespace cca::hardware
