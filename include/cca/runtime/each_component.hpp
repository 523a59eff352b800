// All components of a controller, one after the other, and their paths; and those of outputs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <cca/base/refused.hpp>
#include <cca/graph/diagnosis/nearest_node.hpp>
#include <cca/graph/layout/lookup.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

// "skills.gait": the path of a component, from the outermost graph.
template <class Graph>
std::string path_of_node(int node) {
  const auto& plan = plan_of<Graph>;
  std::string path(plan.nodes[static_cast<std::size_t>(node)].item->from);
  for (int s = plan.nodes[static_cast<std::size_t>(node)].scope;
       plan.scopes[static_cast<std::size_t>(s)].item; s = plan.scopes[static_cast<std::size_t>(s)].parent)
    path = std::string(plan.scopes[static_cast<std::size_t>(s)].item->from) + "." + path;
  return path;
}

// f(number) for the component at a path, or for those of an inner graph. Refused: there is none.
template <class Graph>
bool is_node_at(int node, std::string_view path) {
  const std::string own = path_of_node<Graph>(node);
  return own == path || (own.starts_with(path) && own[path.size()] == '.');
}
template <class Graph, class F>
void for_each_node_at(std::string_view path, const char* call, F f) {
  bool found = false;
  for (int node = 0; node < counts_of<Graph>.node_count; ++node)
    if (is_node_at<Graph>(node, path)) {
      found = true;
      f(node);
    }
  if (found) return;
  std::string said = "cca::controller: ";  // append: docs/compilers.md
  said.append(call).append(": there is no node `").append(path).append("`");
  if (const text near = nearest_node(plan_of<Graph>.view(), path); near.size > 0)
    said.append("; did you mean `").append(near.view()).append("`?");
  throw refused(said);
}

template <class Graph>
int node_of_output(int output) {
  return plan_of<Graph>.calls[array_size(plan_of<Graph>.outputs[array_size(output)].call)].node;
}

// "dmp.ode.phase"
template <class Graph>
std::string path_of_output(int output) {
  const auto& o = plan_of<Graph>.outputs[array_size(output)];
  const auto& call = plan_of<Graph>.calls[array_size(o.call)];
  return path_of_node<Graph>(call.node) + "." + std::string(port_of(call, o).name);
}

template <class Graph>
const space_info& space_of_output(int output) {
  const auto& o = plan_of<Graph>.outputs[array_size(output)];
  return *port_of(plan_of<Graph>.calls[array_size(o.call)], o).space;
}

template <class Graph, class F, class State, int First>
void visit_component(F& f, State& state, int node) {
  if constexpr (First >= 0)
    f(node, component_in<Graph, First>(state, layout_of<Graph>.components[node].index));
}

// f(number, component) for each, in declaration order. Through a table, so that the code of `f` for
// components of one type is compiled once.
template <class Graph, class F, class State>
void visit_components(F f, State& state) {
  [&]<int... Node>(std::integer_sequence<int, Node...>) {
    static constexpr void (*visitors[])(F&, State&, int) = {
        visit_component<Graph, F, State, layout_of<Graph>.components[Node].array>..., nullptr};
    for (int node = 0; node < static_cast<int>(sizeof...(Node)); ++node) visitors[node](f, state, node);
  }(std::make_integer_sequence<int, counts_of<Graph>.node_count>{});
}

// Calls f(name) for each input of a component that an output writes. A set of modes has its own
// (runtime/modes/mode_controller.hpp).
template <class Graph>
struct wired_inputs {
  template <class F>
  static void each(int node, F f) {
    const auto& plan = plan_of<Graph>;
    const auto& of = plan.nodes[array_size(node)];
    for (int c = of.first_call; c < of.first_call + of.call_count; ++c) {
      const auto& one = plan.calls[array_size(c)];
      for (int p = 0; p < one.function->input_count; ++p)
        if (plan.inputs[array_size(one.first_input + p)].writer >= 0) f(one.function->inputs[p].name);
    }
  }
};

// f(what is kept of the last firing) for each call of a component whose clock is known only at run time.
template <class Graph, class State, class F>
void visit_firings([[maybe_unused]] State& state, [[maybe_unused]] int node, [[maybe_unused]] F f) {
  if constexpr (layout_of<Graph>.firing_count > 0)
    for (const call_place& one : layout_of<Graph>.calls)
      if (one.node == node && one.firing >= 0) f(state.firings[one.firing]);
}

// Strategies of a component that have a state begin anew.
template <class Graph, class State>
void forget_strategies([[maybe_unused]] State& state, [[maybe_unused]] int node) {
  [&]<int... Call>(std::integer_sequence<int, Call...>) {
    const int all[] = {
        0, (call_of<Graph, Call>.node == node ? (strategy_in<Graph, Call>(state) = {}, 0) : 0)...};
    (void)all;
  }(chosen<counts_of<Graph>.call_count, keeps_strategy<Graph>>{});
}

// Whether a component is so.
template <class Graph, class Question>
inline constexpr bool any_component = []<int... First>(std::integer_sequence<int, First...>) {
  return is_any<Question::template holds<typename node_types<Graph, First>::component>...>;
}(chosen<counts_of<Graph>.node_count, is_first_of_type<Graph>>{});

// Hooks of resource nodes, as visitors.
struct call_on_idle {
  template <class C>
  static constexpr bool holds = IsResource<C> && OnIdle<C>;
  template <class C>
  void operator()(int, C& component) const {
    if constexpr (holds<C>) component.on_idle();
  }
};
struct call_on_fault {
  template <class C>
  static constexpr bool holds = IsResource<C> && OnFault<C>;
  template <class C>
  void operator()(int, C& component) const {
    if constexpr (holds<C>) component.on_fault();
  }
};

}  // namespace cca::detail
