// The resource nodes of the Oncilla on real drives, with the ports of those in the simulator
// (cca/sim/resource_nodes.hpp).
//
//   joint_node<Axis>   sense: in "measured"; out "angle" (rad), "velocity" (rad/s), "torque" (N m, as the
//   drive tells), each a maybe
//                      act:   in "command" (rad); out "target", of no origin (`never`) until a command has
//                      come
//   trunk_node         sense: in "measured"; out "orientation", "angular_velocity", "acceleration",
//   "contacts" (status),
//                      "foot_loads" (N), "abduction" (rad), each a maybe
//   joint_servos       act:   in the targets, "joints", optional "stiffness" of the hips; out "wanted"
//   set_points: the law of
//                      each joint's servo, with the speed of its target. Without a target it holds where the
//                      joint is.
//
// What a drive or the board has not told yet is not published: a sample is what was measured. So "angles" of
// the whole robot come once all drives have told theirs. A target's stiffness takes its damping with it, as
// in the simulator. Cost: some operations a joint.
#pragma once

#include <array>
#include <tuple>

#include <cca/component/beat.hpp>
#include <cca/base/inlining.hpp>
#include <cca/component/port.hpp>
#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/drives/set_points.hpp>
#include <cca/sim/oncilla_spaces.hpp>

namespace cca::hardware {

namespace detail {

// A part of a record as a port, if `witness` says that it has been told: it is a number.
template <fixed_string Name, class Space, class Record>
CCA_GLUE maybe<Name, Space> told(const Record& v, int from, int witness) {
  if (v[witness] - v[witness] == 0) return v.template segment<Space::vector_type::RowsAtCompileTime>(from);
  return {};
}
template <fixed_string Name, class Space, class Record>
CCA_GLUE maybe<Name, Space> told(const Record& v, int from) {
  return told<Name, Space>(v, from, from);
}

}  // namespace detail

template <class Axis>
struct joint_node {
  auto sense(in<"measured", sim::measured_joint<Axis>> now)
      -> std::tuple<maybe<"angle", sim::joint_angle<Axis>>,
                    maybe<"velocity", sim::joint_velocity<Axis>>,
                    maybe<"torque", sim::joint_torque<Axis>>> {
    const auto& v = now.vector();
    return {detail::told<"angle", sim::joint_angle<Axis>>(v, 0),
            detail::told<"velocity", sim::joint_velocity<Axis>>(v, 1),
            detail::told<"torque", sim::joint_torque<Axis>>(v, 2)};
  }
  auto act(in<"command", sim::joint_angle<Axis>> wanted) -> out<"target", sim::joint_angle<Axis>> {
    return out<"target", sim::joint_angle<Axis>>(wanted.vector()).with_origin(wanted.origin());
  }
};

struct trunk_node {
  auto sense(in<"measured", sim::measured_trunk> now)
      -> std::tuple<maybe<"orientation", sim::trunk_orientation>,
                    maybe<"angular_velocity", sim::trunk_angular_velocity>,
                    maybe<"acceleration", sim::trunk_acceleration>,
                    maybe<"contacts", sim::foot_contacts>,
                    maybe<"foot_loads", sim::foot_loads>,
                    maybe<"abduction", sim::abduction_angles>> {
    const auto& v = now.vector();
    return {detail::told<"orientation", sim::trunk_orientation>(v, 0),
            detail::told<"angular_velocity", sim::trunk_angular_velocity>(v, 4),
            detail::told<"acceleration", sim::trunk_acceleration>(v, 7),
            detail::told<"contacts", sim::foot_contacts>(v, 14, 4),  // in the frame of the angular velocity
            detail::told<"foot_loads", sim::foot_loads>(v, 10),
            detail::told<"abduction", sim::abduction_angles>(v, 18)};
  }
};

template <class Joints>
class joint_servos;

template <class... J>
class joint_servos<joint_list<J...>> {
public:
  using joints = joint_list<J...>;

  auto act(in<J::axis::label, sim::joint_angle<typename J::axis>>... targets,
           in<"joints", joint_states<joints>> states,
           optional_in<"stiffness", sim::hip_stiffnesses> stiffness,
           beat now) -> out<"wanted", set_points<joints>> {
    typename set_points<joints>::vector_type v;
    std::size_t i = 0;
    const auto follow = [&]<class Axis>(double target, bool given, std::type_identity<Axis>) {
      const joint_state q = joint_state::of(states.vector(), i);
      const joint_servo& servo = joints::servo[i];
      set_point s;
      s.position = given ? target : joints::angle[i].nearest(q.known() ? q.angle : 0);
      s.velocity = given && begun[i] ? joints::speed[i].nearest((target - former[i]) / now.dt()) : 0;
      s.stiffness = servo.stiffness;
      if constexpr (sim::hip_axes::template contains<Axis>)
        if (stiffness && stiffness.origin() != never) s.stiffness = stiffness[Axis{}];
      s.damping = servo.damping * s.stiffness / servo.stiffness;
      if (given) former[i] = target;
      begun[i] = given;
      s.put(v, i++);
    };
    (follow(targets.vector()[0], targets.origin() != never, std::type_identity<typename J::axis>()), ...);
    return v;
  }
  void on_start() { begun = {}; }

private:
  std::array<double, sizeof...(J)> former{};
  std::array<bool, sizeof...(J)> begun{};
};

}  // namespace cca::hardware
