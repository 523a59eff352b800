#pragma once
// The Oncilla with its simulator in another environment: all wires between them are delayed by a beat, as
// frames on a bus are.
//
// Ports: those of every Oncilla (cca/robots/oncilla/as_built.hpp); in "step", "timed_out" and out "ball" of
// the stage. Its resource nodes are those of the real robot: they publish nothing before the first reading.
// Its sensors come from the stage: who is in another environment reads them by a delayed wire.
#include <limits>

#include <cca/hardware/robot/robot_nodes.hpp>
#include <cca/robots/ports.hpp>

#include "stage.hpp"
#include "with_items.hpp"

namespace deployed {

template <class Axis>
struct joint_node : cca::hardware::driven_joint<built, Axis> {};

struct oncilla_on_stage
    : cca::robots::graph_of_robot<built,
                                  "simulator",
                                  stage,
                                  "simulator",
                                  joint_node,
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
                        cca::wire<cca::detail::joined_name<Axes::label, "wanted">,
                                  cca::detail::joined_name<"simulator", Axes::label>,
                                  cca::delayed<1>>...>;
};
// [wires end]

struct remote_oncilla : remote_wires<cca::robots::measured_axes_of<built>>::of<oncilla_on_stage> {};

}  // namespace deployed
