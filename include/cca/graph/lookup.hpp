// Entries of the plan as constants, by number.
#pragma once

#include <cca/graph/types.hpp>

namespace cca::detail {

template <class Graph, int Input>
inline constexpr const input& input_of = plan_of<Graph>.inputs[Input];
template <class Graph, int Output>
inline constexpr const output& output_of = plan_of<Graph>.outputs[Output];
template <class Graph, int Call>
inline constexpr const call& call_of = plan_of<Graph>.calls[Call];

template <class Graph, int Output>
inline constexpr const port_info& output_port_of =
    call_of<Graph, output_of<Graph, Output>.call>.function->outputs[output_of<Graph, Output>.port];
template <class Graph, int Input>
inline constexpr const port_info& input_port_of =
    call_of<Graph, input_of<Graph, Input>.call>.function->inputs[input_of<Graph, Input>.port];

template <class Graph, int Output>
inline constexpr int size_of_output = output_port_of<Graph, Output>.space->size;
template <class Graph, int Input>
inline constexpr int size_of_input = input_port_of<Graph, Input>.space->size;

template <class Graph, int Output>
inline constexpr clock published_of =
    published(output_port_of<Graph, Output>, call_of<Graph, output_of<Graph, Output>.call>);

// The inputs and outputs of a function by their position in it, and for each the first one that is alike.
template <class Graph, int Call>
using input_positions = std::make_integer_sequence<int, call_of<Graph, Call>.function->input_count>;
template <class Graph, int Call>
using output_positions = std::make_integer_sequence<int, call_of<Graph, Call>.function->output_count>;

template <class Graph, int First, int... I>
auto alike_inputs(std::integer_sequence<int, I...>)
    -> std::integer_sequence<int, layout_of<Graph>.like_input[First + I]...>;
template <class Graph, int Call>
using inputs_like =
    decltype(alike_inputs<Graph, call_of<Graph, Call>.first_input>(input_positions<Graph, Call>{}));

template <class Graph, int First, int... O>
auto alike_outputs(std::integer_sequence<int, O...>)
    -> std::integer_sequence<int, layout_of<Graph>.like_output[First + O]...>;
template <class Graph, int Call>
using outputs_like =
    decltype(alike_outputs<Graph, call_of<Graph, Call>.first_output>(output_positions<Graph, Call>{}));

template <class Graph, int Call, int Position>
inline constexpr int input_like = layout_of<Graph>.like_input[call_of<Graph, Call>.first_input + Position];

// Where things lie.
template <class Graph, int Group>
inline constexpr const storage_group& group_of = layout_of<Graph>.groups[Group];

template <class Graph, int Input>
inline constexpr bool is_wired = input_of<Graph, Input>.writer >= 0;

}  // namespace cca::detail
