// What goes through a component or a graph: the one input that must be wired, and the one output that is no
// status. Skeletons find by them where to put it.
//
// Of a component these are ports of `process`; an input that need not be wired does not count. Of graphs only
// pipelines and farms say what goes through them.
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/component/component.hpp>
#include <cca/graph/graph.hpp>
#include <cca/base/text.hpp>
#include <cca/space/domain.hpp>
#include <cca/base/joined_names.hpp>

namespace cca::detail {

// A port under the name by which it is wired.
template <fixed_string Name, class Space>
struct passage {
  static constexpr auto name = Name;
  using space = Space;
};

template <class Port>
struct passage_of {
  using type = void;
};
template <fixed_string Name, class Space>
struct passage_of<in<Name, Space>> {
  using type = passage<Name, Space>;
};
template <fixed_string Name, class Space>
struct passage_of<out<Name, Space>> {
  using type = std::conditional_t<std::is_same_v<typename Space::domain, status>, void, passage<Name, Space>>;
};
template <fixed_string Name, class Space>
struct passage_of<maybe<Name, Space>> : passage_of<out<Name, Space>> {};

// Those of a list that are some.
template <class... Passages>
struct passages {
  static constexpr int count = (!std::is_void_v<Passages> + ... + 0);
  using first = std::tuple_element_t<
      0,
      decltype(std::tuple_cat(
          std::declval<std::conditional_t<std::is_void_v<Passages>, std::tuple<>, std::tuple<Passages>>>()...,
          std::tuple<void*>()))>;
};
template <class List>
struct passages_in;
template <class... Ports>
struct passages_in<list<Ports...>> : passages<typename passage_of<Ports>::type...> {};

template <class Type>
struct passage_through {
  using inputs = passages<>;
  using outputs = passages<>;
};
template <HasProcess Component>
struct passage_through<Component> {
  using facts = function_facts<decltype(&Component::process)>;
  using inputs = passages_in<typename facts::parameters>;
  using outputs = passages_in<typename facts::results>;
};
// A skeleton that is a graph says it itself.
template <class Graph>
  requires requires { typename Graph::passage_in; }
struct passage_through<Graph> {
  using inputs = passages<typename Graph::passage_in>;
  using outputs = passages<typename Graph::passage_out>;
};

template <class Type>
using input_of_stage = typename passage_through<Type>::inputs::first;
template <class Type>
using output_of_stage = typename passage_through<Type>::outputs::first;
template <class Type> concept GoesThrough =
    passage_through<Type>::inputs::count == 1 && passage_through<Type>::outputs::count == 1;

// Its node fires with each sample. A graph takes no strategy: its nodes have theirs.
template <class Type>
struct fires_with_input {
  using type = port_triggered<input_of_stage<Type>::name>;
};
template <Graph Type>
struct fires_with_input<Type> {
  using type = by_default;
};

// `stage1` is a `fuse`, which has 2 inputs that must be wired and 1 output ...
template <class Type>
constexpr void say_passages(text& t) {
  using all = passage_through<Type>;
  t << type_name<Type>();
  if constexpr (Graph<Type>) {
    t << " is a graph, of which is not known what goes through: of graphs it takes pipelines and farms";
  } else {
    t << " has " << all::inputs::count << (all::inputs::count == 1 ? " input" : " inputs")
      << " that must be wired and " << all::outputs::count
      << (all::outputs::count == 1 ? " output" : " outputs")
      << " (of a status none counts), but it takes what has one of each: make the others cca::optional_in, "
         "or wire it by hand";
  }
}

}  // namespace cca::detail
