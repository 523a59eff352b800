// The items (nodes, wires, exposed ports) of an adaptive component, from the signatures of its module and its
// criterion.
#pragma once

#include <cca/adaptive/assembly/adaptive_checks.hpp>
#include <cca/adaptive/component_status.hpp>

namespace cca::detail {

template <class Module, class Strategy>
struct module_node {
  using type = node<"module", Module, Strategy>;
};
template <Graph Module, class Strategy>
struct module_node<Module, Strategy> {
  using type = node<"module", Module>;
};

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

}  // namespace cca::detail
