// The safety chain in front of the drives, as items of a robot's graph: its nodes in order and the wires
// between them.
//
//   servos -> finite -> stale -> emergency_stop -> soft_stop -> damping_stop -> rate -> limits -> Synchronizer
//
// The servos make set points of what the robot's joints want: `Servos` has "wanted" out, "joints" in, and its
// `joints`. Each link takes the set points of the one before it as "wanted" and passes them on as "safe".
// `Synchronizer` names the node that has the drives: it takes "set_points" and gives "joints". `Rate` is that
// of the robot. Cost: that of the links. Example: cca/hardware/robot/robot.hpp; docs/hardware.md.
#pragma once

#include <cca/base/joined_names.hpp>
#include <cca/hardware/safety/beats.hpp>
#include <cca/hardware/safety/bounds.hpp>
#include <cca/hardware/safety/emergency_stop.hpp>
#include <cca/hardware/safety/guards.hpp>
#include <cca/hardware/safety/stopping.hpp>
#include <cca/robots/items.hpp>

namespace cca::hardware {

namespace detail {

template <fixed_string Synchronizer, fixed_string... Readers>
using joint_state_wires = robots::items<
    wire<cca::detail::joined_name<Synchronizer, "joints">, cca::detail::joined_name<Readers, "joints">>...>;

}  // namespace detail

template <class Servos, class Rate, class Joints = typename Servos::joints>
using safety_nodes = robots::items<node<"servos", Servos>,
                                   node<"finite", finite_guard<Joints>>,
                                   node<"stale", stale_guard<Joints>>,
                                   node<"emergency_stop", emergency_stop<Joints>>,
                                   node<"soft_stop", soft_stop<Joints, beats<Rate>::in(100'000'000)>>,
                                   node<"damping_stop", damping_stop<Joints>>,
                                   node<"rate", rate_guard<Joints, Rate>>,
                                   node<"limits", limit_guard<Joints>>>;

template <fixed_string Synchronizer>
using safety_wires = robots::items<wire<"servos.wanted", "finite.wanted">,
                                   wire<"finite.safe", "stale.wanted">,
                                   wire<"stale.safe", "emergency_stop.wanted">,
                                   wire<"emergency_stop.safe", "soft_stop.wanted">,
                                   wire<"soft_stop.safe", "damping_stop.wanted">,
                                   wire<"damping_stop.safe", "rate.wanted">,
                                   wire<"rate.safe", "limits.wanted">,
                                   wire<"limits.safe", cca::detail::joined_name<Synchronizer, "set_points">>>;

// The guards that look at where the joints are.
template <fixed_string Synchronizer>
using safety_readings = detail::joint_state_wires<Synchronizer,
                                                  "servos",
                                                  "emergency_stop",
                                                  "soft_stop",
                                                  "damping_stop",
                                                  "rate",
                                                  "limits">;

}  // namespace cca::hardware
