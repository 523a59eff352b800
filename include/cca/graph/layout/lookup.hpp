// Entries of the plan as constants, by number.
#pragma once

#include <cca/graph/layout/types.hpp>

namespace cca::detail {

template <class Graph, int Input>
inline constexpr const input& input_of = plan_of<Graph>.inputs[Input];
template <class Graph, int Output>
inline constexpr const output& output_of = plan_of<Graph>.outputs[Output];
template <class Graph, int Call>
inline constexpr const call& call_of = plan_of<Graph>.calls[Call];

template <class Graph, int Output>
inline constexpr const port_info& output_port_of =
    port_of(call_of<Graph, output_of<Graph, Output>.call>, output_of<Graph, Output>);
template <class Graph, int Input>
inline constexpr const port_info& input_port_of =
    call_of<Graph, input_of<Graph, Input>.call>.function->inputs[input_of<Graph, Input>.port];

template <class Graph, int Output>
inline constexpr int size_of_output = output_port_of<Graph, Output>.space->size;
// What an input reads: the space of its port, or, by an observer, of what it hears. What a program hears has
// no port.
template <class Graph, int Input>
inline constexpr const space_info& space_of_input = []() -> const space_info& {
  if constexpr (!input_of<Graph, Input>.outside && input_port_of<Graph, Input>.space) {
    return *input_port_of<Graph, Input>.space;
  } else {
    constexpr const link& heard = plan_of<Graph>.links[Input - counts_of<Graph>.first_link];
    if constexpr (heard.input < 0) return *output_port_of<Graph, heard.output>.space;
    else return *input_port_of<Graph, heard.input>.space;
  }
}();
template <class Graph, int Input>
inline constexpr int size_of_input = space_of_input<Graph, Input>.size;

template <class Graph, int Output>
inline constexpr clock published_of =
    published(call_of<Graph, output_of<Graph, Output>.call>, output_of<Graph, Output>);

template <class Graph, int Call>
using function_called =
    function_facts<typename function_of<typename node_types<Graph, call_of<Graph, Call>.node>::component,
                                        call_of<Graph, Call>.phase>::type>;

// The inputs and outputs of a function by their position in it.
template <class Graph, int Call>
using input_positions = std::make_integer_sequence<int, call_of<Graph, Call>.function->input_count>;

// The input at a position: for all twins of a call, the first input that reads in the same way.
template <class Graph, int Call, int Position>
inline constexpr int input_at = layout_of<Graph>.input_twin[call_of<Graph, Call>.first_input + Position];
template <class Graph, int Call, int Position>
inline constexpr int output_at = layout_of<Graph>.output_twin[call_of<Graph, Call>.first_output + Position];

template <class Graph, int Array>
inline constexpr const sample_array& array_of = layout_of<Graph>.arrays[Array];

template <class Graph, int Input>
inline constexpr bool is_wired = input_of<Graph, Input>.writer >= 0;

}  // namespace cca::detail
