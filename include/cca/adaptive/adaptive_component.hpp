// An Adaptive Component: an adaptive module, a criterion and their connectivity (seed, section 4.4.4,
// figure 4.6), as a graph.
//
//   struct dmp : cca::adaptive_component<module, cca::tracking<leg_angles>> {};
//   cca::node<"dmp", dmp>
//
//   in  "reference"       what it shall follow or reach
//   in  "feedback"        what is measured
//   in  by their names    the module's other inputs (control inputs), the criterion's other inputs
//   out "command"         the control variable
//   out "ode_status", "module_status", "component_status"
//   out by their names    the module's other outputs; "error", the criterion's
//
// Inside: `module`, `criterion`, `status`, so that `observe<"dmp.status.*">` hears dmp.status.ode, .module
// and .component. The module is a component, or a graph, with the ports "reference", "command", "ode" and,
// where it learns, "module". Options, in any order:
//   a strategy                         of module, criterion and status; else timed<1>
//   named<"goal", "position", "status">   other names of the module's reference, command and ode status
//   against<criterion_target::reference>  what the criterion takes as target, if not what it says itself
//   reference_through<M>, feedback_through<M>, command_through<M>, control_through<"name", M>
//                                      a mapping M on that port: outside of it M's space, inside of it the
//                                      module's
// Errors: criterion.spaces; those of a graph. Cost: that of its parts. Example:
// tests/runtime/adaptive/tracker.cpp.
#pragma once

// First: where this refuses something, the compilers tell of each file around it.
#include <cca/component/port.hpp>

#include <cca/adaptive/assembly/adaptive_items.hpp>

namespace cca {

template <class Module, Criterion Measure, class... Options>
struct adaptive_component
    : detail::graph_from<typename detail::adaptive_items<Module, Measure, Options...>::type> {};

// A Tracker: its reference moves, and the command follows it. The names are the seed's; the skeleton is the
// same.
template <class Module, Criterion Measure, class... Options>
struct tracker : adaptive_component<Module, Measure, Options...> {};

}  // namespace cca
