// What a rule is. Each rule is a struct in a header of its own under diagnosis/rules/:
//
//   struct wire_two_writers {
//     static constexpr std::string_view id = "wire.two_writers";
//     static constexpr bool is_broken(when::second_writer, const flat_view& g, finding& facts);
//     static constexpr void tell(auto& m);   // the sentence: what, where, why and what to do
//   };
//
// A step of the plan reports an event: check<when::second_writer>(g, {.item = ..., .input = ..., ...}). Every
// rule with an `is_broken` for this event is then asked, in the order of rules.hpp. It may add facts that its
// message needs. Only the first broken rule of a graph is kept, as flat_view::found.
//
// A wing has events of its own, which name the list of its rules: `using asked = its_rules`.
//
// `tell` is a template, so unused messages are not compiled.
#pragma once

#include <cca/base/nearest.hpp>
#include <cca/graph/diagnosis/message_writer.hpp>
#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/names.hpp>

namespace cca::detail::when {

// The events, in the order of the steps; in brackets the facts that are set. `item` and `scope` are set
// everywhere but in the events that say otherwise.

// flatten
struct any_item {};            // of a graph
struct named_node {};          // a component or an inner graph
struct repeated_name {};       // a second node of this name, or a second exposed port
struct component_kind {};      // a component, before its functions are looked at
struct component_function {};  // [function]
struct component_port {};      // [input or output, name]
struct repeated_port {};       // a second port of this name [input or output, name]
struct whole_component {};     // a component with its hooks and parameters
struct stated_strategy {};     // a node or inner graph with a strategy
struct node_of_part {};        // a component in a part that may be stopped
struct exposed_name {};        // the outer name of an expose
// The path of an expose, observe, latency or wire names no such port [at_reader], of a wire also
// [is_opposite, is_reversed].
struct unknown_port {};
// connect
struct wire_options {};   // a wire
struct second_writer {};  // a wire to an input that has one [input, output]
struct connection {};     // a wire between two ports [input, output]
struct open_input {};     // an input that nothing feeds [input]
struct unknown_part {};   // a component stops or starts what is no part [name]
// listen; the item is an observe of a graph, or the node of an observer [input]
struct observer_policy {};
struct unheard_pattern {};  // it names nothing
// A path for which a component asks [call, name, axis; input and output: of its link].
struct asked_path {};
// find the rate
struct stated_rate {};  // [item, scope]
struct second_rate {};  // a rate that is not the graph's
struct known_rate {};   // [no item]
// find the order
struct connected_call {};   // a function whose inputs are wired [call]
struct unordered_calls {};  // some calls have no place in the order [no item]
// find the clocks
struct clocked_output {};  // [output]
struct clocked_wire {};    // [input, output]
// whole graph
struct finished_call {};   // [call]
struct finished_input {};  // of a space [input]
struct stated_latency {};  // [output, input]: both ends of a require

}  // namespace cca::detail::when
