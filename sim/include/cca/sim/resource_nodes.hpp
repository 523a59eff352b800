#pragma once
// The resource nodes of the Oncilla: a hip and a knee for each leg, and the trunk. They say in the robot's
// spaces what the synchronizer says in the simulator's; a controller sees only them.
//
//   hip_node, knee_node   sense: in "measured"; out "angle" (rad), "velocity" (rad/s), "torque" (N m of the
//   motor)
//                         act:   in "command" (rad); out "target"
//   trunk_node            sense: in "measured"; out "orientation", "angular_velocity", "acceleration",
//   "contacts" (status,
//                         1: the foot touches), "foot_loads" (N), "abduction" (rad)
//
// Cost: none after inlining.
#include <tuple>

#include <cca/component/port.hpp>

#include <cca/sim/oncilla_spaces.hpp>
#include <cca/sim/simulator.hpp>

namespace cca::sim {

template <class Axis>
struct joint_node {
  auto sense(in<"measured", measured_joint<Axis>> now) -> std::tuple<out<"angle", joint_angle<Axis>>,
                                                                     out<"velocity", joint_velocity<Axis>>,
                                                                     out<"torque", joint_torque<Axis>>> {
    return {now.vector()[0], now.vector()[1], now.vector()[2]};
  }

  auto act(in<"command", joint_angle<Axis>> wanted) -> out<"target", joint_angle<Axis>> {
    return wanted.vector();
  }
};

template <class Axis>
struct hip_node : joint_node<Axis> {};

// Its command is the flexion that the cable is wound to: the knee flexes at least so far as the springs let
// it.
template <class Axis>
struct knee_node : joint_node<Axis> {};

struct trunk_node {
  auto sense(in<"measured", measured_trunk> now)
      -> std::tuple<out<"orientation", trunk_orientation>,
                    out<"angular_velocity", trunk_angular_velocity>,
                    out<"acceleration", trunk_acceleration>,
                    out<"contacts", foot_contacts>,
                    out<"foot_loads", foot_loads>,
                    out<"abduction", abduction_angles>> {
    using at = trunk_record;
    const auto& v = now.vector();
    return {v.template segment<4>(at::orientation),    v.template segment<3>(at::angular_velocity),
            v.template segment<3>(at::specific_force), v.template segment<4>(at::contact),
            v.template segment<4>(at::foot_load),      v.template segment<4>(at::abduction)};
  }
};

}  // namespace cca::sim
