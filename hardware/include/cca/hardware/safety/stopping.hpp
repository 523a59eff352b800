// How the drives stop: the guards after the emergency stop.
//
//   act   in "wanted" set_points, "joints" joint_states; out "safe" set_points
//   soft_stop<Joints, Beats>   in the mode `soft` holds each joint at its measured position. Over `Beats`
//                              beats its stiffness goes to 0, its damping to `safe_damping` of its servo;
//                              then the mode is `damped`. A joint without stiffness, which follows a torque,
//                              has `safe_damping` at once, and no torque
//   damping_stop               in the modes `damped` and `barred`: no stiffness, no torque, `safe_damping`
//                              against any motion. Not zero torque, because a leg would fall, and not a
//                              position, because that is stiff against people
//
// Cost: a comparison a joint while the robot runs. Source: Unitree's reaction to a lost command
// (unitree_legged_sdk, cmd_lost_timelimit).
#pragma once

#include <array>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/port.hpp>
#include <cca/hardware/drives/set_points.hpp>

namespace cca::hardware {

namespace detail {

template <int Beats>
struct no_time_to_get_soft {
  static constexpr void tell(auto& m) {
    m << "cca::hardware::soft_stop: the joints are to get soft within " << Beats
      << " beats: make this number 1 or more";
  }
};

}  // namespace detail

template <class Joints, int Beats = 100>
class soft_stop {
  static_assert(cca::detail::holds_or_tells<(Beats >= 1), detail::no_time_to_get_soft<Beats>>::value);

public:
  auto act(in<"wanted", set_points<Joints>> wanted, in<"joints", joint_states<Joints>> joints)
      -> out<"safe", set_points<Joints>> {
    auto v = wanted.vector();
    if (set_point::of(v, 0).mode() != motion_mode::soft) {
      since = 0;
      for (std::size_t i = 0; i < Joints::count; ++i) from[i] = set_point::of(v, i);
      return v;
    }
    const double left = 1 - static_cast<double>(since) / Beats;
    for (std::size_t i = 0; i < Joints::count; ++i) {
      const joint_state q = joint_state::of(joints.vector(), i);
      if (since == 0) from[i].position = q.known() ? q.angle : from[i].position;
      set_point s;
      s.position = from[i].position;
      s.stiffness = left * from[i].stiffness;
      const double safe = Joints::servo[i].safe_damping;
      s.damping = from[i].stiffness > 0 ? left * from[i].damping + (1 - left) * safe : safe;
      s.mark = since < Beats ? motion_mode::soft : motion_mode::damped;
      s.put(v, i);
    }
    if (since < Beats) ++since;
    return v;
  }
  void on_start() { *this = {}; }

private:
  std::array<drive_command, Joints::count> from{};
  int since = 0;
};

template <class Joints>
struct damping_stop {
  auto act(in<"wanted", set_points<Joints>> wanted, in<"joints", joint_states<Joints>> joints)
      -> out<"safe", set_points<Joints>> {
    auto v = wanted.vector();
    const motion_mode mode = set_point::of(v, 0).mode();
    if (mode < motion_mode::damped) return v;
    for (std::size_t i = 0; i < Joints::count; ++i) {
      const joint_state q = joint_state::of(joints.vector(), i);
      set_point s;
      s.position = Joints::angle[i].nearest(q.known() ? q.angle : 0);
      s.damping = Joints::servo[i].safe_damping;
      s.mark = mode;
      s.put(v, i);
    }
    return v;
  }
};

}  // namespace cca::hardware
