#pragma once
// The Oncilla with its simulator in another environment: all wires between them are delayed by a beat, as
// frames on a bus are.
//
// Ports: those of every Oncilla (cca/robots/oncilla/robot.hpp); in "step", "timed_out" and out "ball" of the
// stage. Its resource nodes are those of the real robot: they publish nothing before the first reading, and
// no target before the first command.
#include <limits>

#include <cca/hardware/oncilla/oncilla_nodes.hpp>
#include <cca/robots/oncilla/robot.hpp>

#include "stage.hpp"
#include "with_items.hpp"

namespace deployed {

template <class Axis>
struct joint_node : cca::hardware::joint_node<Axis> {
  auto act(cca::in<"command", oncilla::joint_angle<Axis>> wanted)
      -> cca::maybe<"target", oncilla::joint_angle<Axis>> {
    if (wanted.origin() == cca::never) return {};
    return wanted.vector();
  }
};

struct oncilla_on_stage
    : oncilla::robot<"simulator",
                     stage,
                     "simulator",
                     joint_node,
                     cca::hardware::trunk_node,
                     cca::robots::items<cca::expose<"simulator.ball", "ball">,
                                        cca::expose<"simulator.step", "step">,
                                        cca::expose<"simulator.timed_out", "timed_out">>> {};

// Not a number: nothing has been measured yet.
using nothing_measured = cca::initial<std::numeric_limits<double>::quiet_NaN()>;

// [wires]
template <class Axes>
struct remote_wires;
template <class... Axes>
struct remote_wires<cca::axes<Axes...>> {
  template <class Robot>
  using of = with_items<Robot,
                        cca::wire<cca::detail::joined_name<"simulator", Axes::label>,
                                  cca::detail::joined_name<Axes::label, "measured">,
                                  cca::delayed<1>,
                                  nothing_measured>...,
                        cca::wire<"simulator.trunk", "trunk.measured", cca::delayed<1>, nothing_measured>,
                        cca::wire<cca::detail::joined_name<Axes::label, "target">,
                                  cca::detail::joined_name<"simulator", Axes::label>,
                                  cca::delayed<1>>...>;
};
// [wires end]

struct remote_oncilla : remote_wires<oncilla::leg_axes>::of<oncilla_on_stage> {};

}  // namespace deployed
