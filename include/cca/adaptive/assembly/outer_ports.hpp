// How the ports of inner nodes become ports of the adaptive component: directly, or through a mapping.
#pragma once

#include <cca/adaptive/assembly/adaptive_options.hpp>
#include <cca/adaptive/assembly/named_ports.hpp>

namespace cca::detail {

// Inner end of a mapping on a port: what it takes and what it gives.
template <class Mapping>
inline constexpr auto taken_by = port_facts<typename mapped_inputs<Mapping>::first>::name;
template <class Mapping>
inline constexpr auto given_by = port_facts<typename mapped_outputs<Mapping>::first>::name;

// "ball" makes "through_ball", the node of the mapping on that port.
template <std::size_t Size>
consteval auto node_through(const fixed_string<Size>& port) {
  constexpr std::string_view before = "through_";
  char text[Size + 8]{};
  for (std::size_t i = 0; i < 8; ++i) text[i] = before[i];
  for (std::size_t i = 0; i < Size; ++i) text[8 + i] = port.text[i];
  return fixed_string<Size + 8>(text);
}
template <fixed_string Port>
inline constexpr auto through = node_through(Port);

// An outer input that feeds ports of inner nodes, with or without a mapping; an inner output that is shown.
template <class Mapping, fixed_string Outer, fixed_string... Inner>
struct fed {
  using type = list<node<through<Outer>, Mapping>,
                    expose<path_to<through<Outer>, taken_by<Mapping>>, Outer>,
                    wire<path_to<through<Outer>, given_by<Mapping>>, Inner, latest>...>;
};
template <fixed_string Outer, fixed_string... Inner>
struct fed<void, Outer, Inner...> {
  using type = list<expose<Inner, Outer>...>;
};

template <class Mapping, fixed_string Inner, fixed_string Outer>
struct given {
  using type = list<node<through<Outer>, Mapping>,
                    wire<Inner, path_to<through<Outer>, taken_by<Mapping>>, latest>,
                    expose<path_to<through<Outer>, given_by<Mapping>>, Outer>>;
};
template <fixed_string Inner, fixed_string Outer>
struct given<void, Inner, Outer> {
  using type = list<expose<Inner, Outer>>;
};

// Each port of a node that has none of the roles, under its own name.
template <fixed_string... Names>
struct roles {};
template <fixed_string Node, class Port, class Roles, class... Options>
struct port_shown {
  using type = list<>;
};
template <fixed_string Node, NamedPort Port, fixed_string... Roles, class... Options>
  requires((Port::name != Roles.view()) && ...)
struct port_shown<Node, Port, roles<Roles...>, Options...>
    : fed<typename control_among<port_facts<Port>::name, Options...>::type,
          port_facts<Port>::name,
          path_to<Node, port_facts<Port>::name>> {};

template <fixed_string Node, class Ports, class Roles, class... Options>
struct shown_ports;
template <fixed_string Node, class... Ports, class Roles, class... Options>
struct shown_ports<Node, list<Ports...>, Roles, Options...>
    : joined<list<>, typename port_shown<Node, Ports, Roles, Options...>::type...> {};

}  // namespace cca::detail
