// Entries of the plan as constants, by number.
#pragma once

#include <cca/graph/types.hpp>

namespace cca::detail {

template <class Graph, int Input>
inline constexpr const input& input_of = plan_of<Graph>.inputs[Input];
template <class Graph, int Output>
inline constexpr const output& output_of = plan_of<Graph>.outputs[Output];
template <class Graph, int Turn>
inline constexpr const turn& turn_of = plan_of<Graph>.turns[Turn];

template <class Graph, int Output>
inline constexpr const port_info& output_port_of = turn_of<Graph, output_of<Graph, Output>.turn>.half->outputs[output_of<Graph, Output>.port];
template <class Graph, int Input>
inline constexpr const port_info& input_port_of = turn_of<Graph, input_of<Graph, Input>.turn>.half->inputs[input_of<Graph, Input>.port];

template <class Graph, int Output>
inline constexpr int size_of_output = output_port_of<Graph, Output>.space->size;
template <class Graph, int Input>
inline constexpr int size_of_input = input_port_of<Graph, Input>.space->size;

template <class Graph, int Output>
inline constexpr clock published_of = published(output_port_of<Graph, Output>, turn_of<Graph, output_of<Graph, Output>.turn>);

// The inputs and outputs of a function by their position in it, and for each the first one that is alike.
template <class Graph, int Turn>
using input_positions = std::make_integer_sequence<int, turn_of<Graph, Turn>.half->input_count>;
template <class Graph, int Turn>
using output_positions = std::make_integer_sequence<int, turn_of<Graph, Turn>.half->output_count>;

template <class Graph, int First, int... I>
auto alike_inputs(std::integer_sequence<int, I...>) -> std::integer_sequence<int, layout_of<Graph>.like_input[First + I]...>;
template <class Graph, int Turn>
using inputs_like = decltype(alike_inputs<Graph, turn_of<Graph, Turn>.first_input>(input_positions<Graph, Turn>{}));

template <class Graph, int First, int... O>
auto alike_outputs(std::integer_sequence<int, O...>) -> std::integer_sequence<int, layout_of<Graph>.like_output[First + O]...>;
template <class Graph, int Turn>
using outputs_like = decltype(alike_outputs<Graph, turn_of<Graph, Turn>.first_output>(output_positions<Graph, Turn>{}));

template <class Graph, int Turn, int Position>
inline constexpr int input_like = layout_of<Graph>.like_input[turn_of<Graph, Turn>.first_input + Position];

// Where things lie.
template <class Graph, int Group>
inline constexpr const storage_group& group_of = layout_of<Graph>.groups[Group];

template <class Graph, int Input>
inline constexpr bool is_wired = input_of<Graph, Input>.writer >= 0;

}  // namespace cca::detail
