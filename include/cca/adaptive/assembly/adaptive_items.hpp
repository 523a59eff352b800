// The graph items (nodes, wires, exposed ports) of an adaptive component, from the signatures of its module
// and its criterion.
#pragma once

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/adaptive/assembly/adaptive_checks.hpp>
#include <cca/adaptive/component_status.hpp>

namespace cca::detail {

// A strategy stands on components only, so a module that is a graph gets none.
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
  using strategy = typename strategy_option<Options...>::type;
  using policies = typename inner_policies<list<latest>, Options...>::type;
  using on_reference = typename mapping_option<reference_through, Options...>::type;
  using on_feedback = typename mapping_option<feedback_through, Options...>::type;
  using on_command = typename mapping_option<command_through, Options...>::type;
  static constexpr bool measures_reference =
      target_option<Measure::compares, Options...> == criterion_target::reference;
  static constexpr bool has_reference = port_at<Reference, module_ports>::exists,
                        has_feedback = port_at<"feedback", module_ports>::exists,
                        has_module_status = port_at<"module", module_ports>::exists;

  using target = typename port_at<"target", criterion_ports>::space;
  using feedback = typename port_at<"feedback", criterion_ports>::space;
  using module_target = typename std::conditional_t<measures_reference,
                                                    port_at<Reference, module_ports>,
                                                    port_at<Command, module_ports>>::space;
  using module_roles = roles<Reference, Command, OdeStatus, "module", "feedback">;
  using criterion_roles = roles<"target", "feedback", "error", "state">;
  static constexpr bool sound =
      check_controls<
          asked_controls<module_ports, module_roles, criterion_ports, criterion_roles, Options...>>() &&
      check_criterion<target, module_target, feedback, typename mapped_space<on_feedback>::type>();
  using placeholder = placeholder_criterion<
      std::conditional_t<std::is_void_v<module_target>, target, module_target>,
      std::conditional_t<std::is_void_v<on_feedback>, feedback, typename mapped_space<on_feedback>::type>>;

  static constexpr auto module_reference = path_to<"module", Reference>;
  static constexpr auto module_command = path_to<"module", Command>;
  static constexpr auto module_feedback = path_to<"module", "feedback">;
  static constexpr auto measured_target = path_to<"criterion", "target">;
  static constexpr auto measured_feedback = path_to<"criterion", "feedback">;
  using reference_items = typename std::conditional_t<
      has_reference && measures_reference,
      input_items<policies, on_reference, "reference", module_reference, measured_target>,
      std::conditional_t<has_reference,
                         input_items<policies, on_reference, "reference", module_reference>,
                         std::conditional_t<measures_reference,
                                            input_items<policies, on_reference, "reference", measured_target>,
                                            joined<list<>>>>>::type;
  using feedback_items = typename std::conditional_t<
      has_feedback,
      input_items<policies, on_feedback, "feedback", measured_feedback, module_feedback>,
      input_items<policies, on_feedback, "feedback", measured_feedback>>::type;

  using type = typename joined<
      list<typename module_node<Module, strategy>::type,
           node<"criterion", std::conditional_t<sound, Measure, placeholder>, strategy>,
           node<"status", status_of_component<Measure::at_rest>, strategy>,
           wire_inside<path_to<"module", OdeStatus>, "status.ode", policies>,
           wire_inside<"criterion.state", "status.criterion", policies>,
           expose<"status.ode", "ode_status">,
           expose<"status.module", "module_status">,
           expose<"status.component", "component_status">,
           expose<"criterion.error", "error">>,
      items_if<has_module_status, list<wire_inside<"module.module", "status.module", policies>>>,
      items_if<!measures_reference, list<wire_inside<module_command, "criterion.target", policies>>>,
      reference_items,
      feedback_items,
      typename output_items<policies, on_command, module_command, "command">::type,
      typename other_ports_items<"module", module_ports, module_roles, Options...>::type,
      items_if<sound,
               typename other_ports_items<"criterion", criterion_ports, criterion_roles, Options...>::type>>::
      type;
};

template <class Module, class... Options>
struct unknown_component_option {
  static constexpr void tell(text& m) {
    m << "cca::adaptive_component: ";
    const char* between = "`";
    const auto one = [&](bool known, std::string_view name) {
      if (!known) m << between << name << "`", between = ", `";
    };
    (one(ComponentOption<Options>, type_name<Options>()), ...);
    m << " is no option of the adaptive component of " << type_name<Module>()
      << "; allowed are a strategy, named<...>, against<...>, inner_wires<policies...>, "
         "reference_through<M>, "
         "feedback_through<M>, command_through<M> and control_through<`name`, M>";
  }
};

template <class Module, class Measure, class... Options>
struct adaptive_items {
  static_assert(sizeof(Module) != 0);  // first, so that the mistakes of the module are reported from here
  static_assert(
      holds_or_tells<(ComponentOption<Options> && ...), unknown_component_option<Module, Options...>>::value);
  using type =
      typename adaptive_items_of<Module, Measure, typename names_option<Options...>::type, Options...>::type;
};

}  // namespace cca::detail
