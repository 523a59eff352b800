// What an adaptive component is made of: its items, from the signatures of its parts.
#pragma once

#include <cca/adaptive/adaptive_options.hpp>
#include <cca/adaptive/component_status.hpp>
#include <cca/component/mapped_ports.hpp>
#include <cca/graph/graph.hpp>

namespace cca {
namespace detail {

template <class List>
struct graph_from;
template <class... Items>
struct graph_from<list<Items...>> : graph<Items...> {};

template <class... Lists>
struct joined;
template <class... A>
struct joined<list<A...>> {
  using type = list<A...>;
};
template <class... A, class... B, class... Rest>
struct joined<list<A...>, list<B...>, Rest...> : joined<list<A..., B...>, Rest...> {};

// "module" and "goal" make "module.goal".
template <std::size_t A, std::size_t B>
consteval auto with_dot(const fixed_string<A>& node, const fixed_string<B>& port) {
  char text[A + B]{};
  for (std::size_t i = 0; i + 1 < A; ++i) text[i] = node.text[i];
  text[A - 1] = '.';
  for (std::size_t i = 0; i < B; ++i) text[A + i] = port.text[i];
  return fixed_string<A + B>(text);
}
template <fixed_string Node, fixed_string Port>
inline constexpr auto path_to = with_dot(Node, Port);

// A port's name as a template argument, and its space.
template <class Port>
struct port_facts;
template <template <fixed_string, class> class Kind, fixed_string Name, class Of>
struct port_facts<Kind<Name, Of>> {
  static constexpr auto name = Name;
  using space = Of;
};
template <class Type> concept NamedPort = requires { port_facts<Type>::name; };

// All ports of a component, or what a graph shows.
template <fixed_string Name, class Space>
struct exposed_port {
  static constexpr std::string_view name = Name.view();
};
template <class Item>
struct exposed_by {
  using type = list<>;
};
template <fixed_string Inner, fixed_string Outer>
struct exposed_by<expose<Inner, Outer>> {
  using type = list<exposed_port<Outer, void>>;
};

template <class Component>
struct ports_in {
  using type = typename joined<typename process_facts<Component>::parameters,
                               typename process_facts<Component>::results>::type;
};
// Each name once: an input may feed several ports, an input and an output may have one name.
template <class Done, class Rest>
struct once_each {
  using type = Done;
};
template <class... Done, class First, class... Rest>
struct once_each<list<Done...>, list<First, Rest...>>
    : once_each<std::conditional_t<((Done::name == First::name) || ...), list<Done...>, list<Done..., First>>,
                list<Rest...>> {};
template <class Items>
struct ports_shown;
template <class... Items>
struct ports_shown<list<Items...>>
    : once_each<list<>, typename joined<list<>, typename exposed_by<Items>::type...>::type> {};
template <Graph Component>
struct ports_in<Component> : ports_shown<typename Component::cca_items> {};

// Whether there is a port of that name, and its space; void where a graph only shows it.
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

template <bool Chosen, class List>
using if_chosen = std::conditional_t<Chosen, List, list<>>;

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

template <class Module, class Strategy>
struct module_node {
  using type = node<"module", Module, Strategy>;
};
template <Graph Module, class Strategy>
struct module_node<Module, Strategy> {
  using type = node<"module", Module>;
};

// One that isn't known is left to the wires.
template <class Takes, class Given>
constexpr bool comparable = matching<Takes, Given>;
template <class Takes>
constexpr bool comparable<Takes, void> = true;

template <class Mapping>
struct space_given {
  using type = typename mapped_outputs<Mapping>::first::space;
};
template <>
struct space_given<void> {
  using type = void;
};

// Functions whose arguments the compilers name.
template <class Criterions, class Modules, bool Meet = comparable<Criterions, Modules>>
constexpr bool check_target() {
  static_assert(
      Meet,
      "criterion.spaces: the criterion of this adaptive component measures in another space (domain type, "
      "frame, axes or rate) "
      "than that in which its module has the target (the compiler names the two, the criterion's first); use "
      "the criterion over "
      "the module's space, or let it measure against the other target: against<criterion_target::...>");
  return Meet;
}
template <class Criterions, class Mapped, bool Meet = comparable<Criterions, Mapped>>
constexpr bool check_feedback() {
  static_assert(Meet,
                "criterion.spaces: the criterion of this adaptive component measures in another space "
                "(domain type, frame, axes or rate) "
                "than that to which its feedback_through<...> maps (the compiler names the two, the "
                "criterion's first); map the feedback to "
                "the criterion's space");
  return Meet;
}
template <class CriterionsTarget, class ModulesTarget, class CriterionsFeedback, class MappedFeedback>
constexpr bool check_criterion() {
  if constexpr (check_target<CriterionsTarget, ModulesTarget>())
    return check_feedback<CriterionsFeedback, MappedFeedback>();
  else return false;
}

// Stands for a criterion that has been reported.
template <class Target, class Feedback>
struct unmeasured {
  auto process(in<"target", Target>, in<"feedback", Feedback>)
      -> std::tuple<out<"error", criterion_error>, out<"state", criterion_port>> {
    return {};
  }
};

// A control_through<...> names an input that its module or its criterion has besides those of the roles.
template <class Option, class ModulePorts, class ModuleRoles, class CriterionPorts, class CriterionRoles>
constexpr bool names_an_input = true;
template <fixed_string Name, class Ports, class Roles>
constexpr bool has_input = false;
template <fixed_string Name, class Ports, fixed_string... Roles>
constexpr bool has_input<Name, Ports, roles<Roles...>> =
    port_at<Name, Ports>::exists && ((Name.view() != Roles.view()) && ...);
template <fixed_string Name,
          class M,
          class ModulePorts,
          class ModuleRoles,
          class CriterionPorts,
          class CriterionRoles>
constexpr bool
    names_an_input<control_through<Name, M>, ModulePorts, ModuleRoles, CriterionPorts, CriterionRoles> =
        has_input<Name, ModulePorts, ModuleRoles> || has_input<Name, CriterionPorts, CriterionRoles>;

template <bool All>
constexpr bool check_controls() {
  static_assert(All,
                "wire.unknown_port: a control_through<`name`, M> of this adaptive component names no control "
                "input that its module or its "
                "criterion has; reference, feedback and command have options of their own: "
                "reference_through<M>, feedback_through<M>, "
                "command_through<M>");
  return true;
}

template <class Module, class Measure, class Names, class... Options>
struct adaptive_items_of;
template <class Module,
          class Measure,
          fixed_string Reference,
          fixed_string Command,
          fixed_string OdeStatus,
          class... Options>
struct adaptive_items_of<Module, Measure, named<Reference, Command, OdeStatus>, Options...> {
  using module_ports = typename ports_in<Module>::type;
  using criterion_ports = typename ports_in<Measure>::type;
  using strategy = typename strategy_among<Options...>::type;
  using on_reference = typename mapping_among<reference_through, Options...>::type;
  using on_feedback = typename mapping_among<feedback_through, Options...>::type;
  using on_command = typename mapping_among<command_through, Options...>::type;
  static constexpr bool to_reference =
      target_among<Measure::compares, Options...> == criterion_target::reference;
  static constexpr bool follows = port_at<Reference, module_ports>::exists,
                        feels = port_at<"feedback", module_ports>::exists,
                        learns = port_at<"module", module_ports>::exists;

  using target = typename port_at<"target", criterion_ports>::space;
  using feedback = typename port_at<"feedback", criterion_ports>::space;
  using in_module = typename std::
      conditional_t<to_reference, port_at<Reference, module_ports>, port_at<Command, module_ports>>::space;
  using module_roles = roles<Reference, Command, OdeStatus, "module", "feedback">;
  using criterion_roles = roles<"target", "feedback", "error", "state">;
  static constexpr bool measured =
      check_controls<(names_an_input<Options, module_ports, module_roles, criterion_ports, criterion_roles> &&
                      ...)>() &&
      check_criterion<target, in_module, feedback, typename space_given<on_feedback>::type>();
  using stand_in = unmeasured<
      std::conditional_t<std::is_void_v<in_module>, target, in_module>,
      std::conditional_t<std::is_void_v<on_feedback>, feedback, typename space_given<on_feedback>::type>>;

  static constexpr auto module_reference = path_to<"module", Reference>;
  static constexpr auto module_command = path_to<"module", Command>;
  static constexpr auto module_feedback = path_to<"module", "feedback">;
  static constexpr auto measured_target = path_to<"criterion", "target">;
  static constexpr auto measured_feedback = path_to<"criterion", "feedback">;
  using reference_items = typename std::conditional_t<
      follows && to_reference,
      fed<on_reference, "reference", module_reference, measured_target>,
      std::conditional_t<follows,
                         fed<on_reference, "reference", module_reference>,
                         std::conditional_t<to_reference,
                                            fed<on_reference, "reference", measured_target>,
                                            joined<list<>>>>>::type;
  using feedback_items =
      typename std::conditional_t<feels,
                                  fed<on_feedback, "feedback", measured_feedback, module_feedback>,
                                  fed<on_feedback, "feedback", measured_feedback>>::type;

  using type = typename joined<
      list<typename module_node<Module, strategy>::type,
           node<"criterion", std::conditional_t<measured, Measure, stand_in>, strategy>,
           node<"status", status_of_component<Measure::at_rest>, strategy>,
           wire<path_to<"module", OdeStatus>, "status.ode", latest>,
           wire<"criterion.state", "status.criterion", latest>,
           expose<"status.ode", "ode_status">,
           expose<"status.module", "module_status">,
           expose<"status.component", "component_status">,
           expose<"criterion.error", "error">>,
      if_chosen<learns, list<wire<"module.module", "status.module", latest>>>,
      if_chosen<!to_reference, list<wire<module_command, "criterion.target", latest>>>,
      reference_items,
      feedback_items,
      typename given<on_command, module_command, "command">::type,
      typename shown_ports<"module", module_ports, module_roles, Options...>::type,
      if_chosen<measured,
                typename shown_ports<"criterion", criterion_ports, criterion_roles, Options...>::type>>::type;
};

template <class Module, class Measure, class... Options>
struct adaptive_items {
  static_assert(sizeof(Module) != 0);  // first of all: what is wrong with the module is reported from here
  static_assert((ComponentOption<Options> && ...),
                "cca::adaptive_component: one of its options is none: a strategy, named<...>, against<...>, "
                "reference_through<M>, "
                "feedback_through<M>, command_through<M> or control_through<`name`, M>");
  using type =
      typename adaptive_items_of<Module, Measure, typename names_among<Options...>::type, Options...>::type;
};

}  // namespace detail
}  // namespace cca
