// From a joint's set point to the frames for its drive, as far as its family can follow it.
//
//   frames_for<J>(set_point, angle, speed, can_be_damped)
//                                            angle and speed in the joint's dimension; no frames for a set
//                                            point with a number that is not finite. A drive that takes
//                                            stiffness gets the whole set point; damping beyond its
//                                            most_damping(stiffness) becomes torque against the measured
//                                            speed. One that takes torque alone gets the torque that the set
//                                            point makes at this angle and speed. One with gains of its own
//                                            gets position and velocity. In a mode other than `run` the drive
//                                            only damps: by damp() where it has that. One that takes torque
//                                            alone is damped by torque against its speed, or else disabled
//                                            (`can_be_damped`, joint_monitor.hpp); one with gains of its own
//                                            is disabled. A continuous joint whose set point lies beyond
//                                            the end of what its drive can say gets a torque instead
//   cycle_ends<Buses, J...>()                the frames that end a cycle on each bus (SYNC), each once
//   is_off<D>(report)                        the drive says that it holds nothing. A drive for which that is
//                                            not the activity `disabled` or `faulted` states its own is_off;
//                                            one that can't say it has answered
//
// Cost: some multiplications and the codec's. docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/drives/set_points.hpp>

namespace cca::hardware {

template <class J>
drive_frames frames_for(set_point s, double angle, double speed, bool can_be_damped) {
  using D = typename J::drive;
  constexpr bool by_stiffness = (D::uses & of_stiffness) != 0;
  constexpr bool by_torque = !by_stiffness && (D::uses & (of_position | of_velocity)) == 0;
  const bool runs = s.mode() == motion_mode::run;
  if (!runs) {
    if constexpr (by_torque) {
      if (!can_be_damped) return D::disable();
    } else if constexpr (!by_stiffness) {
      return D::disable();
    } else if constexpr (requires { D::damp(); }) {
      if (s.stiffness == 0) return D::damp();
    }
  }
  if constexpr (by_torque) s.torque += s.stiffness * (s.position - angle) + s.damping * (s.velocity - speed);
  // Across the end of the range of its position a drive can't be led by position, so by torque.
  if constexpr (is_continuous<typename J::axis> && by_stiffness && D::limits.template has<cca::angle>) {
    constexpr auto range = D::limits.template of<cca::angle>();
    const double there = J::drive_angle_of(s.position);
    if (there < range.lower || there > range.upper)
      s.torque += s.stiffness * (s.position - angle), s.position = angle, s.stiffness = 0;
  }
  drive_command c = J::to_drive(s);
  if constexpr (requires { D::most_damping(c.stiffness); })
    if (const double most = D::most_damping(c.stiffness); c.damping > most) {
      if (runs || can_be_damped) c.torque += (c.damping - most) * (c.velocity - J::drive_speed_of(speed));
      c.damping = most;
    }
  return D::set_point(c).frames;
}

template <std::size_t Buses, class... J>
constexpr auto cycle_ends() {
  std::array<frame_list<4>, Buses> all;
  const auto add = [](frame_list<4>& ends, const auto& frames) {
    for (const can_frame& f : frames)
      if (std::find(ends.begin(), ends.end(), f) == ends.end()) ends.add(f);
  };
  (add(all[J::bus], cycle_frames_of<typename J::drive>), ...);
  return all;
}

template <Drive D>
constexpr bool is_off(const drive_report& r) {
  if constexpr (requires { D::is_off(r); }) return D::is_off(r);
  else return r.activity == drive_activity::disabled || r.activity == drive_activity::faulted;
}

}  // namespace cca::hardware
