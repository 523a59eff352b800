// A deployment of a set of modes: each mode is a deployment of its own, over the same environments; and each
// environment is a set of modes of its own, whose graphs are its parts of them. So placement, crossings and
// the order of faults are planned for each mode as for a deployment of one graph, and what outlives a switch
// in an environment as for a set of modes in one loop.
//
// Errors: deployment.*, which name the mode.
#pragma once

#include <string_view>
#include <tuple>
#include <utility>

#include <cca/graph/modes/diagnosis_of_modes.hpp>
#include <cca/graph/deployment/part.hpp>
#include <cca/graph/modes/plan_of_modes.hpp>

namespace cca::detail {

template <class D, int I>
using mode_item = std::tuple_element_t<std::size_t{I}, typename modes_as_tuple<typename D::cca_modes>::type>;

// Mode I of deployment D, as a deployment.
template <class D, int I>
struct deployed_mode : marks_of<D> {
  using cca_architecture = typename item_of_modes<mode_item<D, I>>::graph;
  using cca_items = typename cca_architecture::cca_items;
  using cca_environments = typename D::cca_environments;
  using cca_whole = D;
  static constexpr int cca_mode = I;
  static constexpr std::string_view cca_mode_name = item_of_modes<mode_item<D, I>>::name;
};
template <class D> concept DeployedMode = requires { typename D::cca_whole; };

// Calls f.template operator()<deployed_mode<D, I>>() for each mode of a deployment.
template <class D, class F>
constexpr void for_each_deployed_mode(F f) {
  [&]<int... I>(std::integer_sequence<int, I...>) {
    (f.template operator()<deployed_mode<D, I>>(), ...);
  }(std::make_integer_sequence<int, mode_count<D>>{});
}

// What the environments of a deployment share is that of the whole.
template <class D>
struct whole_deployment {
  using type = D;
};
template <class D, int I>
struct whole_deployment<deployed_mode<D, I>> {
  using type = D;
};
template <class D>
using whole_of = typename whole_deployment<D>::type;

template <class D, int I>
inline constexpr heard_count heard_count_of<deployed_mode<D, I>> =
    heard_count_of<typename deployed_mode<D, I>::cca_architecture>;

template <class D, int I>
inline constexpr const modes_info* set_of_mode<deployed_mode<D, I>> =
    &modes_of<typename D::cca_architecture>::value;
template <class D, int I>
inline constexpr flat_of<deployed_mode<D, I>> plan_of<deployed_mode<D, I>> =
    then<deployed_mode<D, I>>(plan_in_set<typename D::cca_architecture, I>(), [](flat_view g) {
      g.scopes[0].graph = &graph_facts<deployed_mode<D, I>>::value;
      return place_components(g, placement_of<deployed_mode<D, I>>);
    });

template <DeploymentOfModes D, int I, class Item>
  requires Graph<typename item_of_modes<Item>::graph>
struct graph_of_mode<D, I, Item> {
  using type = deployed_mode<D, I>;
};
template <DeploymentOfModes D>
inline constexpr bool is_checked_set<D> = true;
template <DeploymentOfModes D>
struct name_of_set<D> {
  using type = typename D::cca_architecture;
};

// All modes together, with their places.
template <DeploymentOfModes D>
inline constexpr deployment_info facts_of_all = [] {
  deployment_info info = environments_of<D>::facts;
  info.name = deployment_name(type_name<D>());
  return info;
}();
template <DeploymentOfModes D>
inline constexpr deployment_placement placement_of_all{environments_of<D>::all.data(), environment_count<D>,
                                                       &facts_of_all<D>, nullptr};
template <DeploymentOfModes D>
struct told_of<D> {
  using rules = deployment_rules::type;
  using writer = deployment_writer;
};
template <DeploymentOfModes D>
inline constexpr flat_of<D> plan_of<D> = then<D>(shared_plan_of<D>.graph, [](flat_view g) {
  g.hung = &placement_of_all<D>;
  g.is_spread = environment_count<D> > 0;
  check_environments(g);
  return g;
});

// The first mistake: of a mode by itself, of the set, of the placement of a mode, of that of all modes.
template <class D, class Numbers = decltype(numbers_of_items(typename D::cca_modes{}))>
struct first_misplaced;
template <class D>
struct first_misplaced<D, std::integer_sequence<int>> {
  using type = D;
};
template <class D, int I, int... More>
struct first_misplaced<D, std::integer_sequence<int, I, More...>>
    : first_misplaced<D, std::integer_sequence<int, More...>> {};
template <class D, int I, int... More>
  requires(counts_of<deployed_mode<D, I>>.found.is_broken())
struct first_misplaced<D, std::integer_sequence<int, I, More...>> {
  using type = deployed_mode<D, I>;
};
template <class D, bool IsSound>
struct diagnosed_deployment : first_misplaced<D> {};
template <class D>
struct diagnosed_deployment<D, false> : diagnosed<typename D::cca_architecture> {};
template <DeploymentOfModes D>
struct diagnosed<D> : diagnosed_deployment<D, broken_by<typename D::cca_architecture>().empty()> {};

// ---- an environment as a set of modes ----

// The part of an environment, before it stores what other modes need. It fires by the clocks of the whole,
// as one loop does after a switch. In a wall-clock run nobody knows when a free-running environment
// publishes: there what depends on it asks its strategy.
template <class D, int E>
struct own_part : marks_of<D> {
  using cca_items = typename D::cca_items;
};
template <class D, int E>
struct graph_facts<own_part<D, E>> : graph_facts<D> {};
template <class D, int E>
inline constexpr graph_sizes graph_size<own_part<D, E>> = graph_size<D>;
template <class D, int E>
inline constexpr heard_count heard_count_of<own_part<D, E>> = heard_count_of<D>;
template <class D, int E, int Node>
struct node_types<own_part<D, E>, Node> : node_types<D, Node> {};

constexpr flat_view keep_clocks(flat_view g) {
  for (int c = 0; c < g.call_count; ++c)
    if (g.calls[c].elsewhere) g.calls[c].fires = g.calls[c].own_clock = dynamic_clock;
  return g;
}
// `D`: a mode. But for those that run freely themselves: in each cycle they fire.
template <class D>
constexpr flat_view keep_fast_clocks(flat_view g) {
  if constexpr (has_free_running<D>)
    for (int c = 0; c < g.call_count; ++c) {
      auto& one = g.calls[c];
      if (is_free_node<D>(one.node) || !one.own_clock.known() ||
          plan_at_wall_clock<D>.calls[array_size(c)].own_clock.known())
        continue;
      one.fast_clock = one.own_clock;
      one.fires = one.own_clock = dynamic_clock;
    }
  return g;
}
template <class D, int E>
inline constexpr flat_of<own_part<D, E>> plan_of<own_part<D, E>> =
    then<own_part<D, E>>(plan_of<D>, [](flat_view g) {
      g.calls_in_part = calls_in_part<D>;
      return choose_storage(keep_fast_clocks<D>(keep_clocks(take_part(g, E))));
    });

template <class D, int E>
struct modes_in : marks_of<D> {
  using cca_modes = typename D::cca_modes;
};
template <class D, int E>
inline constexpr bool is_checked_set<modes_in<D, E>> = true;
template <class D, int E>
struct name_of_set<modes_in<D, E>> {
  using type = typename D::cca_architecture;
};
template <class D, int E, int I, class Item>
struct graph_of_mode<modes_in<D, E>, I, Item> {
  using type = own_part<deployed_mode<D, I>, E>;
};

// A mode of a set by the key of its beat: `mode_part`, or the part of an environment in this mode.
template <class D, int E, int I>
struct key_of_mode<modes_in<D, E>, I> {
  using type = part<deployed_mode<D, I>, E>;
};

template <class D, int I, int E>
struct mode_of_key<part<deployed_mode<D, I>, E>> {
  using set = modes_in<D, E>;
  static constexpr int number = I;
};

template <class D, int I, int E>
inline constexpr flat_of<part<deployed_mode<D, I>, E>> plan_of<part<deployed_mode<D, I>, E>> =
    then<part<deployed_mode<D, I>, E>>(plan_of<own_part<deployed_mode<D, I>, E>>, [](flat_view g) {
      return store_for_all(g, shared_plan_of<modes_in<D, E>>.view_of(
                                  shown_plan<own_part<deployed_mode<D, I>, E>>, shown_plan<modes_in<D, E>>));
    });

// What of a mode is what of the whole.
template <class D, int I>
inline constexpr mode_view view_of_deployed_mode =
    shared_plan_of<D>.view_of(shown_plan<deployed_mode<D, I>>, shown_plan<D>);

// The number by which all environments know an output of a deployment, or of one of its modes.
template <class D, int Output>
inline constexpr int shared_output_of = Output;
template <class D, int I, int Output>
inline constexpr int shared_output_of<deployed_mode<D, I>, Output> =
    view_of_deployed_mode<D, I>.shared_output(Output);

}  // namespace cca::detail
