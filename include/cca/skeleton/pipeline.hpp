// A pipeline: stages one after another, each fired by the output of the one before (the source document,
// section 4.4.3: port-triggered).
//
//   cca::node<"ball", cca::pipeline<undistort, find_ball, smooth>>
//   with policies on the wires between stages:
//   cca::node<"ball", cca::pipeline<undistort, find_ball, cca::inner_wires<cca::queue<4, cca::drop_oldest>>>>
//   in  "input"    the first stage's space
//   out "output"   the last stage's space
//
// A stage is a component with one input that must be wired and one output (status outputs do not count),
// whatever their names, or a pipeline or a farm. A sample passes all stages in one beat, unless the policy
// says otherwise: with `delayed<1>` each stage works on another sample in each beat. The stages are the nodes
// `stage0`, `stage1`, ... of a graph. Errors: skeleton.arity, deployment.undelayed, and those of wires
// between stages (space.mismatch). Cost: that of the stages. Example:
// tests/runtime/skeleton/pipeline_farm.cpp; docs/skeletons.md.
#pragma once

#include <type_traits>
#include <utility>

#include <cca/skeleton/arity.hpp>
#include <cca/graph/items/inner_wires.hpp>
#include <cca/skeleton/stage_ports.hpp>

namespace cca {
namespace detail {

template <std::size_t I>
inline constexpr auto stage_name = numbered<"stage", I>;

template <class Stages, std::size_t I>
using stage_at = std::tuple_element_t<I, Stages>;

template <class Stages, std::size_t I, class Policies>
using wire_to_next =
    wire_inside<joined_name<stage_name<I>, output_of_stage<stage_at<Stages, I>>::name>,
                joined_name<stage_name<I + 1>, input_of_stage<stage_at<Stages, I + 1>>::name>,
                Policies>;

template <class Stages, class Nodes, class Wires, class Policies>
struct pipeline_of;
template <class Stages, std::size_t... N, std::size_t... W, class Policies>
struct pipeline_of<Stages, std::index_sequence<N...>, std::index_sequence<W...>, Policies>
    : graph<
          node<stage_name<N>, stage_at<Stages, N>, typename fires_with_input<stage_at<Stages, N>>::type>...,
          wire_to_next<Stages, W, Policies>...,
          expose<joined_name<stage_name<0>, input_of_stage<stage_at<Stages, 0>>::name>, "input">,
          expose<joined_name<stage_name<sizeof...(W)>, output_of_stage<stage_at<Stages, sizeof...(W)>>::name>,
                 "output">> {
  using stage_input = stage_port<"input", typename input_of_stage<stage_at<Stages, 0>>::space>;
  using stage_output = stage_port<"output", typename output_of_stage<stage_at<Stages, sizeof...(W)>>::space>;
  static constexpr auto inner_wires_of = wires_of::this_one;
};

template <class... Stages>
struct wrong_stages {
  static constexpr text message() {
    text t;
    if (sizeof...(Stages) < 2) {
      t << "has " << int(sizeof...(Stages)) << (sizeof...(Stages) == 1 ? " stage" : " stages")
        << ", but a pipeline has two or more: name more, or use the one stage as a node itself";
    } else {
      bool found = false;
      int i = 0;
      ((OneInOneOut<Stages> || found
            ? void()
            : (found = true, t << "is a pipeline whose stage " << i << " ", put_stage_ports<Stages>(t)),
        ++i),
       ...);
    }
    return t;
  }
};

template <class Policies, class... Stages>
constexpr auto pipeline_of_stages(list<Stages...>) {
  if constexpr (sizeof...(Stages) < 2 || !(OneInOneOut<Stages> && ...))
    return std::type_identity<bad_skeleton<wrong_stages<Stages...>>>();
  else
    return std::type_identity<pipeline_of<std::tuple<Stages...>, std::make_index_sequence<sizeof...(Stages)>,
                                          std::make_index_sequence<sizeof...(Stages) - 1>, Policies>>();
}

// The stages among the arguments, without the option.
template <class Stages, class... Arguments>
struct stages_among {
  using type = Stages;
};
template <class... Stages, class First, class... Rest>
struct stages_among<list<Stages...>, First, Rest...>
    : stages_among<std::conditional_t<is_inner_wires<First>, list<Stages...>, list<Stages..., First>>,
                   Rest...> {};

template <class... Arguments>
constexpr auto pipeline_kind() {
  return pipeline_of_stages<typename inner_policies<list<>, Arguments...>::type>(
      typename stages_among<list<>, Arguments...>::type());
}

}  // namespace detail

// Stages, and `inner_wires<...>`.
template <class... Arguments>
struct pipeline : decltype(detail::pipeline_kind<Arguments...>())::type {};

// The older spelling for one policy.
template <class Policy, class... Stages>
struct pipeline_over : pipeline<Stages..., inner_wires<Policy>> {};

}  // namespace cca
