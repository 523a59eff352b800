// The parameters of all components, outside of their controller: other threads change them there, and the
// loops take them over.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <cca/component/parameters.hpp>
#include <cca/graph/layout/nodes_by_path.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/live/live_components.hpp>

namespace cca::detail {

// A component's parameters, without the component.
template <class Component>
struct only_parameters {
  explicit only_parameters(const Component&) {}
};
template <HasParameters Component>
struct only_parameters<Component> {
  using parameters = typename Component::parameters;
  explicit only_parameters(const Component& component) : p(component.p) {}
  parameters p;
};

template <class Graph, int Node>
struct parameters_of_node : only_parameters<typename node_types<Graph, Node>::component> {
  using only_parameters<typename node_types<Graph, Node>::component>::only_parameters;
};

template <class Controller,
          class Graph,
          class Nodes = std::make_integer_sequence<int, counts_of<Graph>.node_count>>
class known_parameters;
template <class Controller, class Graph, int... Node>
class known_parameters<Controller, Graph, std::integer_sequence<int, Node...>>
    : parameters_of_node<Graph, Node>... {
public:
  explicit known_parameters(const Controller& c)
      : parameters_of_node<Graph, Node>(live_components::at<Node>(c))...,
        here{live_components::is_here(c, Node)...},
        paths{path_of_node<Graph>(Node)...} {}

  // As of a controller: f(path, something with the member `p`).
  template <class F>
  void for_each_component(F f) {
    const int all[] = {0, (f(std::string_view(paths[Node]), of<Node>()), 0)...};
    (void)all;
  }
  template <class F>
  void for_each_component(F f) const {
    const int all[] = {0, (f(std::string_view(paths[Node]), of<Node>()), 0)...};
    (void)all;
  }
  static double step_of(std::string_view path) { return detail::step_of<Graph>(node_at<Graph>(path)); }
  void check_is_here(std::string_view path) const { check_is_here(node_at<Graph>(path)); }
  void check_is_here(int node) const {
    if (!here[array_size(node)]) live_components::refuse<Controller>(node);
  }

  // Gives those of one loop to its components, unless one of them refuses for now: to all or none. Its
  // number, or -1.
  template <int Loop>
  int give_to(Controller& c) noexcept {
    int refusing = -1;
    const int asked[] = {0, (takes<Loop, Node>(c) ? 0 : refusing = Node)...};
    const int given[] = {0, (exchange<Loop, Node>(c, refusing < 0), 0)...};
    (void)asked;
    (void)given;
    return refusing;
  }
  const std::string& path(int node) const { return paths[array_size(node)]; }
  template <int One>
  auto& of() {
    return static_cast<parameters_of_node<Graph, One>&>(*this);
  }

private:
  template <int One>
  const auto& of() const {
    return static_cast<const parameters_of_node<Graph, One>&>(*this);
  }
  template <int Loop, int One>
  static constexpr bool is_in = live_loops<Controller>::of_node(One) == Loop;

  template <int Loop, int One>
  bool takes(const Controller& c) const noexcept {
    if constexpr (is_in<Loop, One> && MayRefuse<typename node_types<Graph, One>::component>)
      return live_components::at<One>(c).refusal_of(of<One>().p).empty();
    else return true;
  }
  // If a component refuses a value, the copy that other threads read is corrected.
  template <int Loop, int One>
  void exchange(Controller& c, bool is_given) noexcept {
    if constexpr (is_in<Loop, One> && HasParameters<typename node_types<Graph, One>::component>) {
      if (is_given) live_components::at<One>(c).p = of<One>().p;
      else of<One>().p = live_components::at<One>(c).p;
    }
  }

  std::array<bool, sizeof...(Node) + 1> here;
  std::array<std::string, sizeof...(Node) + 1> paths;
};

}  // namespace cca::detail
