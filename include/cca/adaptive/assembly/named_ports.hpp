// The ports of a component or graph by name: which ports it has, and the space of each.
#pragma once

#include <cca/adaptive/assembly/item_lists.hpp>
#include <cca/component/mapped_ports.hpp>

namespace cca::detail {

// The name of a port, usable as a template argument, and its space.
template <class Port>
struct port_facts;
template <template <fixed_string, class> class Kind, fixed_string Name, class Of>
struct port_facts<Kind<Name, Of>> {
  static constexpr auto name = Name;
  using space = Of;
};
template <class Type> concept NamedPort = requires { port_facts<Type>::name; };

// All ports of a component; the exposed ports of a graph, whose spaces are not known here.
template <fixed_string Name, class Space>
struct exposed_port {
  static constexpr std::string_view name = Name.view();
};
template <class Item>
struct names_exposed_by {
  using type = list<>;
};
template <fixed_string Inner, fixed_string Outer>
struct names_exposed_by<expose<Inner, Outer>> {
  using type = list<exposed_port<Outer, void>>;
};

template <class Component>
struct ports_in {
  using type = typename joined<typename process_facts<Component>::parameters,
                               typename process_facts<Component>::results>::type;
};
// Keeps the first port of each name: one exposed input may feed several ports, and an input and an output may
// share a name.
template <class Done, class Rest>
struct without_repeats {
  using type = Done;
};
template <class... Done, class First, class... Rest>
struct without_repeats<list<Done...>, list<First, Rest...>>
    : without_repeats<
          std::conditional_t<((Done::name == First::name) || ...), list<Done...>, list<Done..., First>>,
          list<Rest...>> {};
template <class Items>
struct graph_ports;
template <class... Items>
struct graph_ports<list<Items...>>
    : without_repeats<list<>, typename joined<list<>, typename names_exposed_by<Items>::type...>::type> {};
template <Graph Component>
struct ports_in<Component> : graph_ports<typename Component::cca_items> {};

// Whether there is a port of that name, and its space; void for the exposed port of a graph.
template <fixed_string Name, class Ports>
struct port_at {
  static constexpr bool exists = false;
  using space = void;
};
template <fixed_string Name, class First, class... Rest>
struct port_at<Name, list<First, Rest...>> : port_at<Name, list<Rest...>> {};
template <fixed_string Name, NamedPort First, class... Rest>
  requires(First::name == Name.view())
struct port_at<Name, list<First, Rest...>> {
  static constexpr bool exists = true;
  using space = typename port_facts<First>::space;
};

}  // namespace cca::detail
