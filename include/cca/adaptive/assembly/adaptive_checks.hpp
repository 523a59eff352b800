// Compile-time checks of an adaptive component: its criterion measures in the spaces of its module, and each
// control_through<...> names an existing input. Errors: criterion.spaces, wire.unknown_port.
#pragma once

#include <cca/adaptive/assembly/outer_ports.hpp>
#include <cca/adaptive/criterion.hpp>

namespace cca::detail {

// An unknown space (void) is not checked here: the wires check it.
template <class Takes, class Given>
constexpr bool may_match = matching<Takes, Given>;
template <class Takes>
constexpr bool may_match<Takes, void> = true;

// The space that a mapping gives; void without a mapping.
template <class Mapping>
struct mapped_space {
  using type = typename mapped_outputs<Mapping>::first::space;
};
template <>
struct mapped_space<void> {
  using type = void;
};

// Functions, because compilers print their template arguments: the two spaces.
template <class CriterionSpace, class ModuleSpace, bool Match = may_match<CriterionSpace, ModuleSpace>>
constexpr bool check_target() {
  static_assert(
      Match,
      "criterion.spaces: the criterion of this adaptive component measures in another space (domain type, "
      "frame, axes or rate) than the target of its module (the compiler prints both spaces, the criterion's "
      "first); use the criterion over the module's space, or compare with the other target: "
      "against<criterion_target::...>");
  return Match;
}
template <class CriterionSpace, class Mapped, bool Match = may_match<CriterionSpace, Mapped>>
constexpr bool check_feedback() {
  static_assert(Match,
                "criterion.spaces: the criterion of this adaptive component measures in another space "
                "(domain type, frame, axes or rate) than that to which its feedback_through<...> maps (the "
                "compiler prints both spaces, the criterion's first); map the feedback to the criterion's "
                "space");
  return Match;
}
template <class CriterionTarget, class ModuleTarget, class CriterionFeedback, class MappedFeedback>
constexpr bool check_criterion() {
  if constexpr (check_target<CriterionTarget, ModuleTarget>())
    return check_feedback<CriterionFeedback, MappedFeedback>();
  else return false;
}

// Replaces a criterion that was refused, so that its mistake causes no further errors.
template <class Target, class Feedback>
struct placeholder_criterion {
  auto process(in<"target", Target>, in<"feedback", Feedback>)
      -> std::tuple<out<"error", criterion_error>, out<"state", criterion_port>> {
    return {};
  }
};

// Whether a control_through<...> names an input of the module or the criterion that has no role.
template <class Option, class ModulePorts, class ModuleRoles, class CriterionPorts, class CriterionRoles>
constexpr bool control_exists = true;
template <fixed_string Name, class Ports, class Roles>
constexpr bool has_control_input = false;
template <fixed_string Name, class Ports, fixed_string... Roles>
constexpr bool has_control_input<Name, Ports, roles<Roles...>> =
    port_at<Name, Ports>::exists && ((Name.view() != Roles.view()) && ...);
template <fixed_string Name,
          class M,
          class ModulePorts,
          class ModuleRoles,
          class CriterionPorts,
          class CriterionRoles>
constexpr bool
    control_exists<control_through<Name, M>, ModulePorts, ModuleRoles, CriterionPorts, CriterionRoles> =
        has_control_input<Name, ModulePorts, ModuleRoles> ||
        has_control_input<Name, CriterionPorts, CriterionRoles>;

template <bool All>
constexpr bool check_controls() {
  static_assert(All,
                "wire.unknown_port: a control_through<`name`, M> of this adaptive component names no control "
                "input of its module or its criterion; reference, feedback and command have options of their "
                "own: reference_through<M>, feedback_through<M>, command_through<M>");
  return true;
}

}  // namespace cca::detail
