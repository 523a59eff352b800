// The items of a graph as values: what the constexpr functions of this folder work on instead of type lists.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <cca/graph/items/graph.hpp>

namespace cca::detail {

enum class item_kind : std::uint8_t { node, graph, wire, expose, rate, require, observe, unknown };
// A queue, or what is merged into one, may be delayed too.
enum class policy_kind : std::uint8_t { unstated, latest, delayed, queue, merged };
enum class full_kind : std::uint8_t { drop_oldest, drop_newest, reject, unknown };

struct graph_info;
struct flat_view;
struct finding;

struct item_info {
  item_kind kind = item_kind::unknown;
  std::string_view from{}, to{};               // a node: its name; expose: inner and outer name
  ref<component_info> component = nullptr;     // node
  ref<graph_info> inner = nullptr;             // graph
  ref<strategy_info> strategy = nullptr;       // node, graph; none: the default
  policy_kind policy = policy_kind::unstated;  // wire
  full_kind full = full_kind::drop_oldest;
  int delay = 0, capacity = 0;                    // wire
  int number = 0;                                 // the bound in beats of a require
  policy_kind too_small = policy_kind::unstated;  // wire: this policy has a number below 1
  ref<double> initial = nullptr;
  int initial_count = 0;
  double hz = 0;                             // rate
  std::string_view unknown_type{};           // a type that is no item, option of a wire, or strategy
  std::string_view instead{};                // of a type that is no strategy: what it is
  bool repeats_option = false;               // wire: policies that exclude each other, or two initial values
  std::uint64_t from_hash = 0, to_hash = 0;  // as paths of the outermost graph
  std::uint64_t strategy_key = 0;            // type_key of a node's strategy

  // A component, or an inner graph as a whole, that may be stopped on its own.
  constexpr bool is_stoppable() const { return strategy && strategy->is_stoppable; }
  // When a started component fires; none: by default.
  constexpr ref<strategy_info> strategy_while_started() const {
    auto stated = strategy;
    if (is_stoppable() && strategy->part_count == 1) stated = strategy->parts[0];
    if (stated && stated->is_default) stated = nullptr;
    return stated;
  }
  // A wire whose samples wait in a queue.
  constexpr bool has_queue() const { return policy == policy_kind::queue || policy == policy_kind::merged; }
  // Of an observe: what it shows is not just the newest sample.
  constexpr bool has_policy() const { return delay > 0 || has_queue(); }
};

// How many of each a graph has, inner graphs included.
struct graph_sizes {
  int nodes = 0, scopes = 0, calls = 0, inputs = 0, outputs = 0, exposes = 0, observers = 0, merged = 0;
  int watches = 0;                   // an `observe` of the graph itself, with a policy
  int parts = 0, part_requests = 0;  // that may be stopped; results that stop or start one
  int twins = 0;                     // each `expose` under a name that the same graph has exposed before

  // Ways into the inputs: each wire that is merged with another one is a further one. It leads to as many
  // inputs as are exposed under one name.
  constexpr int ways() const { return inputs + merged * (1 + twins); }
};

struct graph_info {
  std::string_view name;
  const item_info* items = nullptr;
  int count = 0;
  graph_sizes sizes;
  void (*refuse_as_node)(flat_view&, const finding&) = nullptr;  // of a type that is no inner graph
  wires_of inner = wires_of::nobody;
  void (*refuse)(flat_view&, int scope) = nullptr;  // of a type that has refused itself
};

template <class Graph>
struct graph_facts;

template <class Component>
constexpr void describe_node(item_info& item) {
  if constexpr (Graph<Component>) {
    item.kind = item_kind::graph;
    item.inner = &graph_facts<Component>::value;
  } else {
    item.kind = item_kind::node;
    item.component = &component_of<Component>;
  }
}

template <auto... Coordinates>
inline constexpr std::array<double, sizeof...(Coordinates) + 1> initial_values{
    static_cast<double>(Coordinates)..., 0.0};

// What a queue does when it is full.
template <class Full>
struct full_queue {};

// Beside another policy: only a delay and a queue go together, in any order.
constexpr void add_policy(item_info& item, policy_kind added) {
  const bool is_queue = added == policy_kind::queue || added == policy_kind::merged;
  const bool is_delayed = item.delay != 0;
  const bool go_together = added == policy_kind::delayed ? item.has_queue() && !is_delayed
                                                         : is_queue && item.policy == policy_kind::delayed;
  item.repeats_option |= item.policy != policy_kind::unstated && !go_together;
  if (!item.has_queue()) item.policy = added;
}
constexpr void add_policy(item_info& item, policy_kind added, int& number, int stated) {
  add_policy(item, added);
  number = stated;
  if (stated < 1) item.too_small = added;
}

template <class Option>
struct wire_option {
  static constexpr void set(item_info& item) { item.unknown_type = type_name<Option>(); }
};
template <>
struct wire_option<latest> {
  static constexpr void set(item_info& item) { add_policy(item, policy_kind::latest); }
};
template <int Beats>
struct wire_option<delayed<Beats>> {
  static constexpr void set(item_info& item) { add_policy(item, policy_kind::delayed, item.delay, Beats); }
};
template <class Full>
struct wire_option<full_queue<Full>> {
  static constexpr void set(item_info& item) {
    item.full = full_kind::unknown;
    item.unknown_type = type_name<Full>();
  }
};
template <>
struct wire_option<full_queue<drop_oldest>> {
  static constexpr void set(item_info& item) { item.full = full_kind::drop_oldest; }
};
template <>
struct wire_option<full_queue<drop_newest>> {
  static constexpr void set(item_info& item) { item.full = full_kind::drop_newest; }
};
template <>
struct wire_option<full_queue<reject>> {
  static constexpr void set(item_info& item) { item.full = full_kind::reject; }
};
template <int Capacity, class Full>
struct wire_option<queue<Capacity, Full>> {
  static constexpr void set(item_info& item) {
    add_policy(item, policy_kind::queue, item.capacity, Capacity);
    wire_option<full_queue<Full>>::set(item);
  }
};
template <int Capacity, class Full>
struct wire_option<merged<Capacity, Full>> {
  static constexpr void set(item_info& item) {
    add_policy(item, policy_kind::merged, item.capacity, Capacity);
    wire_option<full_queue<Full>>::set(item);
  }
};
template <auto... Coordinates>
struct wire_option<initial<Coordinates...>> {
  static constexpr void set(item_info& item) {
    item.repeats_option |= bool(item.initial);
    item.initial = initial_values<Coordinates...>.data();
    item.initial_count = sizeof...(Coordinates);
  }
};

// No longer needed: each pattern must name something.
template <>
struct wire_option<one_output> : wire_option<latest> {};

template <class... Policies>
constexpr item_info policy_item(std::string_view pattern) {
  item_info item{.kind = item_kind::observe, .from = pattern};
  (wire_option<Policies>::set(item), ...);
  if (item.policy == policy_kind::unstated) item.policy = policy_kind::latest;
  return item;
}
template <class... Policies>
inline constexpr item_info item_of_policy = policy_item<Policies...>({});
template <class... Policies>
constexpr const item_info& observer_policy() {
  return item_of_policy<Policies...>;
}

template <class Item>
inline constexpr item_info item_of{.unknown_type = type_name<Item>()};

// Functions of the types alone: nodes of equal types share one instantiation, and so do wires of equal
// options.
template <class Component, class Strategy>
constexpr item_info node_item(std::string_view name) {
  item_info item{.from = name, .from_hash = hash(name), .strategy_key = type_key<Strategy>};
  describe_node<Component>(item);
  if constexpr (!std::is_same_v<Strategy, by_default>) {
    item.strategy = &strategy_of<Strategy>;
    if constexpr (!ProcessingStrategy<Strategy>) {
      item.unknown_type = type_name<Strategy>();
      item.instead = no_strategy_but<Strategy>;
    }
  }
  return item;
}
template <fixed_string Name, class Component, class Strategy>
inline constexpr item_info item_of<node<Name, Component, Strategy>> =
    node_item<Component, Strategy>(Name.view());

template <class... Options>
constexpr item_info wire_item(std::string_view from, std::string_view to) {
  item_info item{
      .kind = item_kind::wire, .from = from, .to = to, .from_hash = hash(from), .to_hash = hash(to)};
  (wire_option<Options>::set(item), ...);
  return item;
}
template <fixed_string From, fixed_string To, class... Options>
inline constexpr item_info item_of<wire<From, To, Options...>> =
    wire_item<Options...>(From.view(), To.view());

template <fixed_string Inner, fixed_string Outer>
inline constexpr item_info item_of<expose<Inner, Outer>>{
    .kind = item_kind::expose, .from = Inner.view(), .to = Outer.view(), .from_hash = hash(Inner.view())};

template <auto Hz>
inline constexpr item_info item_of<rate<Hz>>{.kind = item_kind::rate, .hz = static_cast<double>(Hz)};

template <fixed_string From, fixed_string To, int Count>
inline constexpr item_info item_of<require<latency<From, To>, beats<Count>>>{
    .kind = item_kind::require, .from = From.view(), .to = To.view(), .number = Count};

template <fixed_string Scope, class... Policies>
inline constexpr item_info item_of<observe<Scope, Policies...>> = policy_item<Policies...>(Scope.view());

constexpr bool is_twin(const item_info* items, int exposed) {
  for (int i = 0; i < exposed; ++i)
    if (items[i].kind == item_kind::expose && items[i].to == items[exposed].to) return true;
  return false;
}

constexpr graph_sizes sizes_of(const item_info* items, int count) {
  graph_sizes sizes;
  sizes.scopes = 1;
  for (int i = 0; i < count; ++i) {
    const auto& item = items[i];
    sizes.parts += item.is_stoppable();
    if (item.kind == item_kind::graph) {
      const auto& inner = item.inner->sizes;
      sizes.nodes += inner.nodes;
      sizes.scopes += inner.scopes;
      sizes.calls += inner.calls;
      sizes.inputs += inner.inputs;
      sizes.outputs += inner.outputs;
      sizes.exposes += inner.exposes;
      sizes.twins += inner.twins;
      sizes.observers += inner.observers;
      sizes.watches += inner.watches;
      sizes.parts += inner.parts;
      sizes.part_requests += inner.part_requests;
      sizes.merged += inner.merged;
    } else if (item.kind == item_kind::node) {
      ++sizes.nodes;
      for (const auto function : {item.component->sense, item.component->process, item.component->act}) {
        if (!function) continue;
        ++sizes.calls;
        sizes.inputs += function->input_count;
        sizes.outputs += function->output_count;
        sizes.part_requests += function->asked_count;
        for (int p = 0; p < function->input_count; ++p) sizes.observers += !function->inputs[p].space;
      }
    } else if (item.kind == item_kind::expose) {
      ++sizes.exposes;
      sizes.twins += is_twin(items, i);
    } else if (item.kind == item_kind::observe) {
      sizes.watches += item.has_policy();
    } else if (item.policy == policy_kind::merged) {
      ++sizes.merged;
    }
  }
  return sizes;
}

template <class Items>
struct items_facts;

template <class... Items>
struct items_facts<list<Items...>> {
  static constexpr int count = sizeof...(Items);
  static constexpr std::array<item_info, sizeof...(Items) + 1> items{item_of<Items>..., item_info{}};
};

// A graph that is no named struct has all its items in its name.
constexpr std::string_view graph_name(std::string_view name) {
  return name.starts_with("graph<") ? "the graph" : name;
}

template <class Graph>
constexpr wires_of inner_wires_in() {
  if constexpr (requires { Graph::inner_wires_of; }) return Graph::inner_wires_of;
  else return wires_of::nobody;
}

// Of a graph that has refused itself: planning/steps/flatten.hpp.
template <class Graph>
struct refused_by_itself;

template <class Graph>
struct graph_facts {
  using facts = items_facts<typename Graph::cca_items>;
  static constexpr graph_info value{graph_name(type_name<Graph>()),
                                    facts::items.data(),
                                    facts::count,
                                    sizes_of(facts::items.data(), facts::count),
                                    nullptr,
                                    inner_wires_in<Graph>(),
                                    refused_by_itself<Graph>::in_graph};
};

}  // namespace cca::detail
