// A pipeline: stages one after another, each fired by what the one before gives (seed, section 4.4.3:
// port-triggered).
//
//   cca::node<"ball", cca::pipeline<undistort, find_ball, smooth>>                              in "input",
//   out "output" cca::node<"ball", cca::pipeline_over<cca::queue<4, cca::drop_oldest>, undistort, find_ball>>
//   with a policy between stages
//
// A stage is a component with one input that must be wired and one output besides those of status, whatever
// they are called; or a pipeline or a farm. A sample passes all stages in one beat, or, with a policy between
// them, as that says: over `delayed<1>` each stage works on another sample in each beat. The stages are the
// nodes `stage0`, `stage1`, ... of a graph. Errors: skeleton.arity, and those of wires between stages
// (space.mismatch). Cost: that of the stages. Example: tests/runtime/skeleton/pipeline_farm.cpp;
// docs/skeletons.md.
#pragma once

#include <type_traits>
#include <utility>

#include <cca/skeleton/arity.hpp>
#include <cca/skeleton/through.hpp>

namespace cca {
namespace detail {

template <std::size_t I>
inline constexpr auto stage_name = numbered<"stage", I>;

template <class Stages, std::size_t I>
using stage_at = std::tuple_element_t<I, Stages>;

template <class Stages, std::size_t I, class... Policy>
using wire_to_next = wire<joined_name<stage_name<I>, output_of_stage<stage_at<Stages, I>>::name>,
                          joined_name<stage_name<I + 1>, input_of_stage<stage_at<Stages, I + 1>>::name>,
                          Policy...>;

template <class Stages, class Nodes, class Wires, class... Policy>
struct pipeline_of;
template <class Stages, std::size_t... N, std::size_t... W, class... Policy>
struct pipeline_of<Stages, std::index_sequence<N...>, std::index_sequence<W...>, Policy...>
    : graph<
          node<stage_name<N>, stage_at<Stages, N>, typename fires_with_input<stage_at<Stages, N>>::type>...,
          wire_to_next<Stages, W, Policy...>...,
          expose<joined_name<stage_name<0>, input_of_stage<stage_at<Stages, 0>>::name>, "input">,
          expose<joined_name<stage_name<sizeof...(W)>, output_of_stage<stage_at<Stages, sizeof...(W)>>::name>,
                 "output">> {
  using passage_in = passage<"input", typename input_of_stage<stage_at<Stages, 0>>::space>;
  using passage_out = passage<"output", typename output_of_stage<stage_at<Stages, sizeof...(W)>>::space>;
};

template <class... Stages>
struct uneven_stages {
  static constexpr text told() {
    text t;
    if (sizeof...(Stages) < 2) {
      t << "has " << int(sizeof...(Stages)) << (sizeof...(Stages) == 1 ? " stage" : " stages")
        << ", but a pipeline is two or more, one after another: name more, or make a node of it as it is";
    } else {
      bool told = false;
      int i = 0;
      ((GoesThrough<Stages> || told
            ? void()
            : (told = true, t << "is a pipeline whose stage " << i << " ", say_passages<Stages>(t)),
        ++i),
       ...);
    }
    return t;
  }
};

template <class Policies, class... Stages>
constexpr auto pipeline_kind() {
  if constexpr (sizeof...(Stages) < 2 || !(GoesThrough<Stages> && ...))
    return std::type_identity<uneven<uneven_stages<Stages...>>>();
  else
    return []<class... Policy>(list<Policy...>) {
      return std::type_identity<
          pipeline_of<std::tuple<Stages...>, std::make_index_sequence<sizeof...(Stages)>,
                      std::make_index_sequence<sizeof...(Stages) - 1>, Policy...>>();
    }(Policies());
}

}  // namespace detail

template <class... Stages>
struct pipeline : decltype(detail::pipeline_kind<detail::list<>, Stages...>())::type {};

template <class Policy, class... Stages>
struct pipeline_over : decltype(detail::pipeline_kind<detail::list<Policy>, Stages...>())::type {};

}  // namespace cca
