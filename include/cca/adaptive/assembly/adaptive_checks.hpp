// What the compiler checks about an adaptive component: its criterion measures in the spaces of its module,
// and each control_through<...> names an input. Errors: criterion.spaces, wire.unknown_port.
#pragma once

#include <cca/adaptive/assembly/outer_ports.hpp>
#include <cca/adaptive/criterion.hpp>

namespace cca::detail {

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

}  // namespace cca::detail
