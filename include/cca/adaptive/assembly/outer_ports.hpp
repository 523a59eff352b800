// How ports of inner nodes become ports of the adaptive component: directly, or through a mapping.
#pragma once

#include <cca/adaptive/assembly/adaptive_options.hpp>
#include <cca/adaptive/assembly/named_ports.hpp>

namespace cca::detail {

// The names of the input and the output of a mapping.
template <class Mapping>
inline constexpr auto input_name_of = port_facts<typename mapped_inputs<Mapping>::first>::name;
template <class Mapping>
inline constexpr auto output_name_of = port_facts<typename mapped_outputs<Mapping>::first>::name;

// mapping_node<"ball"> is "through_ball", the node of the mapping on the port "ball".
template <std::size_t Size>
consteval auto mapping_node_name(const fixed_string<Size>& port) {
  constexpr std::string_view before = "through_";
  char text[Size + 8]{};
  for (std::size_t i = 0; i < 8; ++i) text[i] = before[i];
  for (std::size_t i = 0; i < Size; ++i) text[8 + i] = port.text[i];
  return fixed_string<Size + 8>(text);
}
template <fixed_string Port>
inline constexpr auto mapping_node = mapping_node_name(Port);

// The items for an outer input that feeds inner ports, and for an inner output, with or without a mapping.
template <class Policies, class Mapping, fixed_string Outer, fixed_string... Inner>
struct input_items {
  using type = list<node<mapping_node<Outer>, Mapping>,
                    expose<path_to<mapping_node<Outer>, input_name_of<Mapping>>, Outer>,
                    wire_inside<path_to<mapping_node<Outer>, output_name_of<Mapping>>, Inner, Policies>...>;
};
template <class Policies, fixed_string Outer, fixed_string... Inner>
struct input_items<Policies, void, Outer, Inner...> {
  using type = list<expose<Inner, Outer>...>;
};

template <class Policies, class Mapping, fixed_string Inner, fixed_string Outer>
struct output_items {
  using type = list<node<mapping_node<Outer>, Mapping>,
                    wire_inside<Inner, path_to<mapping_node<Outer>, input_name_of<Mapping>>, Policies>,
                    expose<path_to<mapping_node<Outer>, output_name_of<Mapping>>, Outer>>;
};
template <class Policies, fixed_string Inner, fixed_string Outer>
struct output_items<Policies, void, Inner, Outer> {
  using type = list<expose<Inner, Outer>>;
};

// The items that expose the ports of a node without a role, under their own names.
template <fixed_string... Names>
struct roles {};
template <fixed_string Node, class Port, class Roles, class... Options>
struct other_port_items {
  using type = list<>;
};
template <fixed_string Node, NamedPort Port, fixed_string... Roles, class... Options>
  requires((Port::name != Roles.view()) && ...)
struct other_port_items<Node, Port, roles<Roles...>, Options...>
    : input_items<typename inner_policies<list<latest>, Options...>::type,
                  typename control_option<port_facts<Port>::name, Options...>::type,
                  port_facts<Port>::name,
                  path_to<Node, port_facts<Port>::name>> {};

template <fixed_string Node, class Ports, class Roles, class... Options>
struct other_ports_items;
template <fixed_string Node, class... Ports, class Roles, class... Options>
struct other_ports_items<Node, list<Ports...>, Roles, Options...>
    : joined<list<>, typename other_port_items<Node, Ports, Roles, Options...>::type...> {};

}  // namespace cca::detail
