// The input and the output by which skeletons connect a stage or a worker: the only input that must be wired,
// and the only output that is not a status.
//
// For a component these are ports of `process`; an optional input does not count. Of the graphs only
// pipelines and farms state theirs.
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/component/component.hpp>
#include <cca/graph/items/graph.hpp>
#include <cca/base/text.hpp>
#include <cca/space/domain.hpp>
#include <cca/base/joined_names.hpp>

namespace cca::detail {

// A port and the name to wire it by.
template <fixed_string Name, class Space>
struct stage_port {
  static constexpr auto name = Name;
  using space = Space;
};

template <class Port>
struct stage_port_of {
  using type = void;
};
template <fixed_string Name, class Space>
struct stage_port_of<in<Name, Space>> {
  using type = stage_port<Name, Space>;
};
template <fixed_string Name, class Space>
struct stage_port_of<out<Name, Space>> {
  using type =
      std::conditional_t<std::is_same_v<typename Space::domain, status>, void, stage_port<Name, Space>>;
};
template <fixed_string Name, class Space>
struct stage_port_of<maybe<Name, Space>> : stage_port_of<out<Name, Space>> {};

// The stage ports in a list; the other entries are void.
template <class... Ports>
struct stage_ports {
  static constexpr int count = (!std::is_void_v<Ports> + ... + 0);
  using first = std::tuple_element_t<
      0,
      decltype(std::tuple_cat(
          std::declval<std::conditional_t<std::is_void_v<Ports>, std::tuple<>, std::tuple<Ports>>>()...,
          std::tuple<void*>()))>;
};
template <class List>
struct stage_ports_in;
template <class... Ports>
struct stage_ports_in<list<Ports...>> : stage_ports<typename stage_port_of<Ports>::type...> {};

template <class Type>
struct stage_interface {
  using inputs = stage_ports<>;
  using outputs = stage_ports<>;
};
template <HasProcess Component>
struct stage_interface<Component> {
  using facts = function_facts<decltype(&Component::process)>;
  using inputs = stage_ports_in<typename facts::parameters>;
  using outputs = stage_ports_in<typename facts::results>;
};
// A pipeline or a farm states its own.
template <class Graph>
  requires requires { typename Graph::stage_input; }
struct stage_interface<Graph> {
  using inputs = stage_ports<typename Graph::stage_input>;
  using outputs = stage_ports<typename Graph::stage_output>;
};

template <class Type>
using input_of_stage = typename stage_interface<Type>::inputs::first;
template <class Type>
using output_of_stage = typename stage_interface<Type>::outputs::first;
template <class Type> concept OneInOneOut =
    stage_interface<Type>::inputs::count == 1 && stage_interface<Type>::outputs::count == 1;

// The strategy of a stage: fire with each sample. A graph takes none, its nodes have their own.
template <class Type>
struct fires_with_input {
  using type = port_triggered<input_of_stage<Type>::name>;
};
template <Graph Type>
struct fires_with_input<Type> {
  using type = by_default;
};

// "... fuse has 2 inputs that must be wired and 1 output ..."
template <class Type>
constexpr void put_stage_ports(text& t) {
  using all = stage_interface<Type>;
  t << type_name<Type>();
  if constexpr (Graph<Type>) {
    t << " is a graph, but the only graphs that can stand here are pipelines and farms";
  } else {
    t << " has " << all::inputs::count << (all::inputs::count == 1 ? " input" : " inputs")
      << " that must be wired and " << all::outputs::count
      << (all::outputs::count == 1 ? " output" : " outputs")
      << " (of a status none counts), but it takes what has one of each: make the other inputs "
         "cca::optional_in, or wire it by hand";
  }
}

}  // namespace cca::detail
