// The frames by which a joint's drive is told its set-point, in the way that its family can.
//
//   frames_for<J>(set_point, angle, speed)   of the joint, in its own dimension; none where a number is none
//     A drive that takes stiffness is told all of it. One that takes torque alone is told the torque that the
//     set-point makes where the joint is. One that goes by position or velocity with gains of its own is told
//     these.
//   Where the set-point may not run (motion_mode), it only damps: by `damp()` of drives that have it, and a
//   drive without stiffness is disabled. cycle_ends<Buses, J...>()   frames that end a cycle on each bus
//   (SYNC), each once patience<J>(beats, ns)  after how many beats of so many ns a drive is silent: those
//   that tell by themselves may take their time
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
drive_frames frames_for(set_point s, double angle, double speed) {
  using D = typename J::drive;
  constexpr bool by_stiffness = (D::uses & of_stiffness) != 0;
  constexpr bool by_torque = !by_stiffness && (D::uses & (of_position | of_velocity)) == 0;
  if (s.mode() != motion_mode::run) {
    if constexpr (!by_stiffness) return D::disable();
    else if constexpr (requires { D::damp(); })
      if (s.stiffness == 0) return D::damp();
  }
  if constexpr (by_torque) s.torque += s.stiffness * (s.position - angle) + s.damping * (s.velocity - speed);
  return D::set_point(J::to_drive(s)).frames;
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

template <class J>
constexpr int patience(int beats, std::int64_t beat) {
  return beats *
         static_cast<int>(std::max<std::int64_t>(1, (report_period_of<typename J::drive> + beat - 1) / beat));
}

}  // namespace cca::hardware
