// The resource nodes of the Oncilla on real drives, with the ports of those in the simulator
// (cca/sim/resource_nodes.hpp), and the servos of its joints.
//
//   joint_node<Axis>   sense: in "measured"; out "angle" (rad), "velocity" (rad/s), "torque" (N m, as the
//                             drive reports it), each a maybe
//                      act:   in "command" (rad); out "target", of no origin (`never`) until a command comes
//   trunk_node         sense: in "measured"; out each field of trunk_record under its name, each a maybe
//   joint_servos       act:   in one target for each joint, "joints", optional "stiffness" of the hips;
//                             out "wanted" wanted_points: each joint's servo law, with the speed of its
//                             target. Without a target a joint holds its position.
//
// Until a drive or the board reports a quantity, its port publishes nothing. So "angles" of the whole robot
// come once all drives have reported theirs. A target's stiffness scales its damping, as in the simulator.
// Cost: some operations a joint.
#pragma once

#include <array>
#include <tuple>

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/drives/set_points.hpp>
#include <cca/hardware/robot/robot_nodes.hpp>
#include <cca/robots/oncilla/spaces.hpp>

namespace cca::hardware {

namespace detail {

template <class Fields>
struct trunk_node_of;
template <class... Fields>
struct trunk_node_of<robots::items<Fields...>> {
  auto sense(in<"measured", robots::oncilla::measured_trunk> now)
      -> std::tuple<maybe<Fields::name, typename Fields::space>...> {
    return {published<Fields::name, typename Fields::space, robots::oncilla::trunk_record>(now.vector())...};
  }
};

}  // namespace detail

template <class Axis>
struct joint_node {
  using record = robots::oncilla::joint_record<Axis>;
  using angle = robots::oncilla::joint_angle<Axis>;
  using velocity = robots::oncilla::joint_velocity<Axis>;
  using torque = robots::oncilla::joint_torque<Axis>;

  auto sense(in<"measured", robots::oncilla::measured_joint<Axis>> now)
      -> std::tuple<maybe<"angle", angle>, maybe<"velocity", velocity>, maybe<"torque", torque>> {
    const auto& v = now.vector();
    return {detail::published<"angle", angle, record>(v), detail::published<"velocity", velocity, record>(v),
            detail::published<"torque", torque, record>(v)};
  }
  auto act(in<"command", angle> wanted) -> out<"target", angle> {
    return out<"target", angle>(wanted.vector()).with_origin(wanted.origin());
  }
};

struct trunk_node : detail::trunk_node_of<robots::oncilla::trunk_record::fields> {};

template <class Joints>
class joint_servos;

template <class... J>
class joint_servos<joint_list<J...>> {
public:
  using joints = joint_list<J...>;

  auto act(in<J::axis::label, robots::oncilla::joint_angle<typename J::axis>>... targets,
           in<"joints", joint_states<joints>> states,
           optional_in<"stiffness", robots::oncilla::hip_stiffnesses> stiffness,
           beat now) -> out<"wanted", wanted_points<joints>> {
    typename wanted_points<joints>::vector_type v;
    std::size_t i = 0;
    const auto follow = [&]<class Axis>(double target, bool given, std::type_identity<Axis>) {
      const joint_state q = joint_state::of(states.vector(), i);
      const joint_servo& servo = joints::servo[i];
      wanted_point s;
      s.position = given ? target : joints::angle[i].nearest(q.known() ? q.angle : 0);
      s.velocity = given && begun[i] ? joints::speed[i].nearest((target - former[i]) / now.dt()) : 0;
      s.stiffness = servo.stiffness;
      if constexpr (robots::oncilla::hip_axes::template contains<Axis>)
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
