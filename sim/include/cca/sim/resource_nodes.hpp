// The resource nodes of the simulated Oncilla: one for each joint, and the trunk. They publish the raw
// readings of the synchronizer in the robot's spaces.
//
//   joint_node<Axis>   sense: in "measured"; out "angle" (rad), "velocity" (rad/s), "torque" (N m, of the
//                             motor)
//                      act:   in "command" (rad); out "target"
//   trunk_node         sense: in "measured"; out each field of trunk_record, under its name
//
// The command of a knee is the flexion that the cable is wound to: the knee flexes at least as far as the
// springs let it. Cost: none after inlining.
#pragma once

#include <tuple>

#include <cca/component/port.hpp>
#include <cca/robots/oncilla/spaces.hpp>

namespace cca::sim {

template <class Axis>
struct joint_node {
  using record = robots::oncilla::joint_record<Axis>;

  auto sense(in<"measured", robots::oncilla::measured_joint<Axis>> now)
      -> std::tuple<out<"angle", robots::oncilla::joint_angle<Axis>>,
                    out<"velocity", robots::oncilla::joint_velocity<Axis>>,
                    out<"torque", robots::oncilla::joint_torque<Axis>>> {
    const auto& v = now.vector();
    return {record::template part<"angle">(v), record::template part<"velocity">(v),
            record::template part<"torque">(v)};
  }

  auto act(in<"command", robots::oncilla::joint_angle<Axis>> wanted)
      -> out<"target", robots::oncilla::joint_angle<Axis>> {
    return wanted.vector();
  }
};

// The names of figure 6.1.
template <class Axis>
using hip_node = joint_node<Axis>;
template <class Axis>
using knee_node = joint_node<Axis>;

namespace detail {

template <class Fields>
struct trunk_node_of;
template <class... Fields>
struct trunk_node_of<robots::items<Fields...>> {
  auto sense(in<"measured", robots::oncilla::measured_trunk> now)
      -> std::tuple<out<Fields::name, typename Fields::space>...> {
    return {robots::oncilla::trunk_record::part<Fields::name>(now.vector())...};
  }
};

}  // namespace detail

struct trunk_node : detail::trunk_node_of<robots::oncilla::trunk_record::fields> {};

}  // namespace cca::sim
