// An Adaptive Component: an adaptive module, a criterion and the wires between them, as a graph (the source
// document, section 4.4.4, figure 4.6).
//
//   struct dmp : cca::adaptive_component<module, cca::tracking<leg_angles>> {};
//   cca::node<"dmp", dmp>
//
//   in  "reference"          the wanted value: to follow or to reach
//   in  "feedback"           the measured value
//   in  <own names>          the other inputs of the module (control inputs) and of the criterion
//   out "command"            the control variable
//   out "ode_status"         ode_status_port
//   out "module_status"      module_status_port
//   out "component_status"   component_status_port
//   out "error"              criterion_error, of the criterion
//   out <own names>          the other outputs of the module
//
// The spaces are those of the module and the criterion. Inside are the nodes `module`, `criterion` and
// `status`, so `observe<"dmp.status.*">` receives dmp.status.ode, .module and .component. The module is a
// component or a graph with the ports "reference", "command", "ode" and, if it learns, "module".
//
// Options, in any order:
//   a strategy                            of module, criterion and status; default: timed<1>
//   named<"goal", "position", "status">   the module's names for reference, command and ode status
//   inner_wires<delayed<1>>               policies of the wires inside: with a delay its parts may run in
//                                         environments of their own; default: latest
//   against<criterion_target::reference>  the target of the criterion, instead of the criterion's default
//   reference_through<M>, feedback_through<M>, command_through<M>, control_through<"name", M>
//                                         the mapping M on that port: the port has the space of M, the module
//                                         keeps its own
//
// While an input is NaN or infinite, each part does what its header states. A module of motor/ keeps its
// state and "ode_status" is `unreadable`. If the criterion reads the number (the feedback, or the reference
// if that is its target), "error" is 1e12 and "component_status" is `diverged`. No fault:
// unreadable_fault.hpp makes one.
//
// Errors: criterion.spaces, wire.unknown_port; those of a graph. Cost: that of its parts.
// Example: tests/runtime/adaptive/tracker.cpp.
#pragma once

// Included first, so that its refusals are reported with fewer `In file included from` lines.
#include <cca/component/port.hpp>

#include <cca/adaptive/assembly/adaptive_items.hpp>

namespace cca {

template <class Module, Criterion Measure, class... Options>
struct adaptive_component
    : detail::graph_from<typename detail::adaptive_items<Module, Measure, Options...>::type> {
  static constexpr auto inner_wires_of = detail::wires_of::this_one;
};

// A Tracker: its reference moves and the command follows. The name is the source document's; the skeleton is
// the same.
template <class Module, Criterion Measure, class... Options>
struct tracker : adaptive_component<Module, Measure, Options...> {};

}  // namespace cca
