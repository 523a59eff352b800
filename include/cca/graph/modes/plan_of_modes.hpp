// The plan of a set of modes, and of each mode in it. The part of a mode is the plan of its graph; only where
// its samples are stored is settled for all modes together.
#pragma once

#include <cca/graph/layout/types.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/graph/modes/clocks_after_switch.hpp>
#include <cca/graph/modes/share.hpp>
#include <cca/graph/planning/plan.hpp>
#include <cca/graph/marks/traceable.hpp>

namespace cca::detail {

// A plan to look at; nothing is written through it.
template <class Plan>
constexpr flat_view show(const Plan& plan) {
  flat_view v = plan.counts;
  v.scopes = const_cast<scope*>(plan.scopes.data());
  v.nodes = const_cast<component_node*>(plan.nodes.data());
  v.calls = const_cast<call*>(plan.calls.data());
  v.inputs = const_cast<input*>(plan.inputs.data());
  v.outputs = const_cast<output*>(plan.outputs.data());
  v.links = const_cast<link*>(plan.links.data());
  v.order = const_cast<int*>(plan.order.data());
  v.parts = const_cast<stoppable_part*>(plan.parts.data());
  v.requests = const_cast<part_request*>(plan.requests.data());
  return v;
}
template <class Graph>
inline constexpr flat_view shown_plan = show(plan_of<Graph>);

template <class Item>
struct item_of_modes {
  using graph = void;
  static constexpr std::string_view name{};
};
template <fixed_string Name, class G>
struct item_of_modes<mode<Name, G>> {
  using graph = G;
  static constexpr std::string_view name = Name.view();
};

// The graph of mode I of a set. A deployment has others (graph/deployment/deployed_modes.hpp).
template <class M, int I, class Item>
struct graph_of_mode {
  using type = typename item_of_modes<Item>::graph;
};

// The same set as another one, whose mistakes have been looked for.
template <class M>
inline constexpr bool is_checked_set = false;
template <class M>
struct name_of_set {
  using type = M;
};

template <class M, int I, class Item>
constexpr mode_info describe_mode() {
  using graph = typename graph_of_mode<M, I, Item>::type;
  mode_info info{.name = item_of_modes<Item>::name, .is_mode = !std::is_void_v<graph>};
  if constexpr (Graph<graph>) {
    info.type = graph_facts<graph>::value.name;
    info.plan = &shown_plan<graph>;
    info.is_deployment = !is_checked_set<M> && requires { typename graph::cca_environments; };
  } else {
    info.is_set = Modes<graph>;
    info.type = type_name<std::conditional_t<Modes<graph>, graph, Item>>();
  }
  return info;
}

// A set of modes that is no named struct has all of them in its name.
constexpr std::string_view modes_name(std::string_view name) {
  return name.starts_with("modes<") ? "the set of modes" : name;
}

template <class... Items>
std::make_integer_sequence<int, sizeof...(Items)> numbers_of_items(list<Items...>);
template <class Items>
struct modes_as_tuple;
template <class... Items>
struct modes_as_tuple<list<Items...>> {
  using type = std::tuple<Items...>;
};

template <class M,
          class Items = typename M::cca_modes,
          class Numbers = decltype(numbers_of_items(typename M::cca_modes{}))>
struct modes_of;
template <class M, class... Items, int... Number>
struct modes_of<M, list<Items...>, std::integer_sequence<int, Number...>> {
  static constexpr int count = sizeof...(Items);
  static constexpr std::array<mode_info, sizeof...(Items) + 1> all{describe_mode<M, Number, Items>()...,
                                                                   mode_info{}};
  static constexpr modes_info value{modes_name(type_name<typename name_of_set<M>::type>()), all.data(), count,
                                    is_checked_set<M>};

  static constexpr graph_sizes sizes = [] {
    graph_sizes sum;
    const auto add = [&]<class G>(box<G>) {
      if constexpr (Graph<G>) {
        const auto& one = graph_size<G>;
        sum.nodes += one.nodes, sum.scopes += one.scopes, sum.calls += one.calls;
        sum.inputs += one.inputs, sum.outputs += one.outputs;
        sum.parts += one.parts, sum.part_requests += one.part_requests;
        sum.merged += one.merged, sum.exposes += one.exposes, sum.twins += one.twins;
      }
    };
    (add(box<typename graph_of_mode<M, Number, Items>::type>{}), ...);
    return sum;
  }();

  // Of all observers, for their queues, and for what is taken from those that they observe.
  static constexpr heard_count heard = [] {
    heard_count sum;
    const auto add = [&]<class G>(box<G>) {
      if constexpr (Graph<G>) sum += heard_count_of<G>;
    };
    (add(box<typename graph_of_mode<M, Number, Items>::type>{}), ...);
    return sum;
  }();

  // The graph of mode I.
  template <int I>
  using graph =
      typename graph_of_mode<M, I, std::tuple_element_t<std::size_t{I}, std::tuple<Items...>>>::type;
};

template <class M>
inline constexpr int mode_count = modes_of<M>::count;

// The plan of mode I, whose clocks hold after a switch. In a deployment each mode begins with it.
template <class M, int I, class Graph = typename modes_of<M>::template graph<I>>
inline constexpr flat_of<Graph> settled_plan =
    then<Graph>(plan_of<Graph>, [](flat_view g) { return settle_clocks(g, I, modes_of<M>::value); });
template <class M, int I>
constexpr const auto& plan_in_set() {
  if constexpr (is_checked_set<M>) return plan_of<typename modes_of<M>::template graph<I>>;
  else return settled_plan<M, I>;
}
template <class M, int I>
inline constexpr flat_view shown_in_set = show(plan_in_set<M, I>());

template <class M, class Numbers = std::make_integer_sequence<int, mode_count<M>>>
struct settled_modes;
template <class M, int... I>
struct settled_modes<M, std::integer_sequence<int, I...>> {
  static constexpr auto all = [] {
    auto modes = modes_of<M>::all;
    const auto settle = [&]<int Mode>(std::integral_constant<int, Mode>) {
      if constexpr (Graph<typename modes_of<M>::template graph<Mode>>)
        modes[std::size_t{Mode}].plan = &shown_in_set<M, Mode>;
    };
    (settle(std::integral_constant<int, I>{}), ...);
    return modes;
  }();
  static constexpr modes_info value{modes_of<M>::value.name, all.data(), mode_count<M>, is_checked_set<M>};
};

template <Modes M>
struct graph_facts<M> {
  static constexpr graph_info value{modes_of<M>::value.name, nullptr, 0, modes_of<M>::sizes, nullptr};
};
template <Modes M>
inline constexpr graph_sizes graph_size<M> = modes_of<M>::sizes;

template <Modes M>
inline constexpr heard_count heard_count_of<M> = modes_of<M>::heard;

template <class M>
struct shared_plan {
  flat_of<M> graph{};
  std::array<table_entry, table_size(graph_size<M>.nodes)> names{};

  constexpr mode_view view_of(const flat_view& mode, const flat_view& whole) const {
    return {mode, whole, names.data(), names.size() - 1};
  }
};
template <class M>
consteval shared_plan<M> share() {
  shared_plan<M> result;
  const name_table names{result.names.data(), result.names.size() - 1};
  result.graph.keep(share(result.graph.view(), names, settled_modes<M>::value));
  return result;
}
template <class M>
inline constexpr shared_plan<M> shared_plan_of = share<M>();

template <Modes M>
inline constexpr flat_of<M> plan_of<M> = shared_plan_of<M>.graph;

// ---- one mode ----

// Mode I of a set, as a graph.
template <class M, int I>
struct mode_part : marks_of<M> {
  using graph = typename modes_of<M>::template graph<I>;
  using cca_items = typename graph::cca_items;
};

// The key of a mode's beat. In the environment of a deployment it is another one
// (graph/deployment/deployed_modes.hpp).
template <class M, int I>
struct key_of_mode {
  using type = mode_part<M, I>;
};
template <class M, int I>
using mode_key = typename key_of_mode<M, I>::type;

// Of such a key: the set, and the number of the mode.
template <class Key>
struct mode_of_key {};
template <class M, int I>
struct mode_of_key<mode_part<M, I>> {
  using set = M;
  static constexpr int number = I;
};
template <class Key> concept ModeKey = requires { mode_of_key<Key>::number; };
template <class Key>
using set_of_key = typename mode_of_key<Key>::set;
template <class Key>
inline constexpr int mode_number_of = mode_of_key<Key>::number;

// The number of its first node after those of the modes before.
template <class M, int I>
inline constexpr int first_node_of_mode = [] {
  int before = 0;
  [&]<int... Before>(std::integer_sequence<int, Before...>) {
    ((before += graph_size<typename modes_of<M>::template graph<Before>>.nodes), ...);
  }(std::make_integer_sequence<int, I>{});
  return before;
}();

template <class M, int I, int Node>
struct node_types<mode_part<M, I>, Node> : node_types<typename mode_part<M, I>::graph, Node> {};

// Stores what another mode reads later, too.
constexpr flat_view store_for_all(flat_view g, const mode_view& view) {
  // From here on parts have the numbers that all modes share.
  for (int r = 0; r < g.request_count; ++r)
    g.requests[r].part = sharing::find_part(view.g, g.requests[r].part, view.whole);
  for (int n = 0; n < g.node_count; ++n)
    g.nodes[n].part = sharing::find_part(view.g, g.nodes[n].part, view.whole);
  for (int c = 0; c < g.call_count; ++c) {
    const auto& shared = view.whole.calls[view.shared_call(c)];
    g.calls[c].unsteady = g.calls[c].own_clock.known() && shared.own_clock.dynamic();
    g.calls[c].other_clocks = shared.other_clocks;
    g.calls[c].may_miss = shared.may_miss && g.calls[c].own_clock.known() && !g.calls[c].own_clock.never();
  }
  for (int i = 0; i < g.input_count; ++i)
    if (auto& in = g.inputs[i]; in.queue >= 0 && in.way_of < 0) {
      const auto& shared = view.whole.inputs[sharing::find_queue(view, i, view.whole)];
      in.counts_vary = shared.counts_vary;
      in.counts_arrivals = shared.counts_arrivals;
    }
  for (int o = 0; o < g.output_count; ++o) {
    auto& out = g.outputs[o];
    const auto& shared = view.whole.outputs[view.shared_output(o)];
    out.leaves = shared.leaves;
    out.in_a_beat = shared.in_a_beat;
    out.by_clock = g.calls[out.call].fires == view.whole.calls[shared.call].fires;
    if (shared.storage == storage_kind::none) continue;
    out.storage = shared.storage;
    out.depth = shared.depth;
    out.initial_of = shared.initial_of;
    for (int i = out.first_reader; i >= 0; i = g.inputs[i].next_of_writer) {
      auto& in = g.inputs[i];
      in.own_initial = (out.storage == storage_kind::newest || out.storage == storage_kind::past) &&
                       may_show_initial(in) &&
                       !same_initial(out.initial_of, in.initial, port_of(g, out).space->size);
    }
  }
  return g;
}

template <class M, int I>
inline constexpr graph_sizes graph_size<mode_part<M, I>> = graph_size<typename mode_part<M, I>::graph>;
template <class M, int I>
inline constexpr heard_count heard_count_of<mode_part<M, I>> =
    heard_count_of<typename mode_part<M, I>::graph>;
template <class M, int I>
inline constexpr int calls_in_part<mode_part<M, I>> = calls_in_part<typename mode_part<M, I>::graph>;

template <class M, int I>
inline constexpr flat_of<mode_part<M, I>> plan_of<mode_part<M, I>> =
    then<mode_part<M, I>>(plan_in_set<M, I>(), [](flat_view g) {
      return store_for_all(g, shared_plan_of<M>.view_of(shown_in_set<M, I>, shown_plan<M>));
    });

// The shared numbers of a mode's nodes.
template <class M, int I>
inline constexpr auto shared_nodes = [] {
  const auto& g = shown_plan<typename modes_of<M>::template graph<I>>;
  const auto view = shared_plan_of<M>.view_of(g, shown_plan<M>);
  std::array<int, array_size(graph_size<typename modes_of<M>::template graph<I>>.nodes + 1)> numbers{};
  for (int n = 0; n < g.node_count; ++n) numbers[array_size(n)] = view.shared_node(n);
  return numbers;
}();

// A shared node is that of the first mode which has it.
template <class M, int Node>
inline constexpr int first_mode_of = first_of(plan_of<M>.nodes[array_size(Node)].members);
template <class M, int Node>
inline constexpr int number_in_first_mode = [] {
  int n = 0;
  while (shared_nodes<M, first_mode_of<M, Node>>[array_size(n)] != Node) ++n;
  return n;
}();
template <Modes M, int Node>
struct node_types<M, Node> : node_types<typename modes_of<M>::template graph<first_mode_of<M, Node>>,
                                        number_in_first_mode<M, Node>> {};

}  // namespace cca::detail
